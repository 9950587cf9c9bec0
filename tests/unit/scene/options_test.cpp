#include "scene/options/options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "scene/model/assignments.h"
#include "scene/options/resolve.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

/// A value for each option of a scene and its surfaces, other than its default.
const std::map<std::string_view, std::string> kSamples = {
    {"view", "1,0,0.5"},
    {"up", "0,1,0"},
    {"target", "1,2,3"},
    {"distance", "7"},
    {"fov", "45"},
    {"zoom", "2"},
    {"ortho", "true"},
    {"turntable", "true"},
    {"title", "Some title"},
    {"theme", "paper"},
    {"scale", "1,2,0.5"},
    {"labels", "a,b,c d"},
    {"line-width", "2.5"},
    {"line-color", "#336699"},
    {"background", "#336699"},
    {"axes", "true"},
    {"size", "320x200"},
    {"antialias", "3"},
    {"shading", "exact"},
    {"specular", "blinn"},
    {"color", "u*v"},
    {"colormap", "magma"},
    {"color-range", "0:2*t+1"},
    {"texture", "checker"},
    {"texture-repeat", "3x2"},
    {"texture-wrap", "mirror"},
    {"texture-filter", "nearest"},
    {"contours", "u*v=0,0.5"},
    {"grid", "8x4"},
    {"front", "#ff8000"},
    {"back", "#008040"},
    {"flip", "true"},
    {"name", "wheel"},
    {"opacity", "0.5"},
    {"line-width", "2.5"},
    {"line-color", "#102030"},
    {"label", "S"},
    {"tolerance", "0.25px"},
    {"normal-tolerance", "5"},
    {"max-triangles", "1000"},
    {"print-size", "80"},
    {"samples", "20x10"},
    {"clip", "-1:1,-2:2,0:5"},
    {"thickness", "(t+1)mm,back"},
    {"t", "0.75"},
    {"fps", "24"},
    {"frames", "10"},
};

Scene plain_scene() {
  Scene scene;
  assign(scene, "z=u*v+t");
  return scene;
}

std::string text_of(const std::vector<Setting>& settings, std::string_view name) {
  const auto found = std::ranges::find_if(
      settings, [&](const Setting& setting) { return setting.option->name == name; });
  return found == settings.end() ? "" : found->text;
}

TEST(Options, EachHaveOneOwnerAndOneNameAndALine) {
  std::set<std::string_view> names;
  std::set<char> letters;
  for (const Option& option : options()) {
    const bool is_of_objects = option.surface || option.stroke;  // an option may be of both
    const int owners = (option.scene ? 1 : 0) + (is_of_objects ? 1 : 0) + (option.curve ? 1 : 0) +
                       (option.point ? 1 : 0) + (option.run ? 1 : 0);
    EXPECT_EQ(owners, 1) << option.name;
    EXPECT_FALSE(option.help.empty()) << option.name;
    EXPECT_EQ(option.table == Table::Surface, option.surface != nullptr) << option.name;
    if (!option.is_option()) {
      EXPECT_NE(option.table, Table::None) << option.name << " is neither an option nor a key";
      continue;
    }
    EXPECT_TRUE(names.insert(option.name).second) << option.name;
    if (option.letter != 0) {
      EXPECT_TRUE(letters.insert(option.letter).second) << option.name;
    }
    for (const std::string_view other : {option.needs, option.excludes}) {
      if (!other.empty()) {
        EXPECT_NE(find_option(other), nullptr) << option.name;
      }
    }
  }
}

TEST(Options, ChangeTheSceneAndAreToldAsTheyWereGiven) {
  for (const Option& option : options()) {
    if (!option.is_option() || !(option.scene || option.surface) || option.name == "angles") {
      continue;
    }
    ASSERT_TRUE(kSamples.contains(option.name)) << option.name << " needs a sample here";
    const std::string& sample = kSamples.at(option.name);
    Scene scene = plain_scene();
    if (option.name.starts_with("color") && option.name != "color") scene.surfaces[0].color = "z";
    EXPECT_EQ(text_of(settings_of(scene), option.name), "") << option.name;
    apply_option(option, sample, scene);
    EXPECT_EQ(text_of(settings_of(scene), option.name), sample) << option.name;
  }
}

TEST(Options, SurviveASceneFile) {
  for (const Option& option : options()) {
    if (!option.is_option() || !(option.scene || option.surface) || option.name == "angles") {
      continue;
    }
    Scene scene = plain_scene();
    if (option.name.starts_with("color") && option.name != "color") scene.surfaces[0].color = "z";
    apply_option(option, kSamples.at(option.name), scene);
    const std::string file = write_scene(scene);
    EXPECT_NE(file, write_scene(plain_scene())) << option.name;
    const Scene back = read_scene({"scene.toml", file});
    EXPECT_EQ(write_scene(back), file) << option.name;
    EXPECT_EQ(text_of(settings_of(back), option.name), kSamples.at(option.name)) << option.name;
  }
}

