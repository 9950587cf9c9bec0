// Zeros of r_u x r_v between samples: where they are, what they are, and that meshes have them.
#include "mesh/features/singular.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/gallery/samples.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/topology.h"
#include "mesh_requests.h"
#include "surface/normal.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

SingularSet singular_set(const Surface& surface) {
  return find_singular(surface, Probe(surface, 1).dips(), {}, {}, 1);
}

SingularSet singular_set(const std::string& x, const std::string& y, const std::string& z) {
  return singular_set(surface_from_text(x, y, z, {-1, 1, -1, 1}, {}, Order::Second));
}

/// Digits of a double that a place may lose.
constexpr double kDigits = 1e-14;

TEST(Singular, AreFoundToDoublePrecision) {
  // A cross cap, and a branch point: there, all of r_u and r_v is 0.
  const SingularSet cap = singular_set("(u-0.1234)*(v+0.4321)", "u", "(v+0.4321)^2");
  ASSERT_EQ(cap.points.size(), 1U);
  EXPECT_NEAR(cap.points[0].x, 0.1234, kDigits);
  EXPECT_NEAR(cap.points[0].y, -0.4321, kDigits);
  const SingularSet branch =
      singular_set("(u-0.3)^2-(v+0.2)^2", "2*(u-0.3)*(v+0.2)", "(u-0.3)^3-3*(u-0.3)*(v+0.2)^2");
  ASSERT_EQ(branch.points.size(), 1U);
  EXPECT_NEAR(branch.points[0].x, 0.3, kDigits);
  EXPECT_NEAR(branch.points[0].y, -0.2, kDigits);
  for (const SingularSet& set : {cap, branch}) {
    EXPECT_TRUE(set.on_curves.empty() && set.lines_u.empty() && set.lines_v.empty());
  }
}

TEST(Singular, TellsLinesAndCurvesFromPoints) {
  const SingularSet line = singular_set("u", "(v-0.137)^2", "(v-0.137)^3");
  EXPECT_TRUE(line.points.empty() && line.on_curves.empty() && line.lines_u.empty());
  ASSERT_EQ(line.lines_v.size(), 1U);
  EXPECT_NEAR(line.lines_v[0], 0.137, kDigits);

  const SingularSet curve = singular_set("u*v^2+3*v^4", "-2*u*v-4*v^3", "u");  // swallowtail
  EXPECT_TRUE(curve.points.empty() && curve.lines_u.empty() && curve.lines_v.empty());
  EXPECT_GT(curve.on_curves.size(), 16U);
  for (const dvec2& uv : curve.on_curves) EXPECT_NEAR(uv.x + 6 * uv.y * uv.y, 0, kDigits);
}

TEST(Singular, AreNoneOfRegularSurfaces) {
  for (const char* const z : {"u^2-v^2", "1e9*u*v", "1e20*u*v", "tanh(40*u)", "sin(9*u)*sin(7*v)",
                              "u^3-3*u*v^2", "exp(-200*(u^2+v^2))", "1e-9*u*v"}) {
    EXPECT_TRUE(singular_set("u", "v", z).empty()) << z;
  }
  for (const char* const name : {"klein-figure8", "trefoil-tube", "henneberg", "enneper"}) {
    const Scene scene = scene_of(name);
    const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
    EXPECT_TRUE(singular_set(surface).empty()) << name;
  }
}

/// Each of the points of a gallery surface, that many.
struct PointUnion {
  const char* name;
  std::size_t count;
};

TEST(Singular, AreCountedAsMathematicsDoes) {
  // Copies on closing edges count.
  for (const PointUnion& points :
       {PointUnion{"whitney-umbrella", 1}, PointUnion{"bohemian-dome", 6}, PointUnion{"catalan", 3},
        PointUnion{"riemann-asin", 2}, PointUnion{"bent-horns", 8}, PointUnion{"guimard", 3},
        PointUnion{"plucker-conoid", 4}, PointUnion{"pillow", 6}, PointUnion{"cross-cap", 3}}) {
    const Scene scene = scene_of(points.name);
    const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
    EXPECT_EQ(singular_set(surface).points.size(), points.count) << points.name;
  }
}

/// With so many lines each way.
MeshResult mesh_with(const Surface& surface, double share, int lines) {
  MeshRequest options = within_share(share);
  options.lines = {lines, lines};
  return try_mesh(surface, options).value();
}

std::size_t count_at(const MeshReport& report, const dvec2& uv) {
  return static_cast<std::size_t>(std::ranges::count_if(
      report.singular_points,
      [&](const SingularPoint& point) { return glm::distance(point.uv, uv) < kDigits; }));
}

