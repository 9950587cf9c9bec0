// The table of kinds of light: each light has one kind, each kind a function of the shader; and the
// table of ranges.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "render/shading/shader_lights.h"
#include "render/shading/shaders.h"
#include "scene/model/camera.h"

namespace saddle {
namespace {

/// Lights of every sort, at the eye and elsewhere.
std::vector<Light> many_lights() {
  std::vector<Light> lights;
  for (const bool directional : {false, true}) {
    for (const dvec3 position : {dvec3(0), dvec3(1, 2, 3)}) {
      for (const double linear : {0.0, 0.5}) {
        Light light{.position = position, .directional = directional, .color = {1, 1, 1}};
        light.attenuation.linear = linear;
        lights.push_back(light);
        for (const auto falloff : {Spot::Falloff::Linear, Spot::Falloff::Smooth}) {
          light.spot = Spot{.inner = {}, .falloff = falloff};
          lights.push_back(light);
          light.spot->inner = 10;
          lights.push_back(light);
        }
      }
    }
  }
  return lights;
}

/// Names of the kinds that a light has.
std::vector<std::string> kinds_of(const Light& light, bool perspective) {
  ShaderLight uniforms;
  uniforms.position = light.position;
  uniforms.attenuation = {light.attenuation.constant, light.attenuation.linear, 0};
  std::vector<std::string> names;
  for (const LightKind& kind : light_kinds()) {
    if (kind.has(light, uniforms, perspective)) names.emplace_back(kind.name);
  }
  return names;
}

TEST(LightKinds, AreOneForEachLight) {
  std::set<std::string> seen;
  for (const bool perspective : {false, true}) {
    for (const Light& light : many_lights()) {
      const std::vector<std::string> kinds = kinds_of(light, perspective);
      ASSERT_EQ(kinds.size(), 1U) << testing::PrintToString(kinds) << light.directional
                                  << light.spot.has_value() << light.attenuation.linear.value;
      seen.insert(kinds[0]);
    }
  }
  for (const LightKind& kind : light_kinds()) {
    EXPECT_TRUE(seen.contains(kind.name)) << "no light is of kind " << kind.name;
  }
}

TEST(LightKinds, AreFunctionsOfTheShader) {
  const std::string shader(shader_source("lighting.glsl"));
  std::set<std::string> names;
  std::set<std::string> functions;
  for (const LightKind& kind : light_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name << " is there twice";
    EXPECT_TRUE(functions.insert(kind.function).second) << kind.function << " is there twice";
    const std::string text =
        "#ifdef " + std::string(kind.name) + "\nvoid " + kind.function + "(int i) {\n";
    EXPECT_NE(shader.find(text), std::string::npos) << text;
  }
}

/// What the names CONE and ATTENUATION stand around is there only for kinds that ask for it.
TEST(LightKinds, SayWhichUniformsTheyRead) {
  const std::string shader(shader_source("lighting.glsl"));
  for (const LightKind& kind : light_kinds()) {
    const std::size_t begin = shader.find("void " + std::string(kind.function) + "(int i)");
    const std::string body = shader.substr(begin, shader.find("\n}\n", begin) - begin);
    const auto uses = [&](const char* what) { return body.find(what) != std::string::npos; };
    EXPECT_EQ(uses("start_cone(") && uses("spot_direction["), kind.is_cone) << body;
    EXPECT_EQ(uses("attenuation(") || uses("start_cone("), kind.reads_attenuation) << body;
  }
}

TEST(ShaderLights, AreInTheOrderOfTheirKindsAndOfTheScene) {
  Scene scene;
  scene.lights = {{.position = {0, 0, 0}, .color = {0.5, 0, 0}},
                  {.position = {1, 0, 0}, .directional = true, .color = {0.4, 0, 0}},
                  {.position = {0, 0, 0}, .color = {0.3, 0, 0}},
                  {.position = {0, 1, 0}, .directional = true, .color = {0.2, 0, 0}}};
  std::vector<double> reds;
  for (const ShaderLight& light : shader_lights(scene, {}, 1)) reds.push_back(light.color.r);
  EXPECT_EQ(reds, (std::vector<double>{0.4, 0.2, 0.5, 0.3}));
}

TEST(ShaderLights, LeaveOutThoseThatAreOffAndThoseWithoutAnyColour) {
  Scene scene;
  scene.lights = {{.position = {0, 0, 1}, .color = {1, 1, 1}, .enabled = 0},
                  {.position = {0, 0, 2}, .color = {0, 0, 0}},
                  {.position = {0, 0, 3}, .color = {0, 0, 0}, .ambient = {1, 1, 1}},
                  {.position = {0, 0, 4}, .color = {0, 0, 0}, .specular = Color{1, 1, 1}}};
  std::vector<double> heights;
  for (const ShaderLight& light : shader_lights(scene, {}, 1)) heights.push_back(light.position.z);
  EXPECT_EQ(heights, (std::vector<double>{3, 4}));
}

// Source: Ogre3D wiki, "-Point Light Attenuation".
constexpr std::array<dvec3, 12> kRangeRows = {{{7, 0.7, 1.8},
                                               {13, 0.35, 0.44},
                                               {20, 0.22, 0.20},
                                               {32, 0.14, 0.07},
                                               {50, 0.09, 0.032},
                                               {65, 0.07, 0.017},
                                               {100, 0.045, 0.0075},
                                               {160, 0.027, 0.0028},
                                               {200, 0.022, 0.0019},
                                               {325, 0.014, 0.0007},
                                               {600, 0.007, 0.0002},
                                               {3250, 0.0014, 0.000007}}};

TEST(Range, IsTheTableAtItsTwelveRows) {
  for (const dvec3& row : kRangeRows) {
    const dvec3 k = attenuation_of_range(row.x);
    EXPECT_EQ(k.x, 1);
    EXPECT_NEAR(k.y, row.y, 1e-12 * row.y) << row.x;
    EXPECT_NEAR(k.z, row.z, 1e-12 * row.z) << row.x;
  }
}

TEST(Range, LeavesAboutAHundredthOfTheLightWhereItEnds) {
  for (double range = 1; range < 1e5; range *= 1.1) {
    const dvec3 k = attenuation_of_range(range);
    const double left = 1 / (k.x + range * (k.y + range * k.z));
    EXPECT_GT(left, 0.002) << range;
    EXPECT_LT(left, 0.04) << range;
  }
}

TEST(Range, FallsWithTheReachBetweenRows) {
  dvec3 before = attenuation_of_range(1);
  for (double range = 1.1; range < 1e5; range *= 1.1) {
    const dvec3 k = attenuation_of_range(range);
    EXPECT_LT(k.y, before.y) << range;
    EXPECT_LT(k.z, before.z) << range;
    before = k;
  }
}

}  // namespace
}  // namespace saddle
