// See-through surfaces against the over operator in double.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "image/analytic_mesh.h"
#include "image/lighting_reference.h"
#include "image/passes.h"
#include "render/gl/context.h"
#include "render/picture/layers.h"
#include "render/picture/picture.h"

namespace saddle {
namespace {

/// In 8-bit levels: half a level each for rounding layers, which together weigh no more than one,
/// and the result; half floats less than a tenth.
constexpr double kTolerance = 1.1;

constexpr int kSize = 60;

/// Straight down at the xy-plane from z = 50; there is no light but what surfaces emit.
Scene glowing_scene() {
  Scene scene;
  scene.lights.clear();
  scene.camera.view = {0, 0, 1};
  scene.camera.up = {0, 1, 0};
  scene.camera.ortho = true;
  scene.camera.target = dvec3(0);
  scene.camera.distance = 50;
  scene.camera.fov = 2 * std::atan(2.0 / 50) * 180 / std::numbers::pi;  // 2 above and below
  return scene;
}

struct Seen {
  dvec3 color;
  double opacity = 1;
};

SurfaceSpec glowing(const Seen& front, const dvec3& back) {
  SurfaceSpec spec;
  spec.front = spec.back = {};
  spec.front.emission = {front.color.r, front.color.g, front.color.b};
  spec.back.emission = {back.r, back.g, back.b};
  spec.opacity = front.opacity;
  return spec;
}

/// Colour and alpha of what is seen, from the nearest on, over a background; not premultiplied.
/// Source: T. Porter, T. Duff, "Compositing digital images", 1984.
glm::dvec4 over(const std::vector<Seen>& from_the_nearest, const Color& background) {
  glm::dvec4 sum(dvec3(background.r, background.g, background.b) * double(background.a),
                 background.a);
  for (std::size_t i = from_the_nearest.size(); i-- > 0;) {
    const Seen& s = from_the_nearest[i];
    sum = s.opacity * glm::dvec4(s.color, 1) + (1 - s.opacity) * sum;
  }
  return {sum.a > 0 ? dvec3(sum) / sum.a : dvec3(0), sum.a};
}

void expect_pixel(const Image& image, int x, int y, const glm::dvec4& wanted) {
  // A colour of little alpha is rounded after its division by it.
  const double coarse = std::max(1.0, 1 / wanted.a);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(image.pixel(x, y)[c], 255 * wanted[c], kTolerance * coarse)
        << x << " " << y << " channel " << c;
  }
  EXPECT_NEAR(image.pixel(x, y)[3], 255 * wanted.a, kTolerance) << x << " " << y;
}

Image draw(const Scene& scene, std::span<const Mesh> meshes, int antialias = 1) {
  return render(scene, meshes, {kSize, kSize, antialias}).image;
}

const std::vector<Seen> kStack = {
    {{0.9, 0.1, 0.2}, 0.5}, {{0.1, 0.8, 0.3}, 0.25}, {{0.2, 0.3, 1}, 0.7}, {{1, 1, 0}, 0.1}};

/// Planes under each other, the first on top.
void add_stack(const std::vector<Seen>& stack, Scene& scene, std::vector<Mesh>& meshes) {
  for (std::size_t k = 0; k < stack.size(); ++k) {
    scene.surfaces.push_back(glowing(stack[k], dvec3(1)));
    meshes.push_back(plane_mesh(dvec3(0, 0, -0.3 * static_cast<double>(k)), 1, {2, 2, 0}));
  }
}

TEST(Transparency, StacksPlanesWhateverTheirOrder) {
  Scene scene = glowing_scene();
  std::vector<Mesh> meshes;
  add_stack(kStack, scene, meshes);
  for (const Color& background :
       {Color{0, 0, 0, 1}, Color{1, 0.5, 0.25, 1}, Color{0, 0, 0, 0}, Color{0.2, 0.9, 0.4, 0.5}}) {
    scene.background = background;
    for (const std::array<std::size_t, 4>& order :
         {std::array<std::size_t, 4>{0, 1, 2, 3}, {3, 2, 1, 0}, {2, 0, 3, 1}}) {
      Scene mixed = scene;
      std::vector<Mesh> mixed_meshes;
      for (std::size_t k = 0; k < order.size(); ++k) {
        mixed.surfaces[k] = scene.surfaces[order[k]];
        mixed_meshes.push_back(meshes[order[k]]);
      }
      expect_pixel(draw(mixed, mixed_meshes), 25, 22, over(kStack, background));
    }
  }
}

TEST(Transparency, ShowsBacksFromBehind) {
  Scene scene = glowing_scene();
  std::vector<Mesh> meshes;
  add_stack(kStack, scene, meshes);
  scene.camera.view = {0, 0, -1};
  const std::vector<Seen> seen = {
      {dvec3(1), 0.1}, {dvec3(1), 0.7}, {dvec3(1), 0.25}, {dvec3(1), 0.5}};
  expect_pixel(draw(scene, meshes), 25, 22, over(seen, scene.background));
}

TEST(Transparency, EndsAtWhatHides) {
  Scene scene = glowing_scene();
  std::vector<Mesh> meshes;
  std::vector<Seen> stack = kStack;
  stack[2].opacity = 1;
  add_stack(stack, scene, meshes);
  scene.background = {0.3, 0.3, 0.3, 0};
  expect_pixel(draw(scene, meshes), 25, 22, over(stack, scene.background));
  EXPECT_EQ(int{draw(scene, meshes).pixel(25, 22)[3]}, 255);
}

TEST(Transparency, OfNothingIsNothing) {
  Scene scene = glowing_scene();
  std::vector<Mesh> meshes;
  std::vector<Seen> stack = kStack;
  stack[0].opacity = 0;
  add_stack(stack, scene, meshes);
  expect_pixel(draw(scene, meshes), 25, 22, over(stack, scene.background));
  scene.surfaces.resize(1);
  meshes.resize(1);
  expect_pixel(draw(scene, meshes), 25, 22, over({}, scene.background));
}

void append(const Mesh& from, Mesh& mesh) {
  const auto corners = static_cast<std::uint32_t>(mesh.position.size());
  for (std::size_t i = 0; i < from.position.size(); ++i) {
    mesh.position.push_back(from.position[i]);
    mesh.normal.push_back(from.normal[i]);
    mesh.uv.push_back(from.uv[i]);
    mesh.point.push_back(mesh.point_count++);
    mesh.bounds.add(from.position[i]);
  }
  for (const Triangle& t : from.triangles) {
    mesh.triangles.push_back({t[0] + corners, t[1] + corners, t[2] + corners});
  }
}

/// z = x, its front up, and z = -x, its back up: they cross at x = 0.
Mesh crossing_sheets() {
  Mesh mesh = analytic_mesh(
      [](double s, double t) {
        const dvec3 p(2 * s - 1, 2 * t - 1, 2 * s - 1);
        return AnalyticPoint{p, glm::normalize(dvec3(-1, 0, 1))};
      },
      {4, 4, 0});
  const Mesh other = analytic_mesh(
      [](double s, double t) {
        const dvec3 p(2 * s - 1, 1 - 2 * t, 1 - 2 * s);
        return AnalyticPoint{p, glm::normalize(dvec3(-1, 0, -1))};
      },
      {4, 4, 0});
  append(other, mesh);
  return mesh;
}

TEST(Transparency, IsRightWhereASurfaceCrossesItself) {
  Scene scene = glowing_scene();
  scene.background = {0, 0.3, 0, 1};
  const Seen front{{1, 0, 0}, 0.6};
  const Seen back{{0, 0, 1}, 0.6};
  scene.surfaces.push_back(glowing(front, back.color));
  Mesh mesh = crossing_sheets();
  std::mt19937 random(7);  // NOLINT: the same order every time
  for (int order = 0; order < 5; ++order) {
    const Image image = draw(scene, std::span(&mesh, 1));
    expect_pixel(image, 40, 30, over({front, back}, scene.background));  // x > 0
    expect_pixel(image, 20, 30, over({back, front}, scene.background));
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  }
}

TEST(Transparency, CountsAllFourSheetsOfATorusFromItsSide) {
  Scene scene = glowing_scene();
  const Seen front{{0.9, 0.6, 0.1}, 0.3};
  const Seen back{{0.1, 0.4, 0.9}, 0.3};
  scene.surfaces.push_back(glowing(front, back.color));
  const Mesh mesh = torus_mesh(1.2, 0.5, {96, 48, 0});
  scene.camera.view = {0, -1, 0};
  scene.camera.up = {0, 0, 1};
  const Image image = draw(scene, std::span(&mesh, 1), 2);
  expect_pixel(image, kSize / 2, kSize / 2, over({front, back, front, back}, scene.background));
  scene.camera.view = {0, 0, 1};
  scene.camera.up = {0, 1, 0};
  const Image above = draw(scene, std::span(&mesh, 1), 2);
  expect_pixel(above, kSize / 2, kSize / 2, over({}, scene.background));  // the hole
  expect_pixel(above, kSize / 2 + 18, kSize / 2, over({front, back}, scene.background));
}

TEST(Transparency, HasAsManyLayersAsThereAre) {
  Scene scene = glowing_scene();
  std::vector<Mesh> meshes;
  std::vector<Seen> stack;
  for (int k = 0; k < 60; ++k) stack.push_back({{k % 2, k % 3 / 2.0, k % 5 / 4.0}, 0.03});
  add_stack(stack, scene, meshes);
  expect_pixel(draw(scene, meshes), 25, 22, over(stack, scene.background));
}

TEST(Transparency, SaysWhereItLeavesLayersOut) {
  Scene scene = glowing_scene();
  scene.surfaces = {glowing({{1, 1, 1}, 1e-5}, dvec3(1))};
  const auto warnings = [&](std::size_t planes) {
    Mesh mesh;
    for (std::size_t k = 0; k < planes; ++k) {
      append(plane_mesh(dvec3(0, 0, -0.01 * static_cast<double>(k)), 1, {1, 1, 0}), mesh);
    }
    return render(scene, std::span(&mesh, 1), {1, 1, 1}).warnings;
  };
  EXPECT_TRUE(warnings(20).empty());
  const auto said = warnings(kMostLayers + 1);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("1000 see-through layers"), std::string::npos) << said[0];
}

