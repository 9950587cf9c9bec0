#include "render/shader_lights.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

/// The lights that the shaders get of a scene with this one alone.
std::size_t lights_with(const Light& light) {
  Scene scene;
  scene.lights = {light};
  const Bounds box{dvec3(-1), dvec3(1)};
  return shader_lights(scene, fit_camera(scene.camera, box, 1), 1).size();
}

TEST(ShaderLights, LeaveOutWhatDoesNotShine) {
  Light light;
  light.color = {0, 0, 0};
  EXPECT_EQ(lights_with(light), 0U);
  light.enabled = 0;
  light.color = {1, 1, 1};
  EXPECT_EQ(lights_with(light), 0U);
  light.enabled = 1;
  EXPECT_EQ(lights_with(light), 1U);
}

TEST(ShaderLights, KeepALightOfOneKindOfColourAlone) {
  Light ambient;
  ambient.color = {0, 0, 0};
  ambient.ambient = {0, 0, 0.5};
  EXPECT_EQ(lights_with(ambient), 1U);
  Light mirrored;
  mirrored.color = {0, 0, 0};
  mirrored.specular = Color{0.5, 0, 0};
  EXPECT_EQ(lights_with(mirrored), 1U);
}

}  // namespace
}  // namespace saddle