Vector view_of(const char* option, const std::string& text) {
  Scene scene = plain_scene();
  apply_option(*find_option(option), text, scene);
  return resolve(scene).camera.view;
}

TEST(Options, TakeTheViewByNameOrAngles) {
  EXPECT_EQ(dvec3(view_of("view", "top")), dvec3(0, 0, 1));
  EXPECT_EQ(dvec3(view_of("view", "left")), dvec3(-1, 0, 0));
  EXPECT_THROW(view_of("view", "up"), Error);
  const dvec3 from_y = view_of("angles", "90,30");
  EXPECT_NEAR(glm::distance(from_y, dvec3(0, std::sqrt(0.75), 0.5)), 0, 1e-15);
  const dvec3 by_expression = view_of("angles", "90+0*t,60/2");
  EXPECT_NEAR(glm::distance(from_y, by_expression), 0, 1e-15);
  const Scene file =
      read_scene({"scene.toml", "[camera]\nangles = [90, 30]\n[[surface]]\nz = \"u\"\n"});
  EXPECT_NEAR(glm::distance(dvec3(resolve(file).camera.view), from_y), 0, 1e-15);
  EXPECT_THROW(read_scene({"scene.toml",
                           "[camera]\nview = \"top\"\nangles = [9, 3]\n[[surface]]\nz = \"u\"\n"}),
               Error);
}

TEST(Options, TakeExpressionsOfParametersAndTime) {
  Scene scene = plain_scene();
  apply_option(*find_option("view"), "cos(t),sin(t),1", scene);
  apply_option(*find_option("zoom"), "1+t", scene);
  scene.t = 0.5;
  const Camera camera = resolve(scene).camera;
  EXPECT_EQ(dvec3(camera.view), dvec3(std::cos(0.5), std::sin(0.5), 1));
  EXPECT_EQ(camera.zoom, 1.5);
  EXPECT_THROW(apply_option(*find_option("zoom"), "1+q", scene), Error);
}

TEST(Options, AreForEachSurface) {
  Scene scene = plain_scene();
  scene.surfaces.push_back(scene.surfaces[0]);
  scene.surfaces[1].flip = true;
  apply_option(*find_option("opacity"), "0.25", scene);
  apply_option(*find_option("flip"), "", scene);
  for (const SurfaceSpec& spec : scene.surfaces) EXPECT_EQ(spec.opacity, 0.25);
  EXPECT_TRUE(scene.surfaces[0].flip);
  EXPECT_FALSE(scene.surfaces[1].flip);  // it swaps what is there
}

TEST(Options, KeepTheLimitsOfTheirKeys) {
  const std::map<std::string_view, std::string> wrong = {
      {"fov", "180"},      {"distance", "0"}, {"opacity", "1.5"},
      {"antialias", "17"}, {"size", "0x5"},   {"shading", "flat"},
      {"fps", "0"},        {"frames", "0"},   {"normal-tolerance", "181"},
      {"view", "0,0,0"},   {"grid", "1x4"},   {"colormap", "magmma"}};
  for (const auto& [name, text] : wrong) {
    Scene scene = plain_scene();
    try {
      apply_option(*find_option(name), text, scene);
      ADD_FAILURE() << name << " takes " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::Input);
      EXPECT_EQ(error.place().name, "--" + std::string(name));
    }
  }
}

TEST(Options, AreTakenBySomeCommandOrAreKeys) {
  for (const Option& option : options()) {
    EXPECT_EQ(option.commands & ~kAllCommands, 0U) << option.name;
    if (option.is_option()) {
      EXPECT_NE(option.commands & (kGraph | bit(Command::Show)), 0U) << option.name;
    }
  }
}

TEST(Options, TellTheirDefaultsLimitsAndChoices) {
  EXPECT_EQ(default_text(*find_option("size")), "800x600");
  EXPECT_EQ(default_text(*find_option("fov")), "30");
  EXPECT_EQ(default_text(*find_option("shading")), "pixel");
  EXPECT_EQ(default_text(*find_option("axes")), "off");
  EXPECT_EQ(limits_text(*find_option("fov")), "more than 0 and less than 180");
  EXPECT_EQ(limits_text(*find_option("distance")), "more than 0");
  EXPECT_EQ(limits_text(*find_option("antialias")), "1 to 16");
  EXPECT_EQ(limits_text(*find_option("size")), "");
  EXPECT_EQ(choices(*find_option("shading")),
            (std::vector<std::string>{"vertex", "pixel", "exact", "unlit"}));
  EXPECT_FALSE(choices(*find_option("colormap")).empty());
  EXPECT_EQ(find_option("in"), nullptr) << "a key alone is no option";
}

}  // namespace
}  // namespace saddle
