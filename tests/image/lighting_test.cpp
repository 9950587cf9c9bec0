// Pixels against the lighting equation in double.
#include <cmath>
#include <functional>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "image/analytic_mesh.h"
#include "image/lit_scene.h"
#include "image/passes.h"

namespace saddle {
namespace {

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
      expect_pixel(image, x, y,
                   lit_color({p, n, v}, material, scene.lights, scene.picture.specular));
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

/// Every kind of light and material, each alone.
struct Case {
  std::string name;
  std::function<void(Scene&)> change;
};

std::vector<Case> lighting_cases() {
  const auto lit_by = [](const Light& light) {
    return [light](Scene& scene) { scene.lights = {light}; };
  };
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, const Light& light) {
    cases.push_back({name, lit_by(light)});
  };
  Light light = point_light({2, 2, -2});
  add("point", light);
  light.attenuation = {0.5, 0.1, 0.05, {}};
  add("attenuated point", light);
  light = point_light({2, 1, -3});
  light.ambient = {0.2, 0.3, 0.1};
  add("ambient part", light);
  light.specular = Color{0, 0.9, 0.3};
  add("a colour of its own for highlights", light);
  light = point_light({0, 0, -1});
  light.spot = cone(40);
  light.spot->inner = 5;
  add("spot with a linear edge", light);
  light.spot->falloff = Spot::Falloff::Smooth;
  light.attenuation = {0, 0.5, 0, {}};
  light.ambient = {0.1, 0.1, 0.1};
  add("attenuated spot with a smooth edge", light);
  light.spot->exponent = 7;
  add("spot with an exponent", light);
  for (double cutoff : {90.0, 120.0, 180.0}) {
    light = point_light({0.5, 0.2, -1});
    light.spot = cone(cutoff);
    light.spot->exponent = cutoff == 180 ? 0 : 3;
    add("spot of half a sphere and more", light);
  }
  cases.push_back({"material that glows", [](Scene& scene) {
                     scene.surfaces[0].front.emission = {0.3, 0, 0.1};
                   }});
  cases.push_back({"material with an ambient colour", [](Scene& scene) {
                     scene.lights[0].ambient = {0.5, 0.5, 0.5};
                     scene.surfaces[0].front.ambient = Color{0, 0, 1};
                   }});
  cases.push_back({"half vectors", [](Scene& scene) { scene.picture.specular = Specular::Blinn; }});
  cases.push_back({"a light that is off", [](Scene& scene) { scene.lights[0].enabled = 0; }});
  cases.push_back({"a brighter light than white", [](Scene& scene) {
                     scene.lights[1].color = {3, 1e300, 0};
                   }});
  return cases;
}

TEST(Lighting, FollowsTheEquationForEveryKindOfLightAndMaterial) {
  const Mesh mesh = sphere_mesh(dvec3(0), 1, {256, 256, 0});
  for (const Case& c : lighting_cases()) {
    SCOPED_TRACE(c.name);
    Scene scene = lit_scene(5);
    c.change(scene);
    expect_lit_sphere(scene, draw(scene, mesh), scene.surfaces[0].front, false);
  }
}

TEST(Lighting, IsTheSameInSeveralPasses) {
  // Each pass rounds to 8 bits: half a level each, and the reference's tolerance.
  const Mesh mesh = sphere_mesh(dvec3(0), 1, {64, 64, 0});
  Scene scene = lit_scene(5);
  scene.lights.clear();
  for (int i = 0; i < 40; ++i) {
    Light light = point_light({std::cos(i), std::sin(i), -3});
    light.color = {0.02, 0.01 * (i % 3), 0.015};
    if (i % 2 == 0) light.spot = cone(60);
    if (i % 5 == 0) light.directional = !light.spot;
    scene.lights.push_back(light);
  }
  scene.surfaces[0].front.emission = {0.1, 0, 0};
  const Image one = draw_in_passes(scene, mesh, kHeight, 100);
  const Image several = draw_in_passes(scene, mesh, kHeight, 10);
  EXPECT_GT(one.pixel(kHeight / 2, kHeight / 2)[0], 30);
  EXPECT_LE(largest_difference(one, several), 3);
}

TEST(Lighting, PerVertexBlendsTheColoursOfCorners) {
  Scene scene = lit_scene(4);
  scene.picture.shading = Shading::Vertex;
  scene.lights = {point_light({0, 0, -3})};
  const Mesh mesh = plane_mesh(dvec3(0), 1, {1, 1, 0});  // two triangles
  const dvec3 corner(1, 1, -4);
  const dvec3 at_corner = lit_color({corner, dvec3(0, 0, 1), glm::normalize(-corner)},
                                    scene.surfaces[0].front, scene.lights);
  const Image image = render(scene, std::span(&mesh, 1), {kWidth + 1, kHeight + 1, 1}).image;
  expect_pixel(image, kWidth / 2, kHeight / 2, at_corner);  // all corners are alike
  scene.picture.shading = Shading::Pixel;
  expect_pixel(render(scene, std::span(&mesh, 1), {kWidth + 1, kHeight + 1, 1}).image, kWidth / 2,
               kHeight / 2,
               lit_color({dvec3(0, 0, -4), dvec3(0, 0, 1), dvec3(0, 0, 1)}, scene.surfaces[0].front,
                         scene.lights));
}

TEST(Lighting, PerVertexHasBothSides) {
  for (double sign : {1.0, -1.0}) {
    Scene scene = lit_scene(4);
    scene.picture.shading = Shading::Vertex;
    scene.camera.view = {0, 0, sign};
    scene.lights = {{.position = {0, 0, 1}, .directional = true, .color = {0.5, 0.5, 0.5}}};
    const Mesh mesh = plane_mesh(dvec3(0), 1);
    const Material& side = sign > 0 ? scene.surfaces[0].front : scene.surfaces[0].back;
    Material diffuse = side;
    diffuse.specular = {};
    scene.surfaces[0].front.specular = scene.surfaces[0].back.specular = {};
    expect_pixel(
        draw(scene, mesh), kWidth / 2, kHeight / 2,
        lit_color({dvec3(0, 0, -4), dvec3(0, 0, 1), dvec3(0, 0, 1)}, diffuse, scene.lights));
  }
}

TEST(Lighting, IsTheSameWhereBacksAreCulled) {
  const Scene scene = lit_scene(5);
  expect_lit_sphere(scene, draw(scene, closed_sphere_mesh()), kFrontMaterial, false);
}

}  // namespace
}  // namespace saddle
