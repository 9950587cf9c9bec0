// Pixels against the lighting equation in double.
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "image/analytic_mesh.h"
#include "image/lighting_reference.h"
#include "render/picture.h"
#include "render/shaders.h"
#include "render/surface_shader.h"

namespace saddle {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// In 8-bit levels: half a level of rounding; the 256-cell sphere lies up to 7.5e-5 radii inside of
/// the true one, which turns the normal by as many radians and changes a colour by at most
/// 32 * 0.6 * 0.2 + 1.2 = 5 per radian, 0.1 levels; floats and the driver's pow: below 0.05.
constexpr double kTolerance = 0.65;

/// One surface under the three lights, one sample per pixel.
Scene lit_scene(double distance) {
  Scene scene;
  scene.surfaces.resize(1);
  scene.lights = three_lights();
  scene.camera.view = {0, 0, 1};
  scene.camera.up = {0, 1, 0};
  scene.camera.target = dvec3(0);
  scene.camera.distance = distance;
  return scene;
}

Image draw(const Scene& scene, const Mesh& mesh) {
  return render(scene, std::span(&mesh, 1), {kWidth, kHeight, 1}).image;
}

void expect_pixel(const Image& image, int x, int y, const dvec3& color) {
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(image.pixel(x, y)[c], 255 * color[c], kTolerance)
        << "pixel " << x << " " << y << " channel " << c;
  }
  EXPECT_EQ(image.pixel(x, y)[3], 255);
}