TEST(Singular, AreVerticesWhateverLinesAreDrawn) {
  const Surface surface = surface_from_text("(u-0.1234)*(v+0.4321)", "u", "(v+0.4321)^2",
                                            {-1, 1, -1, 1}, {}, Order::Second);
  for (const int lines : {0, 2, 9, 16}) {
    const MeshResult mesh = mesh_with(surface, 1e-3, lines);
    EXPECT_EQ(count_at(mesh.report, {0.1234, -0.4321}), 1U) << lines;
    EXPECT_EQ(mesh.report.singular_point_count, 1U) << lines;
    EXPECT_TRUE(std::ranges::any_of(mesh.mesh.uv, [](const dvec2& uv) {
      return glm::distance(uv, {0.1234, -0.4321}) < kDigits;
    })) << lines;
    EXPECT_LE(mesh.report.max_error, *mesh.report.tolerance);
  }
}

TEST(Singular, PinchesAreOnePointWhateverLinesAreDrawn) {
  for (const auto& [name, euler] : {std::pair("horn-torus", 1L), std::pair("bent-horns", 3L)}) {
    const Scene scene = scene_of(name);
    const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
    for (const int lines : {0, 9, 16}) {
      for (const double share : {1e-2, 1e-3}) {
        EXPECT_EQ(topology(mesh_with(surface, share, lines).mesh).euler_number, euler)
            << name << ' ' << lines << ' ' << share;
      }
    }
  }
}

TEST(Singular, AreNamedWhereNoVertexMeetsThem) {
  const Surface surface =
      surface_from_text("u*(v-0.1)", "u", "(v-0.1)^2", {-1, 1, -1, 1}, {}, Order::Second);
  const MeshResult mesh = try_mesh(surface, with_samples(within_length(1e-3), 21, 17)).value();
  EXPECT_EQ(count_at(mesh.report, {0, 0.1}), 1U);
  EXPECT_EQ(mesh.report.singular_point_count, 1U);
}

/// Tangents that are as good as parallel, of which r_u x r_v has all digits.
TEST(Singular, AreNoneOfSteepSurfaces) {
  for (const char* const z : {"1e9*u*v", "1e8*sin(3*u)*v", "1e13*u*v"}) {
    const Surface surface = height_field(z);
    const MeshResult mesh = mesh_with(surface, 1e-3, 16);
    EXPECT_EQ(mesh.report.singular_point_count, 0U) << z;
    EXPECT_GT(mesh.mesh.triangles.size(), 100U) << z;
  }
  const SurfacePoint steep{dvec3(0), dvec3(1, 0, 1e9), dvec3(0, 1, 1e9)};
  EXPECT_LT(glm::length(glm::cross(steep.r_u, steep.r_v)), 1e-7 * 1e9 * 1e9);
  const auto normal = known_normal(steep, false);
  ASSERT_TRUE(normal);
  EXPECT_NEAR(normal->x, -std::sqrt(0.5), 1e-15);
  EXPECT_EQ(known_normal(steep, true), -*normal);
  // The other way: x = cos(u + v) and so on is a curve, and its cross product is rounding.
  const dvec3 tangent(-std::sin(0.7), std::cos(0.7), 1);
  EXPECT_FALSE(known_normal({dvec3(0), tangent, tangent * (1 + 1e-15)}, false));
}

/// sin(pi) is 1.2e-16 and cos(pi/2) is 6e-17 in doubles: their quotient is 0.5, and 0 beside it.
TEST(Singular, PositionsThatAreRoundingTakeTheirLimits) {
  const Domain domain = {0, 2 * kPi, 0, kPi};
  const MeshResult field =
      try_mesh(height_field("cos(pi/2*cos(v))/sin(v)", domain), within_share(1e-3)).value();
  EXPECT_LE(field.report.max_error, *field.report.tolerance);
  const std::string r = "cos(pi/2*cos(v))/sin(v)";
  const MeshResult dipole = try_mesh(surface_from_text(r + "*sin(v)*cos(u)", r + "*sin(v)*sin(u)",
                                                       r + "*cos(v)", domain, {}, Order::Second),
                                     within_share(1e-3))
                                .value();
  EXPECT_LE(dipole.report.max_error, *dipole.report.tolerance);
  for (const Mesh& mesh : {field.mesh, dipole.mesh}) {
    double lowest = 1;
    for (std::size_t k = 0; k < mesh.uv.size(); ++k) {
      if (mesh.uv[k].y > kPi - 1e-9) lowest = std::min(lowest, std::fabs(mesh.position[k].z));
      if (mesh.uv[k].y > kPi - 1e-9) EXPECT_NEAR(mesh.position[k].z, 0, 1e-5);
    }
    EXPECT_LT(lowest, 1) << "no vertex at the end";
  }
}

}  // namespace
}  // namespace saddle
