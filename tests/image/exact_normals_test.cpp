// Normals computed from the formula in the shader, against the formula in double.
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/lighting_reference.h"
#include "mesh/mesher/grid_mesh.h"
#include "render/picture/picture.h"
#include "scene/model/assignments.h"
#include "scene/model/prepare.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

constexpr int kSize = 200;

Scene scene_of(const std::vector<std::string>& texts) {
  Scene scene;
  scene.surfaces.resize(1);
  for (const std::string& text : texts) assign(scene, text);
  scene.lights = three_lights();
  scene.camera.view = {0, 0, 1};
  scene.camera.up = {0, 1, 0};
  scene.camera.target = dvec3(0);
  scene.camera.distance = 6;
  scene.picture = {kSize, kSize, 1};
  scene.picture.shading = Shading::Exact;
  return scene;
}

Mesh coarse_mesh(const Scene& scene, int cells) {
  GridOptions grid;
  grid.cells_u = grid.cells_v = cells;
  grid.lines_u = grid.lines_v = 0;
  const Surface surface = prepare_surface(scene, scene.surfaces[0]).surface;
  Mesh mesh = mesh_on_grid(surface, grid).mesh;
  take_user_parameters(surface, mesh.uv);
  return mesh;
}

Rendering draw(const Scene& scene, int cells = 8) {
  const Mesh mesh = coarse_mesh(scene, cells);
  return render(scene, std::span(&mesh, 1), scene.picture);
}

const std::vector<std::string> kWaves = {"z=h*sin(3*u)*cos(2*v)", "h=0.2", "u=-1:1", "v=-1:1"};

/// A height field seen from above without perspective: pixels know their u and v, whatever the
/// mesh. The directional lights' colours do not depend on where the surface is.
double largest_error(const Scene& scene, const Image& image, double h, double sign) {
  double largest = 0;
  const double half = 6 * std::tan(15 * std::numbers::pi / 180);
  for (int y = 70; y < 130; ++y) {
    for (int x = 70; x < 130; ++x) {
      const double u = (2 * (x + 0.5) / kSize - 1) * half;
      const double v = (1 - 2 * (y + 0.5) / kSize) * half;
      const dvec3 n = glm::normalize(dvec3(-3 * h * std::cos(3 * u) * std::cos(2 * v),
                                           2 * h * std::sin(3 * u) * std::sin(2 * v), 1));
      const Material& material = sign > 0 ? scene.surfaces[0].front : scene.surfaces[0].back;
      const dvec3 color = lit_color({dvec3(u, v, -6), n, dvec3(0, 0, 1)}, material, scene.lights);
      for (int c = 0; c < 3; ++c) {
        largest = std::max(largest, std::abs(image.pixel(x, y)[c] - 255 * color[c]));
      }
    }
  }
  return largest;
}

Scene waves() {
  Scene scene = scene_of(kWaves);
  scene.camera.ortho = true;
  scene.lights = {{.position = {0.5, 1, 2}, .directional = true, .color = {0.8, 0.7, 0.6}}};
  return scene;
}

/// Half a level of rounding, and floats.
constexpr double kExact = 0.6;

TEST(ExactNormals, AreThoseOfTheFormulaWhateverTheMesh) {
  Scene scene = waves();
  EXPECT_LE(largest_error(scene, draw(scene).image, 0.2, 1), kExact);
  scene.picture.shading = Shading::Pixel;
  EXPECT_GT(largest_error(scene, draw(scene).image, 0.2, 1), 10 * kExact);  // of 8 x 8 cells
}

TEST(ExactNormals, ChangeSidesWithTheSurface) {
  Scene scene = waves();
  scene.surfaces[0].flip = true;
  EXPECT_LE(largest_error(scene, draw(scene).image, 0.2, -1), kExact);
  scene.surfaces[0].flip = false;
  scene.surfaces[0].u = {"1", "-1"};  // run backwards, it turns the surface over
  const Mesh mesh = coarse_mesh(scene, 8);
  const Image image = render(scene, std::span(&mesh, 1), scene.picture).image;
  EXPECT_LE(largest_error(scene, image, 0.2, -1), kExact);
}

