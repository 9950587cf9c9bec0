// Uniform grids of surfaces that a plain grid would bridge, tear or leave jagged.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/error.h"
#include "geometry/gallery/samples.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/topology.h"
#include "mesh/model/triangle_tree.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

MeshResult sampled(const Surface& surface, std::size_t cells = 20) {
  return try_mesh(surface, with_samples(within_share(1e-3), cells, cells)).value();
}

MeshResult sampled(const std::string& z, const Domain& domain = {-1, 1, -1, 1}) {
  return sampled(height_field(z, domain));
}

/// Triangles with corners on both sides.
template <class Side>
std::size_t bridges(const Mesh& mesh, Side side) {
  std::size_t count = 0;
  for (const Triangle& t : mesh.triangles) {
    std::set<double> sides;
    for (const std::uint32_t corner : t) sides.insert(side(mesh.uv[corner].x, mesh.uv[corner].y));
    if (sides.size() > 1) ++count;
  }
  return count;
}

TEST(SampledMesh, OfWhatIsSmoothHasTwoTrianglesInEachCell) {
  for (const char* z : {"u*v", "exp(-u*u-v*v)", "sin(3*u)*cos(2*v)"}) {
    EXPECT_EQ(sampled(z).mesh.triangles.size(), 800U) << z;
  }
  for (const char* name :
       {"torus", "klein-bottle", "klein-figure8", "whitney-umbrella", "mobius"}) {
    const Scene scene = scene_of(name);
    const MeshResult mesh =
        sampled(prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface);
    EXPECT_EQ(mesh.mesh.triangles.size(), 800U) << name;
    EXPECT_FALSE(mesh.report.certified);
    EXPECT_FALSE(mesh.report.reached_limit);
    EXPECT_FALSE(mesh.report.tolerance);
  }
  const Scene scene = scene_of("sphere");  // a row of one triangle each at the poles
  const Surface sphere = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
  EXPECT_EQ(sampled(sphere).mesh.triangles.size(), 800U - 40);
}

TEST(SampledMesh, IsLeftToThePlainGridWhereLinesCannotBeNumbered) {
  const Surface rough = height_field("abs(u)");
  EXPECT_FALSE(try_mesh(rough, with_samples(within_length(1e-3), 100000, 2)));
}

TEST(SampledMesh, EndsOnTheRim) {
  const Mesh m = sampled("sqrt(1-u^2-v^2)", {-1.2, 1.2, -1.2, 1.2}).mesh;
  std::vector<dvec3> place(m.point_count);
  for (std::size_t k = 0; k < m.point.size(); ++k) place[m.point[k]] = m.position[k];
  std::size_t boundary = 0;
  for (const auto& [edge, count] : edge_counts(m)) {
    if (count != 1) continue;
    ++boundary;
    EXPECT_NEAR(std::hypot(place[edge.first].x, place[edge.first].y), 1, 1e-6);
    EXPECT_NEAR(place[edge.first].z, 0, 1e-6);
  }
  EXPECT_GT(boundary, 40U);
  EXPECT_NEAR(area(m), 2 * kPi, 0.03 * 2 * kPi);
}

TEST(SampledMesh, BridgesNoPole) {
  const MeshResult hyperbola = sampled("1/u");
  EXPECT_GT(hyperbola.report.pole_count, 0U);
  EXPECT_EQ(bridges(hyperbola.mesh, [](double u, double) { return u > 0; }), 0U);
  const MeshResult tangent = sampled("tan(u)", {-5, 5, -1, 1});
  EXPECT_GT(tangent.report.pole_count, 0U);
  EXPECT_EQ(bridges(tangent.mesh, [](double u, double) { return std::floor(u / kPi + 0.5); }), 0U);
}