/// Compares all pixels on a raster where the sight meets the unit sphere around the target at less
/// than 60 degrees to its normal.
void expect_lit_sphere(const Scene& scene, const Image& image, const Material& material,
                       bool inside) {
  int compared = 0;
  const dvec3 centre(0, 0, -scene.camera.distance.value());
  for (int y = 3; y < kHeight; y += 7) {
    for (int x = 3; x < kWidth; x += 7) {
      const Sight sight = sight_through(scene.camera, kWidth, kHeight, x, y);
      const dvec3 p = meet_sphere(sight, centre, 1, inside);
      const dvec3 n = (inside ? -1.0 : 1.0) * (p - centre);
      if (!(glm::dot(n, -sight.along) > 0.5)) continue;
      const dvec3 v = scene.camera.ortho ? dvec3(0, 0, 1) : -sight.along;
      expect_pixel(image, x, y, lit_color({p, n, v}, material, scene.lights));
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(Lighting, FollowsTheEquationInPerspective) {
  const Scene scene = lit_scene(5);
  expect_lit_sphere(scene, draw(scene, sphere_mesh(dvec3(0), 1, {256, 256, 0})), kFrontMaterial,
                    false);
}

TEST(Lighting, FollowsTheEquationInOrthographicViews) {
  Scene scene = lit_scene(5);
  scene.camera.ortho = true;
  expect_lit_sphere(scene, draw(scene, sphere_mesh(dvec3(0), 1, {256, 256, 0})), kFrontMaterial,
                    false);
}

TEST(Lighting, TheBackHasItsOwnMaterialAndTheOppositeNormal) {
  Scene scene = lit_scene(0.5);  // the eye is inside
  scene.camera.fov = 60;
  expect_lit_sphere(scene, draw(scene, sphere_mesh(dvec3(0), 1, {256, 256, 0})), kBackMaterial,
                    true);
}

TEST(Lighting, OtherWindingAndNormalsSwapTheSides) {
  const Scene scene = lit_scene(5);
  Mesh mesh = sphere_mesh(dvec3(0), 1, {256, 256, 0});
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  for (dvec3& normal : mesh.normal) normal = -normal;
  expect_lit_sphere(scene, draw(scene, mesh), kBackMaterial, false);
}

TEST(Lighting, FollowsTheEquationOnATiltedPlaneFromBothSides) {
  for (double sign : {1.0, -1.0}) {
    Scene scene = lit_scene(4);
    scene.camera.view = {0, sign, sign};
    const Image image = draw(scene, plane_mesh(dvec3(0), 1));
    // Eye axes: y = (0, 1, -1) / sqrt 2 and z = view: the normal that is seen, +-z, in them.
    const dvec3 seen = glm::normalize(dvec3(0, -sign, 1));
    for (int x : {120, 160, 201}) {
      const Sight sight = sight_through(scene.camera, kWidth, kHeight, x, 110);
      const dvec3 p = meet_plane(sight, dvec3(0, 0, -4), seen);
      expect_pixel(image, x, 110,
                   lit_color({p, seen, -sight.along}, sign > 0 ? kFrontMaterial : kBackMaterial,
                             scene.lights));
    }
  }
}

TEST(Lighting, AddsOnlyWhatTheSceneHas) {
  const Mesh mesh = sphere_mesh(dvec3(0), 1, {256, 256, 0});
  for (std::size_t kept = 0; kept < 3; ++kept) {
    Scene scene = lit_scene(5);
    scene.lights = {three_lights()[kept]};
    scene.surfaces[0].front.specular = {};
    scene.surfaces[0].back = scene.surfaces[0].front;
    expect_lit_sphere(scene, draw(scene, mesh), scene.surfaces[0].front, false);
  }
}

TEST(Lighting, IsBlackWithoutLights) {
  Scene scene = lit_scene(5);
  scene.background = {1, 1, 1, 1};
  scene.lights.clear();
  expect_pixel(draw(scene, sphere_mesh(dvec3(0), 1)), kWidth / 2, kHeight / 2, dvec3(0));
}

TEST(Lighting, IsDefinedForAShininessOfZero) {
  Scene scene = lit_scene(5);
  scene.surfaces[0].front.shininess = 0;
  expect_lit_sphere(scene, draw(scene, sphere_mesh(dvec3(0), 1, {256, 256, 0})),
                    scene.surfaces[0].front, false);
}

TEST(Lighting, APointLightOnTheSurfaceLeavesTheOthersAlone) {
  Scene scene = lit_scene(4);
  scene.lights = {{{0, 0, -4}, false, {1, 1, 1, 1}}, {{0, 0, 1}, true, {0.5, 0.5, 0.5, 1}}};
  const Mesh mesh = plane_mesh(dvec3(0), 1);
  // An odd size: the middle pixel's middle is the light's place.
  const Image image = render(scene, std::span(&mesh, 1), {kWidth + 1, kHeight + 1, 1}).image;
  const std::uint8_t* pixel = image.pixel(kWidth / 2, kHeight / 2);
  // The directional light alone: 0.5 * 1 diffuse + 0.5 * 0.2 specular.
  EXPECT_GE(pixel[0], 153 - 1);
}

TEST(Lighting, ALightAtAnExtremeDistanceActsLikeADirection) {
  const Mesh mesh = sphere_mesh(dvec3(0), 1);
  Scene scene = lit_scene(5);
  scene.lights = {{{0, 1e30, 1e30}, false, {0.6, 0.6, 0.6, 1}}};
  const Image point = draw(scene, mesh);
  scene.lights[0].directional = true;
  const Image direction = draw(scene, mesh);
  for (std::size_t i = 0; i < point.rgba.size(); ++i) {
    ASSERT_NEAR(point.rgba[i], direction.rgba[i], 1);
  }
}

TEST(Lighting, PullsANormalThatLeansAwayBackToTheViewersSide) {
  Scene scene = lit_scene(4);
  scene.lights = {{{1, 0, 0}, true, {0.6, 0.6, 0.6, 1}}};
  Mesh mesh = plane_mesh(dvec3(0), 1);
  for (dvec3& n : mesh.normal) n = glm::normalize(dvec3(1, 0, -0.3));  // 107 degrees from the view
  const Image image = draw(scene, mesh);
  const int x = 150;
  const Sight sight = sight_through(scene.camera, kWidth, kHeight, x, 110);
  const dvec3 v = -sight.along;
  dvec3 n = mesh.normal[0];
  n = glm::normalize(n - glm::dot(n, v) * v);
  const dvec3 p = meet_plane(sight, dvec3(0, 0, -4), dvec3(0, 0, 1));
  expect_pixel(image, x, 110, lit_color({p, n, v}, kFrontMaterial, scene.lights));
}

TEST(ShaderText, HoldsNoMoreThanOneDirectionalLightNeeds) {
  Scene scene;
  scene.surfaces.resize(1);
  scene.surfaces[0].front = scene.surfaces[0].back = {{1, 1, 1}, {0, 0, 0}, 32};
  scene.lights = {{{0, 0, 1}, true, {1, 1, 1, 1}}, {{0, 0, 0}, false, {0, 0, 0, 1}}};
  const std::string text = assemble_shader(shader_source("surface.frag.glsl"), shader_needs(scene));
  EXPECT_TRUE(text.starts_with(
      "#version 330 core\n#define LIGHT_COUNT 1\n#define LIGHTS DIRECTIONAL(0)\n#line 2\n"));
  for (const char* absent : {"for (", "while (", "spot", "attenuation"}) {
    EXPECT_EQ(text.find(absent), std::string::npos) << absent;
  }
}

TEST(ShaderText, NamesEveryLightAndWhatItsScenesMaterialsNeed) {
  Scene scene;
  scene.surfaces.resize(1);
  scene.lights = three_lights();
  scene.camera.ortho = true;
  const std::string text = assemble_shader(shader_source("surface.frag.glsl"), shader_needs(scene));
  EXPECT_TRUE(text.starts_with(
      "#version 330 core\n#define LIGHT_COUNT 3\n#define LIGHTS POINT(0) DIRECTIONAL(1) "
      "DIRECTIONAL(2)\n#define SPECULAR\n#define TWO_MATERIALS\n#define ORTHOGRAPHIC\n#line 2\n"));
}

}  // namespace
}  // namespace saddle