TEST(ExactNormals, GoThroughMirrorsAndUnevenScales) {
  Scene scene = waves();
  scene.nodes = {{"node", "", {{Transform::Kind::Scale, dvec3(1, 1, -3), 0}}}};
  scene.surfaces[0].in = {"node"};
  EXPECT_LE(largest_error(scene, draw(scene).image, -0.6, -1), kExact);
}

TEST(ExactNormals, FollowParametersAndTimeWithTheSameProgram) {
  std::vector<std::string> texts;
  for (const char* h : {"0.2", "0.3*t"}) {
    Scene scene = waves();
    scene.definitions[0].text = h;
    scene.t = 1.5;
    const Rendering rendering = draw(scene);
    EXPECT_LE(largest_error(scene, rendering.image, h[2] == '2' ? 0.2 : 0.45, 1), kExact);
  }
  for (const char* h : {"0.2", "0.4"}) {
    Scene scene = waves();
    scene.definitions[0].text = h;
    texts.push_back(draw(scene).shaders);
  }
  EXPECT_EQ(texts[0], texts[1]);
  EXPECT_NE(texts[0].find("constant[0]"), std::string::npos);
}

TEST(ExactNormals, FollowRangesThatDependOnU) {
  Scene scene = waves();
  scene.surfaces[0].v = {"-1-u*u/4", "1"};
  EXPECT_LE(largest_error(scene, draw(scene).image, 0.2, 1), kExact);
}

/// No pixel of it is black, or another than with a fine mesh, by more than a pixel's own change.
TEST(ExactNormals, GiveWayAtSingularPoints) {
  for (const std::vector<std::string>& texts : std::vector<std::vector<std::string>>{
           {"x=cos(u)*cos(v)", "y=sin(u)*cos(v)", "z=sin(v)", "u=0:2*pi", "v=-pi/2:pi/2"},
           {"x=u*cos(v)", "y=u*sin(v)", "z=-u", "u=0:1", "v=0:2*pi"},  // an apex
           {"x=u^3", "y=v^3", "z=u^3*v^3/4", "u=-1:1", "v=-1:1"},      // flat parameters
           {"z=-abs(u)/2", "u=-1:1", "v=-1:1"}}) {                     // a crease
    const Scene scene = scene_of(texts);
    const Image image = draw(scene).image;
    for (int y = 80; y < 120; ++y) {
      for (int x = 80; x < 120; ++x) EXPECT_GT(int{image.pixel(x, y)[0]}, 60) << texts[0] << x << y;
    }
  }
}

TEST(ExactNormals, SayWhereAFunctionHasNone) {
  const Scene scene = scene_of({"z=besselj0(3*u)*v"});
  const Rendering rendering = draw(scene);
  ASSERT_EQ(rendering.warnings.size(), 1U);
  EXPECT_NE(rendering.warnings[0].find("no float version"), std::string::npos);
  Scene interpolated = scene;
  interpolated.picture.shading = Shading::Pixel;
  EXPECT_EQ(rendering.image.rgba, draw(interpolated).image.rgba);
}

TEST(ExactNormals, SayWhereFloatsHaveTooFewDigits) {
  // A wave of length 6e-7 at 1: floats there are 6e-8 apart.
  const Scene scene = scene_of({"z=1e-7*sin(1e7*u)", "u=1:2"});
  const Rendering rendering = draw(scene);
  ASSERT_EQ(rendering.warnings.size(), 1U);
  EXPECT_NE(rendering.warnings[0].find("too few digits"), std::string::npos);
  EXPECT_TRUE(draw(scene_of({"z=sin(10*u)", "u=1:2"})).warnings.empty());
}

TEST(ExactNormals, HaveNoCodeUnlessAskedFor) {
  Scene scene = waves();
  const std::string exact = draw(scene).shaders;
  EXPECT_NE(exact.find("formula_normal"), std::string::npos);
  EXPECT_EQ(exact.find("safe_"), std::string::npos);  // functions that the formula does not call
  scene.picture.shading = Shading::Pixel;
  const std::string text = draw(scene).shaders;
  for (const char* absent : {"formula", "trust", "parameters", "constant["}) {
    EXPECT_EQ(text.find(absent), std::string::npos) << absent;
  }
}

}  // namespace
}  // namespace saddle