/// On the line u = 0 itself nothing is defined.
TEST(SampledMesh, TellsOfJumpsAndPolesAlongLinesOfTheGrid) {
  EXPECT_GT(sampled("abs(u)/u").report.jump_count, 10U);
  EXPECT_EQ(sampled("sin(u)/u").report.jump_count, 0U);
  const MeshResult hyperbola = sampled("1/u");
  EXPECT_EQ(hyperbola.report.jump_count, 0U);
  EXPECT_LT(hyperbola.report.beside_poles.low.z, -1e6);
  EXPECT_GT(hyperbola.report.beside_poles.high.z, 1e6);
}

/// 0/0 along u = 0, a line of the grid. The last values before it may be cancellation: of 1 -
/// cos(u) nothing is left for |u| < 1e-8.
TEST(SampledMesh, FillsLinesWithTheirLimit) {
  for (const auto& [z, at_line, rounding] :
       {std::tuple("sin(u)/u", 1.0, 1e-9), std::tuple("(1-cos(u))/u^2", 0.5, 1e-4),
        std::tuple("v*sin(u)/u", 0.0, 1e-9)}) {
    const MeshResult filled = sampled(z);
    EXPECT_EQ(topology(filled.mesh).boundary_loops, 1U) << z;
    EXPECT_EQ(topology(filled.mesh).components, 1U) << z;
    EXPECT_EQ(filled.report.undefined_fraction, 0) << z;
    const auto on_line = std::ranges::find(filled.mesh.uv, dvec2(0));
    ASSERT_NE(on_line, filled.mesh.uv.end()) << z;
    EXPECT_NEAR(filled.mesh.position[static_cast<std::size_t>(on_line - filled.mesh.uv.begin())].z,
                at_line, rounding)
        << z;
  }
  EXPECT_EQ(topology(sampled("abs(u)/u").mesh).components, 2U) << "a jump is none";
}

TEST(SampledMesh, GoesUpToJumpsOnEitherSide) {
  const MeshResult steps = sampled("floor(3*u)");
  EXPECT_GT(steps.report.jump_count, 0U);
  EXPECT_EQ(bridges(steps.mesh, [](double u, double) { return std::min(std::floor(3 * u), 2.0); }),
            0U);
  EXPECT_NEAR(area(steps.mesh), 4, 1e-9);
}

TEST(SampledMesh, GoesUpToJumpsAlongASheet) {
  for (const char* const x : {"u+sign(u)", "u+0.02*sign(u-0.03)"}) {
    const MeshResult sheets =
        sampled(surface_from_text(x, "v", "0", {-1, 1, -1, 1}, {}, Order::Second), 15);
    EXPECT_GT(sheets.report.jump_count, 0U) << x;
    EXPECT_NEAR(area(sheets.mesh), 4, 1e-9) << x;
  }
}

TEST(SampledMesh, GoesUpToJumpsAlongASheetInAnyOfItsCells) {
  // Bounds are looked at in few boxes: more where they do not exclude a jump.
  for (const char* const at : {"-0.723", "0.723"}) {
    const std::string y = std::string("v+0.004*sign(v-(") + at + "))+0.001*sin(u*v)";
    const Surface sheet =
        surface_from_text("u+0.001*sin(u)", y.c_str(), "0", {-1, 1, -1, 1}, {}, Order::Second);
    EXPECT_EQ(sampled(sheet, 200).report.jump_count, 201U) << at;
  }
}

TEST(SampledMesh, HasItsCreasesAsEdges) {
  const MeshResult fold = sampled("abs(u-v+0.03)");
  EXPECT_LE(fold.report.max_error, 1e-12);
  for (const Triangle& t : fold.mesh.triangles) {
    double least = 0;
    double most = 0;
    for (const std::uint32_t corner : t) {
      const double beside = fold.mesh.uv[corner].x - fold.mesh.uv[corner].y + 0.03;
      least = std::min(least, beside);
      most = std::max(most, beside);
    }
    EXPECT_TRUE(least > -1e-12 || most < 1e-12) << least << " to " << most;
  }
}

