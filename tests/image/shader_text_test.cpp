// The programs that scenes are drawn with: what is in them, and how many there are.
#include <algorithm>
#include <array>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "image/analytic_mesh.h"
#include "image/lit_scene.h"
#include "render/shading/shader_lights.h"
#include "render/shading/surface_shader.h"

namespace saddle {
namespace {

/// Everything of the shader that one directional light and one dull material have no use for.
TEST(ShaderText, HoldsNoMoreThanOneDirectionalLightNeeds) {
  Scene scene;
  scene.surfaces.resize(1);
  scene.surfaces[0].front = scene.surfaces[0].back = {{1, 1, 1}, {0, 0, 0}, 32};
  scene.lights = {{.position = {0, 0, 1}, .directional = true, .color = {1, 1, 1}},
                  {.position = {0, 0, 0}, .color = {0, 0, 0}},
                  {.position = {0, 0, 0}, .color = {1, 1, 1}, .enabled = 0}};
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  const std::string text = render(scene, std::span(&mesh, 1), {8, 8, 1}).shaders;
  EXPECT_NE(text.find("directional_light(0);"), std::string::npos) << text;
  for (const char* absent :
       {"for (",     "while (", "spot",  "cone",          "attenuation", "strength",    "specular",
        "shininess", "pow",     "back_", "ambient",       "emission",    "point_light", "#if",
        "#define",   "[3]",     "(1)",   "normal_to_eye", "highlight",   "\n\n\n"}) {
    EXPECT_EQ(text.find(absent), std::string::npos) << absent << " in\n" << text;
  }
}

TEST(ShaderText, NamesWhatTheSceneHas) {
  Scene scene;
  scene.surfaces.resize(1);
  scene.lights = three_lights();
  scene.lights[0].spot = cone(20);
  scene.lights[0].attenuation.linear = 1;
  scene.nodes = {{"wide", "", {{Transform::Kind::Scale, dvec3(2, 1, 1), 0}}}};
  scene.surfaces[0].in = {"wide"};
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  const std::string text = render(scene, std::span(&mesh, 1), {8, 8, 1}).shaders;
  for (const char* present :
       {"directional_light(0);", "directional_light(1);", "spot_light(2);", "light_position[3]",
        "attenuation", "front_specular", "back_diffuse", "normal_to_eye"}) {
    EXPECT_NE(text.find(present), std::string::npos) << present << " in\n" << text;
  }
  EXPECT_EQ(text.find("smooth_spot_light"), std::string::npos);
}

/// Off by less than a float can tell, and by enough to need the general program.
TEST(ShaderText, HasNoHueAndNoWayToTheEyeTwiceWhereOneIsEnough) {
  const Mesh mesh = closed_sphere_mesh();
  Scene scene;
  scene.surfaces.resize(1);
  const Rendering plain = render(scene, std::span(&mesh, 1), {64, 64, 2});
  EXPECT_NE(plain.shaders.find("uniform float light_color[3]"), std::string::npos);
  EXPECT_NE(plain.shaders.find("light_at_eye("), std::string::npos);
  scene.lights[0].position.z = 1e-30;
  scene.lights[1].color.r = scene.lights[1].color.r + 1e-12;
  const Rendering general = render(scene, std::span(&mesh, 1), {64, 64, 2});
  EXPECT_NE(general.shaders.find("uniform vec3 light_color[3]"), std::string::npos);
  EXPECT_NE(general.shaders.find("point_light("), std::string::npos);
  EXPECT_EQ(general.image.rgba, plain.image.rgba);
  scene = Scene();
  scene.surfaces.resize(1);
  scene.camera.ortho = true;  // where the way to the eye is the same everywhere
  const Rendering ortho = render(scene, std::span(&mesh, 1), {8, 8, 1});
  EXPECT_NE(ortho.shaders.find("point_light("), std::string::npos);
}

TEST(ShaderText, TurnsManyLightsOfAKindIntoALoop) {
  ShaderNeeds needs;
  const auto point =
      std::ranges::find(light_kinds(), std::string("point_light"), &LightKind::function);
  needs.lights.assign(20, &*point);
  const ShaderText text = assemble_surface_shader(needs);
  EXPECT_NE(text.fragment.find("for (int i = 0; i < 20; ++i)  point_light(i);"), std::string::npos);
}

TEST(ShaderText, HasNoBackWhereNobodyCanSeeIt) {
  Scene scene = lit_scene(5);
  const Mesh mesh = closed_sphere_mesh();
  const auto text = [&] { return render(scene, std::span(&mesh, 1), {8, 8, 1}).shaders; };
  EXPECT_EQ(text().find("gl_FrontFacing"), std::string::npos);
  EXPECT_EQ(text().find("back_diffuse"), std::string::npos);
  scene.camera.distance = 0.5;  // from inside
  EXPECT_NE(text().find("back_diffuse"), std::string::npos);
}

TEST(Programs, AreMadeOnceForAllThatLooksAlike) {
  Scene scene;
  scene.surfaces.resize(3);
  for (SurfaceSpec& spec : scene.surfaces) spec.back = spec.front;
  scene.surfaces[2].front.specular = scene.surfaces[2].back.specular = {};
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  const std::array meshes{mesh, mesh, mesh};
  const std::string text = render(scene, meshes, {8, 8, 1}).shaders;
  std::size_t programs = 0;
  for (std::size_t at = 0; (at = text.find("out vec4 pixel", at)) != std::string::npos; ++at) {
    ++programs;
  }
  EXPECT_EQ(programs, 2U);
}

}  // namespace
}  // namespace saddle