TEST(Transparency, LightsEachLayerInSeveralPasses) {
  Scene scene = glowing_scene();
  scene.surfaces.resize(1);
  scene.surfaces[0].opacity = 0.5;
  for (int i = 0; i < 12; ++i) {
    scene.lights.push_back({.position = {std::cos(i), std::sin(i), -48}, .color = {0.2, 0.1, 0.3}});
  }
  const Mesh mesh = torus_mesh(1.2, 0.5, {48, 24, 0});
  const Image one = draw_in_passes(scene, mesh, kSize, 100);
  const Image several = draw_in_passes(scene, mesh, kSize, 5);
  EXPECT_GT(int{one.pixel(kSize / 2 + 18, kSize / 2)[0]}, 100);
  // Half a level for each pass, and for adding them.
  EXPECT_LE(largest_difference(one, several), 3);
}

TEST(Transparency, LightsALayerAsItLightsWhatHides) {
  Scene scene = glowing_scene();
  scene.lights = three_lights();
  scene.surfaces.resize(1);
  const Mesh mesh = plane_mesh(dvec3(0), 1, {1, 1, 0});
  const Image hiding = draw(scene, std::span(&mesh, 1));
  scene.surfaces[0].opacity = 0.5;
  const Image half = draw(scene, std::span(&mesh, 1));
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(half.pixel(30, 30)[c], hiding.pixel(30, 30)[c] / 2.0, 1);
  }
}