/// A spike 1 high and 1e-3 wide, between all samples.
TEST(SampledMesh, TellsOfSpikesBetweenItsSamples) {
  const MeshResult spike = sampled("exp(-1e6*((u-0.312)^2+(v-0.17)^2))", {-1, 1, -1, 1});
  EXPECT_LE(spike.report.max_error, 1);
  EXPECT_GE(spike.report.max_error, 1 / 1.1);
  EXPECT_EQ(spike.mesh.triangles.size(), 800U);
}

/// A square between all samples, on which alone the surface is defined.
TEST(SampledMesh, SaysWhereASurfaceIsThatItsSamplesMiss) {
  try {
    sampled("(max(abs(u-0.35),abs(v+0.25))<0.01)?u*v:nan", {-1, 1, -1, 1});
    ADD_FAILURE() << "a mesh of nothing";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Nothing);
    EXPECT_EQ(std::string(error.what()), "the surface is defined only between the samples");
    double u = 0;
    double v = 0;
    ASSERT_EQ(std::sscanf(error.hint().c_str(), "it is near u = %lf, v = %lf", &u, &v), 2);
    EXPECT_LE(std::max(std::fabs(u - 0.35), std::fabs(v + 0.25)), 0.0101);
  }
}

/// Chords of a parabola u^2 between 20 cells of 0.1 are (0.1/2)^2 off at most.
TEST(SampledMesh, TellsTheErrorOfChords) {
  const MeshResult parabola = sampled("u^2", {-1, 1, -1, 1});
  EXPECT_LE(parabola.report.max_error, 0.0025 * (1 + 1e-9));
  EXPECT_GE(parabola.report.max_error, 0.0025 / 1.1);
}

/// The distance of a point of a triangle from z = tanh(100 (r^2 - 1/2)), bounded by those along z
/// and along r.
double distance_from_wall(const dvec3& p) {
  const double r = std::hypot(p.x, p.y);
  const double along_z = std::fabs(p.z - std::tanh(100 * (r * r - 0.5)));
  const double square = 0.5 + std::atanh(p.z) / 100;
  return square >= 0 ? std::min(along_z, std::fabs(r - std::sqrt(square))) : along_z;
}

/// The wall is a third of a cell wide: triangles lean against it.
TEST(SampledMesh, TellsNoLargerErrorThanThatOfTheWholeMesh) {
  const MeshResult wall = sampled(height_field("tanh(100*(u^2+v^2-0.5))"), 40);
  const Mesh& mesh = wall.mesh;
  const TriangleTree tree(mesh);
  double of_surface = 0;
  for (int i = 0; i <= 400; ++i) {
    for (int j = 0; j <= 400; ++j) {
      const dvec2 p = dvec2(i, j) / 200.0 - 1.0;
      const double z = std::tanh(100 * (glm::dot(p, p) - 0.5));
      of_surface = std::max(of_surface, tree.distance(dvec3(p, z)));
    }
  }
  double of_mesh = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; i + j <= 8; ++j) {
        const dvec3 weights = dvec3(i, j, 8 - i - j) / 8.0;
        const auto& at = mesh.position;
        of_mesh = std::max(of_mesh, distance_from_wall(weights.x * at[t[0]] + weights.y * at[t[1]] +
                                                       weights.z * at[t[2]]));
      }
    }
  }
  EXPECT_GE(wall.report.max_error, of_surface);
  EXPECT_LE(wall.report.max_error, 1.2 * std::max(of_surface, of_mesh));
}

/// Jumps of which no triangle joins both sides.
TEST(SampledMesh, BridgesNoJump) {
  const MeshResult wave = sampled(height_field("(v>0.5*sin(5*u))?u+3:-u-3"), 64);
  EXPECT_GT(wave.report.jump_count, 50U);
  std::size_t joined = 0;
  for (const Triangle& t : wave.mesh.triangles) {
    std::set<bool> sides;
    for (const std::uint32_t corner : t) sides.insert(wave.mesh.position[corner].z > 0);
    if (sides.size() > 1) ++joined;
  }
  EXPECT_EQ(joined, 0U);
  EXPECT_LE(wave.report.max_error, 5e-3);
}

}  // namespace
}  // namespace saddle
