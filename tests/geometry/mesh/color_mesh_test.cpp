// Colours of meshes: right between the corners, without cracks, and honest about what has none.
#include "mesh/color/color_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "base/random.h"
#include "mesh/model/topology.h"
#include "mesh_checks.h"
#include "meshing/tessellate.h"
#include "scene/model/gallery.h"
#include "scene/model/prepare.h"
#include "study_subject.h"

namespace saddle {
namespace {

constexpr Purpose kPicture = {.picture = true, .mesh = false};

Tessellation coloured(Scene scene, const std::string& formula) {
  scene.surfaces[0].color = formula;
  return tessellate(scene, scene.surfaces[0], kPicture, 0);
}

Scene of_gallery(const std::string& name) {
  return gallery_scene(*find_gallery_entry(name));
}

/// The largest difference of the number inside of triangles from the interpolated one, in steps of
/// which the range has 256; triangles smaller than a pixel do not count.
double worst_step(const Scene& plain, const std::string& formula) {
  Scene scene = plain;
  scene.surfaces[0].color = formula;
  const Tessellation t = coloured(scene, formula);
  const Surface surface = prepare_surface(scene, scene.surfaces[0]).surface;
  const Mesh& mesh = t.mesh;
  std::uint64_t key = 0;
  std::vector<dvec2> uv;
  std::vector<double> straight;
  for (const auto& [a, b, c] : mesh.triangles) {
    const double size = glm::length(doubled_area(mesh, {a, b, c}));
    if (size < 2 * std::pow(t.report.tolerance.value(), 2)) continue;
    double s = random_unit(key++);
    double r = random_unit(key++);
    if (s + r > 1) s = 1 - s, r = 1 - r;
    uv.push_back(mesh.uv[a] + s * (mesh.uv[b] - mesh.uv[a]) + r * (mesh.uv[c] - mesh.uv[a]));
    straight.push_back(mesh.color[a] + s * (mesh.color[b] - mesh.color[a]) +
                       r * (mesh.color[c] - mesh.color[a]));
  }
  const std::vector<double> numbers = evaluate_color(surface, uv);
  double worst = 0;
  const double width = mesh.color_range.high - mesh.color_range.low;
  for (std::size_t i = 0; i < uv.size(); ++i) {
    worst = std::max(worst, std::abs(numbers[i] - straight[i]) / width * kColorSteps);
  }
  return worst;
}

TEST(Colors, AreRightToAboutAStepBetweenCorners) {
  // A side within a step at three places may be off by a little more at others, and a triangle's
  // middle by twice as much.
  EXPECT_LT(worst_step(of_gallery("torus"), "gauss"), 1.5);
  EXPECT_LT(worst_step(of_gallery("monkey-saddle"), "mean"), 2);
  EXPECT_LT(worst_step(of_gallery("boy"), "mean"), 3);
  EXPECT_LT(worst_step(scene_of("u", "v", "0"), "sin(9*u)*sin(7*v)"), 2);
}

TEST(Colors, RefineAPlaneWhoseColourWavesAlthoughItsRimIsConstant) {
  Scene scene = scene_of("u", "v", "0");
  scene.surfaces[0].grid = GridSize{0, 0};
  const Mesh mesh = coloured(scene, "sin(pi*u)*sin(pi*v)").mesh;
  EXPECT_NEAR(mesh.color_range.low, -1, 0.01);
  EXPECT_NEAR(mesh.color_range.high, 1, 0.01);
}

TEST(Colors, OfATorusRunOverItsGaussCurvature) {
  const Mesh mesh = coloured(of_gallery("torus"), "gauss").mesh;  // R = 2, r = 0.8
  EXPECT_NEAR(mesh.color_range.low, -1 / (0.8 * 1.2), 1e-12);
  EXPECT_NEAR(mesh.color_range.high, 1 / (0.8 * 2.8), 1e-12);
  for (std::size_t i = 0; i < mesh.uv.size(); i += 7) {
    const double c = std::cos(mesh.uv[i].y);
    EXPECT_NEAR(mesh.color[i], c / (0.8 * (2 + 0.8 * c)), 1e-12);
  }
}

TEST(Colors, OfTheMeanCurvatureTurnWithTheFront) {
  Scene scene = of_gallery("sphere");
  EXPECT_NEAR(coloured(scene, "mean").mesh.color_range.low, -1, 1e-9);  // away from outside
  scene.surfaces[0].flip = !scene.surfaces[0].flip;
  EXPECT_NEAR(coloured(scene, "mean").mesh.color_range.low, 1, 1e-9);
}

TEST(Colors, KnowDefinitionsAndTheMomentAndCoordinates) {
  Scene scene = scene_of("u", "v", "a*u", {"0", "1"}, {"0", "1"});
  scene.definitions = {{"a", "3"}, {"w", "a+t"}};
  scene.t = 2;
  const Mesh mesh = coloured(scene, "z+w*y").mesh;
  EXPECT_EQ(mesh.color_range.low, 0);
  EXPECT_EQ(mesh.color_range.high, 8);
}

TEST(Colors, HaveTheUsersOwnMeaningOfGauss) {
  Scene scene = scene_of("u", "v", "u*v");
  scene.definitions = {{"gauss", "7"}};
  EXPECT_EQ(coloured(scene, "gauss").mesh.color_range.low, 7);
}

TEST(Colors, OfConstantCurvatureAreConstant) {
  for (const char* name : {"sphere", "pseudosphere", "kuen"}) {
    const Mesh mesh = coloured(of_gallery(name), "gauss").mesh;
    EXPECT_EQ(mesh.color_range.low, mesh.color_range.high) << name;
    EXPECT_NEAR(std::abs(mesh.color_range.low), 1, 1e-6) << name;
  }
  const Mesh mesh = coloured(of_gallery("catenoid"), "mean").mesh;
  EXPECT_EQ(mesh.color_range.low, mesh.color_range.high);
}

TEST(Colors, TakeLimitsAtPoles) {
  const Mesh mesh = coloured(of_gallery("sphere"), "gauss").mesh;
  for (const double number : mesh.color) EXPECT_NEAR(number, 1, 1e-6);
}

TEST(Colors, LeaveOutWhatIsUndefinedInWholeTriangles) {
  const Tessellation t = coloured(scene_of("u", "v", "0"), "sqrt(u)");
  for (const Triangle& triangle : t.mesh.triangles) {
    const auto undefined = std::ranges::count_if(
        triangle, [&](std::uint32_t i) { return std::isnan(t.mesh.color[i]); });
    EXPECT_TRUE(undefined == 0 || undefined == 3);
    if (undefined == 3) continue;
    for (const std::uint32_t i : triangle) EXPECT_GE(t.mesh.uv[i].x, 0);
  }
  ASSERT_EQ(t.warnings.size(), 1U);
  EXPECT_EQ(t.warnings[0],
            "surface: the colour is undefined on 50 % of the surface, which is grey");
}

TEST(Colors, AreCutToWhatMostOfTheSurfaceHasBesidePoles) {
  for (const auto& [formula, low, high] :
       {std::tuple{"1/(u^2+v^2)", 0.5, 20.0}, {"1/u", -20.0, 20.0}, {"-log(abs(v))", 0.0, 4.0}}) {
    const Tessellation t = coloured(scene_of("u", "v", "0"), formula);
    EXPECT_GE(t.mesh.color_range.low, low - 0.5) << formula;
    EXPECT_LE(t.mesh.color_range.high, high + 0.5) << formula;
    ASSERT_EQ(t.warnings.size(), 1U) << formula;
    EXPECT_NE(t.warnings[0].find("goes to infinity"), std::string::npos);
  }
}

TEST(Colors, RunToTrueExtremesWhereverTheCornersAre) {
  const Scene plane = scene_of("u", "v", "0");
  const Mesh maximum = coloured(plane, "exp(-30*((u-0.3123)^2+(v+0.1717)^2))").mesh;
  EXPECT_NEAR(maximum.color_range.high, 1, 1e-12);
  Scene scene = scene_of("u", "v", "2-u^2-v^2");
  scene.clip = {.automatic = false, .box = Bounds{{-2, -2, 0.5}, {2, 2, 1.75}}};
  const Mesh cut = coloured(scene, "z").mesh;
  // Corners on the cut have the number of a place that is within the mesh's tolerance of it.
  EXPECT_NEAR(cut.color_range.low, 0.5, 0.005);
  EXPECT_NEAR(cut.color_range.high, 1.75, 0.005);
}

TEST(Colors, OfOddPolesGoAsFarBothWays) {
  for (const char* formula : {"1/u", "tan(3*u)", "1/(u*v)"}) {
    const ColorRange range = coloured(scene_of("u", "v", "0"), formula).mesh.color_range;
    EXPECT_NEAR(range.low, -range.high, 0.05 * range.high) << formula;
  }
}

TEST(Colors, ThatAreInfiniteAreBeyondTheEndOrNone) {
  const Mesh half = coloured(scene_of("u", "v", "0"), "u<0?inf:u").mesh;
  EXPECT_EQ(half.color_range.low, 0);
  EXPECT_GT(half.color_range.high, 0.9);
  EXPECT_LE(half.color_range.high, 1);
  for (const char* formula : {"inf", "-inf", "1/0", "u<0?nan:inf"}) {
    const Tessellation t = coloured(scene_of("u", "v", "0"), formula);
    for (const double number : t.mesh.color) EXPECT_TRUE(std::isnan(number)) << formula;
    ASSERT_EQ(t.warnings.size(), 1U) << formula;
    EXPECT_NE(t.warnings[0].find("undefined on 100 %"), std::string::npos) << t.warnings[0];
  }
}

TEST(Colors, AreNotCutAtPeaksOrJumps) {
  for (const char* formula :
       {"exp(-300*((u-0.3)^2+v^2))", "u<0.3&&v>u?1:0", "1+floor(2*u)", "abs(u)", "z"}) {
    const Tessellation t = coloured(scene_of("u", "v", "u*v"), formula);
    EXPECT_TRUE(t.warnings.empty()) << formula << ": " << t.warnings[0];
  }
}

TEST(Colors, FollowAJumpToHalfAPixel) {
  const Tessellation t = coloured(scene_of("u", "v", "0"), "u<0.3123?0:1");
  const double tolerance = t.report.tolerance.value();
  for (const auto& [a, b, c] : t.mesh.triangles) {
    const double low = std::min({t.mesh.color[a], t.mesh.color[b], t.mesh.color[c]});
    const double high = std::max({t.mesh.color[a], t.mesh.color[b], t.mesh.color[c]});
    if (low == high) continue;
    for (const std::uint32_t i : {a, b, c}) {
      EXPECT_NEAR(t.mesh.position[i].x, 0.3123, 1.001 * tolerance);
    }
  }
}

TEST(Colors, ChangeNothingButTheTriangles) {
  for (const char* name : {"torus", "klein-figure8", "sphere", "mobius", "cone-double"}) {
    const Scene scene = of_gallery(name);
    const Mesh plain = tessellate(scene, scene.surfaces[0], kPicture, 0).mesh;
    const Mesh mesh = coloured(scene, "sin(9*u)*cos(9*v)").mesh;
    EXPECT_GT(mesh.triangles.size(), 2 * plain.triangles.size()) << name;
    EXPECT_EQ(mesh.color.size(), mesh.position.size());
    EXPECT_NEAR(area(mesh), area(plain), 1e-9 * area(plain)) << name;
    const Topology before = topology(plain);
    const Topology after = topology(mesh);
    EXPECT_EQ(after.euler_number, before.euler_number) << name;
    EXPECT_EQ(after.boundary_loops, before.boundary_loops) << name;
    EXPECT_EQ(after.orientable, before.orientable) << name;
    EXPECT_EQ(after.shared_edges, before.shared_edges) << name;
  }
}

TEST(Colors, KeepLinesOnEdgesOfTheMesh) {
  const Mesh mesh = coloured(of_gallery("torus"), "sin(9*u)").mesh;
  const auto edges = edge_counts(mesh);
  for (const auto& line : mesh.lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      EXPECT_TRUE(edges.contains(point_edge(mesh, line[i - 1], line[i])));
    }
  }
}

TEST(Colors, StopAtTheLimitOfTrianglesAndSaySo) {
  Scene scene = scene_of("u", "v", "0");
  scene.mesh.max_triangles = 5000;
  const Tessellation t = coloured(scene, "sin(300*u)*sin(300*v)");
  EXPECT_LE(t.mesh.triangles.size(), 5000U);
  ASSERT_EQ(t.warnings.size(), 1U);
  EXPECT_NE(t.warnings[0].find("limit of triangles"), std::string::npos);
}

}  // namespace
}  // namespace saddle
