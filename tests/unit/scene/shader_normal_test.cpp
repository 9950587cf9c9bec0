// The GLSL of a surface's normal, and why there may be none.
#include "scene/model/shader_normal.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/model/assignments.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

ShaderNormal normal_of(const std::vector<std::string>& assignments, bool flip = false) {
  Scene scene;
  for (const std::string& text : assignments) assign(scene, text);
  scene.surfaces[0].flip = flip;
  scene = resolve(std::move(scene));
  return shader_normal(scene, scene.surfaces[0]);
}

bool mentions(const ShaderNormal& normal, const std::string& what) {
  return normal.code.find(what) != std::string::npos;
}

TEST(ShaderNormal, IsBothTangentsOfTheFormula) {
  const ShaderNormal normal = normal_of({"z=u*v"});
  EXPECT_EQ(normal.code,
            "r_u.x = 1.0;\nr_u.y = 0.0;\nr_u.z = v;\nr_v.x = 0.0;\nr_v.y = 1.0;\nr_v.z = u;\n");
  EXPECT_FALSE(normal.obstacle);
  EXPECT_TRUE(normal.constants.empty());
}

TEST(ShaderNormal, IsTheSameProgramWhateverParametersAndTimeAre) {
  const ShaderNormal one = normal_of({"z=a*sin(u+t)", "a=2.5", "t=0.25"});
  const ShaderNormal other = normal_of({"z=a*sin(u+t)", "a=-1", "t=3"});
  EXPECT_EQ(one.code, other.code);
  EXPECT_EQ(one.constants.size(), other.constants.size());
  EXPECT_NE(one.constants, other.constants);
  EXPECT_TRUE(mentions(one, "constant[0]"));
}

TEST(ShaderNormal, TurnsWhereTheFrontDoes) {
  EXPECT_FALSE(normal_of({"z=u"}).flip);
  EXPECT_TRUE(normal_of({"z=u"}, true).flip);
  EXPECT_TRUE(normal_of({"z=u", "u=1:-1"}).flip);  // a range that runs backwards
}

TEST(ShaderNormal, NamesWhatStandsInItsWay) {
  const ShaderNormal bessel = normal_of({"z=besselj0(u)"});
  EXPECT_TRUE(bessel.code.empty());
  EXPECT_EQ(bessel.obstacle, "a function in it has no float version");
  std::string sum = "0";
  for (int k = 1; k < 900; ++k) {
    sum += "+sin(" + std::to_string(k) + "*u)*cos(" + std::to_string(k) + "*v)";
  }
  EXPECT_EQ(normal_of({"z=" + sum}).obstacle, "its derivatives are too long for a shader");
}

TEST(ShaderNormal, WritesNumbersIntoTheCodeWhereTheyAreTooMany) {
  std::vector<std::string> assignments = {"z="};
  for (std::size_t k = 0; k <= kMostConstants; ++k) {
    const std::string name = "a" + std::to_string(k);
    assignments[0] += (k > 0 ? "+sin(" : "sin(") + name + "*u)";
    assignments.push_back(name + "=" + std::to_string(k) + ".5");
  }
  const ShaderNormal normal = normal_of(assignments);
  EXPECT_FALSE(normal.obstacle);
  EXPECT_TRUE(normal.constants.empty());
  EXPECT_FALSE(mentions(normal, "constant["));
  EXPECT_TRUE(mentions(normal, "64.5"));
}

TEST(ShaderNormal, SaysWhatIsWrongWithAFormula) {
  EXPECT_THROW(normal_of({"z=foo(u)"}), Error);
}

}  // namespace
}  // namespace saddle
