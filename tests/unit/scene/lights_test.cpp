// The table of a light's keys: each is read, written and resolved.
#include "scene/options/lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "base/error.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

/// Of each key a value as it is written that is not its default.
const std::map<std::string, std::string> kValues = {
    {"frame", "\"world\""},
    {"position", "[1, 2, 3]"},
    {"direction", "[1, 2, 3]"},
    {"color", "\"#ff0000\""},
    {"diffuse", "\"#ff0000\""},
    {"specular", "\"#ff0000\""},
    {"ambient", "\"#102030\""},
    {"attenuation", "[1, 2, 3]"},
    {"spot", "{ direction = [0, 0, 1], cutoff = 20 }"},
    {"enabled", "0"}};
const std::map<std::string, std::string> kSpotValues = {{"direction", "[1, 2, 3]"},
                                                        {"cutoff", "40"},
                                                        {"inner", "10"},
                                                        {"exponent", "2"},
                                                        {"falloff", "\"smooth\""}};

/// Of each key with numbers a value with a name in it that is not known.
const std::map<std::string, std::string> kUnknown = {{"position", "[0, 0, \"zzz\"]"},
                                                     {"direction", "[0, 1, \"zzz\"]"},
                                                     {"color", "[0, 0, \"zzz\"]"},
                                                     {"diffuse", "[0, 0, \"zzz\"]"},
                                                     {"specular", "[0, 0, \"zzz\"]"},
                                                     {"ambient", "[0, 0, \"zzz\"]"},
                                                     {"attenuation", "[1, 0, \"zzz\"]"},
                                                     {"spot", "{ cutoff = \"zzz\" }"},
                                                     {"enabled", "\"zzz\""}};
const std::map<std::string, std::string> kSpotUnknown = {{"direction", "[0, 1, \"zzz\"]"},
                                                         {"cutoff", "\"zzz\""},
                                                         {"inner", "\"zzz\""},
                                                         {"exponent", "\"zzz\""}};

const std::set<std::string> kWithoutNumbers = {"frame", "falloff"};

Scene with_light(const std::string& lines) {
  return read_scene({"scene.toml", "[[surface]]\nz = 1\n[[light]]\n" + lines + "\n"});
}

TEST(LightKeys, ComeBackAsTheyWereWritten) {
  for (const std::string& key : light_keys()) {
    ASSERT_TRUE(kValues.contains(key)) << "no value to try " << key << " with";
    const std::string line = key + " = " + kValues.at(key) + "\n";
    EXPECT_NE(write_lights(with_light(line).lights).find("\n" + line), std::string::npos) << line;
  }
  for (const std::string& key : spot_keys()) {
    ASSERT_TRUE(kSpotValues.contains(key)) << "no value to try " << key << " with";
    const std::string pair = key + " = " + kSpotValues.at(key);
    EXPECT_NE(write_lights(with_light("spot = { " + pair + " }").lights).find(pair),
              std::string::npos)
        << pair;
  }
}

std::string light_error(const std::string& lines) {
  try {
    with_light(lines);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(LightKeys, HaveTheirNumbersResolved) {
  for (const std::string& key : light_keys()) {
    if (kWithoutNumbers.contains(key)) continue;
    ASSERT_TRUE(kUnknown.contains(key)) << "no value to try " << key << " with";
    EXPECT_EQ(light_error(key + " = " + kUnknown.at(key)), "unknown name 'zzz'") << key;
  }
  for (const std::string& key : spot_keys()) {
    if (kWithoutNumbers.contains(key)) continue;
    ASSERT_TRUE(kSpotUnknown.contains(key)) << "no value to try " << key << " with";
    EXPECT_EQ(light_error("spot = { " + key + " = " + kSpotUnknown.at(key) + " }"),
              "unknown name 'zzz'")
        << key;
  }
}

TEST(LightKeys, AreThereOnce) {
  for (std::vector<std::string> keys : {light_keys(), spot_keys()}) {
    std::ranges::sort(keys);
    EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end());
  }
}

TEST(LightKeys, MakeOneOfDiffuseAndSpecularBlackWhereItIsLeftOut) {
  const Light diffuse = with_light("diffuse = \"white\"").lights[0];
  EXPECT_EQ(diffuse.color.r, 1);
  EXPECT_EQ(diffuse.specular->r, 0);
  const Light specular = with_light("specular = \"white\"").lights[0];
  EXPECT_EQ(specular.color.r, 0);
  EXPECT_EQ(specular.specular->r, 1);
  const Light both = with_light("specular = \"white\"\ndiffuse = [0.5, 0, 0]").lights[0];
  EXPECT_EQ(both.color.r, 0.5);
  EXPECT_EQ(both.specular->r, 1);
}

/// The inner angle may be the cutoff: a hard edge.
TEST(LightKeys, TakeAnInnerAngleUpToTheCutoff) {
  EXPECT_EQ(light_error("spot = { cutoff = 20, inner = 20 }"), "none");
  EXPECT_EQ(light_error("spot = { cutoff = 20, inner = 20.1 }"),
            "the inner angle is larger than the cutoff");
}

TEST(LightKeys, AreNotWrittenForTheDefaultLights) {
  EXPECT_EQ(write_lights(default_lights()), "");
  EXPECT_NE(write_lights({Light{}}), "");
}

}  // namespace
}  // namespace saddle