TEST(Transparency, LeavesGridLinesAsTheyAre) {
  Scene scene = glowing_scene();
  const Seen near{{1, 0, 0}, 0.5};
  scene.surfaces = {glowing(near, dvec3(0)), glowing({{0, 1, 0}, 0.5}, dvec3(0))};
  // 15 pixels for 1: lines through the middles of pixels.
  constexpr double kHalf = 0.5 / 15;
  const std::vector<Mesh> meshes = {plane_mesh(dvec3(kHalf, kHalf, 1), 1, {2, 2, 1}),
                                    plane_mesh(dvec3(0.4 + kHalf, 0.4, 0), 1, {2, 2, 1})};
  const Image image = draw(scene, meshes, 3);
  const Seen line{dvec3(0.2), 1};
  expect_pixel(image, 30, 25, over({line}, scene.background));        // on the near plane
  expect_pixel(image, 36, 20, over({near, line}, scene.background));  // on the far one
}

TEST(Transparency, IsTheSameInTiles) {
  Scene scene = glowing_scene();
  scene.lights = three_lights();
  scene.surfaces.resize(1);
  scene.surfaces[0].opacity = 0.4;
  scene.camera.view = {1, -2, 1};
  const Mesh mesh = torus_mesh(1.2, 0.5, {48, 24, 0});
  const PictureSettings options{101, 83, 2};
  const Image whole = render(scene, std::span(&mesh, 1), options).image;
  const Image tiled = render_in_tiles(scene, std::span(&mesh, 1), options, 70).image;
  int different = 0;
  for (std::size_t i = 0; i < whole.rgba.size(); i += 4) {
    different += std::abs(whole.rgba[i] - tiled.rgba[i]) > 1 ? 1 : 0;
  }
  EXPECT_LE(different, 10);  // positions are rounded anew in each tile
  EXPECT_GT(int{whole.pixel(50, 50)[0]}, 20);
}

TEST(Transparency, CostsNothingWhereThereIsNone) {
  Scene scene = glowing_scene();
  std::vector<Mesh> meshes;
  add_stack({{{1, 0, 0}, 1}}, scene, meshes);
  const auto text = [&] { return render(scene, meshes, {8, 8, 1}).shaders; };
  EXPECT_EQ(text().find("opacity"), std::string::npos);
  scene.surfaces[0].opacity = 0.5;
  EXPECT_NE(text().find("opacity"), std::string::npos);
}

TEST(Transparency, IsTheSameThroughEgl) {
  try {
    make_context(Backend::Egl);
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  Scene scene = glowing_scene();
  std::vector<Mesh> meshes;
  add_stack(kStack, scene, meshes);
  const Image image = render(scene, meshes, {kSize, kSize, 2}, Backend::Egl).image;
  expect_pixel(image, 25, 22, over(kStack, scene.background));
}

}  // namespace
}  // namespace saddle
