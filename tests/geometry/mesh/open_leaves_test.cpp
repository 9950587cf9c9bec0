// Thin ridges, grooves and needles are in the mesh, or the report tells by how much it misses them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/triangle_tree.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr double kRidgeTolerance = 3e-3;

MeshResult ridge_mesh(const std::string& z) {
  return try_mesh(height_field(z), within_length(kRidgeTolerance)).value();
}

/// The largest distance of a curve, for -1 <= t <= 1, from a mesh.
double distance_of_curve(const Mesh& mesh, const std::function<dvec3(double)>& curve) {
  constexpr int kPoints = 2000;
  const TriangleTree tree(mesh);
  double worst = 0;
  for (int k = 0; k <= kPoints; ++k)
    worst = std::max(worst, tree.distance(curve(2.0 * k / kPoints - 1)));
  return worst;
}

TEST(OpenLeaves, AreInTheMeshAlongALineOfParameters) {
  struct Ridge {
    const char* z;
    double u, height;
  };
  // u exp(-u^2) has its extremes sqrt(1 / (2 e)) at u = sqrt(1 / 2).
  for (const Ridge& ridge :
       {Ridge{"exp(-((u-0.378522)*1e5)^2)", 0.378522, 1},
        Ridge{"min(1,abs(u-0.378522)/1e-4)", 0.378522, 0},
        Ridge{"(u-0.09205)/1.409e-4*exp(-((u-0.09205)/1.409e-4)^2)",
              0.09205 + 1.409e-4 * std::sqrt(0.5), std::sqrt(0.5 / std::exp(1.0))}}) {
    const MeshResult mesh = ridge_mesh(ridge.z);
    EXPECT_LE(mesh.report.max_error, kRidgeTolerance) << ridge.z;
    const auto crest = [&](double v) { return dvec3(ridge.u, v, ridge.height); };
    EXPECT_LE(distance_of_curve(mesh.mesh, crest), 1.02 * kRidgeTolerance) << ridge.z;
  }
}

TEST(OpenLeaves, AreToldWhereTheyAreTooLong) {
  for (const std::string z :
       {"min(1,abs(v-u^2)/7.655e-5)", "exp(-((v-u^2)/1e-5)^2)", "1/(1+((v-u^2)/2e-6)^2)"}) {
    const MeshResult mesh = ridge_mesh(z);
    const double height = z.starts_with("min") ? 0 : 1;
    const auto crest = [&](double u) { return dvec3(u, u * u, height); };
    const double found = distance_of_curve(mesh.mesh, crest);
    EXPECT_GE(1.1 * mesh.report.max_error, found) << z;
    EXPECT_LE(mesh.report.max_error, std::max(3 * found, kRidgeTolerance)) << z;
  }
}

TEST(OpenLeaves, ATipTooFineForTheMeshIsTold) {
  for (const std::string width : {"1e-4", "1.691e-5", "1.89e-6"}) {
    const MeshResult mesh = ridge_mesh("0.6*max(0,1-hypot(u-0.6275,v+0.668258)/" + width + ")");
    const double found = TriangleTree(mesh.mesh).distance({0.6275, -0.668258, 0.6});
    EXPECT_GE(1.1 * std::max(mesh.report.max_error, kRidgeTolerance), found) << width;
    EXPECT_LE(mesh.report.max_error, std::max(3 * found, kRidgeTolerance)) << width;
  }
}

// The chords from samples on both sides of a groove do not come near its wall.
/// The largest distance of the triangles of a mesh from the plane z = 2 u with a needle of no width
/// at `foot`, over the tolerance.
double distance_from_needle(const MeshResult& result, const dvec2& foot) {
  constexpr int kParts = 40;
  double worst = 0;
  for (const Triangle& t : result.mesh.triangles) {
    const auto& p = result.mesh.position;
    for (int i = 0; i <= kParts; ++i) {
      for (int j = 0; j <= kParts - i; ++j) {
        const dvec3 at =
            (double(i) * p[t[0]] + double(j) * p[t[1]] + double(kParts - i - j) * p[t[2]]) /
            double{kParts};
        const double from_plane = std::fabs(at.z - 2 * at.x) / std::sqrt(5);
        worst = std::max(worst, std::min(from_plane, glm::distance(dvec2(at), foot)));
      }
    }
  }
  return worst / *result.report.tolerance;
}

TEST(OpenLeaves, AMeshKeepsTheToleranceAtTheFootOfANeedleOnASlope) {
  struct Needle {
    const char* z;
    dvec2 foot;
  };
  for (const Needle& needle :
       {Needle{"2*u+max(0,1-hypot(u-0.3,v-0.1)/1e-5)", {0.3, 0.1}},
        Needle{"2*u+0.5*max(0,1-hypot(u-0.5,v+0.3195)/1e-4)", {0.5, -0.3195}},
        Needle{"2*u+0.7*max(0,1-hypot(u-0.6,v-0.6)/3e-5)", {0.6, 0.6}},
        Needle{"2*u+0.7*max(0,1-hypot(u-0.2,v-0.6)/1e-4)", {0.2, 0.6}}}) {
    const MeshResult result = try_mesh(height_field(needle.z), within_share(1e-3)).value();
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << needle.z;
    EXPECT_LE(distance_from_needle(result, needle.foot), 1.02) << needle.z;
  }
}

/// A corner of cells is at the tip, where derivatives are 0/0.
TEST(OpenLeaves, AMeshReachesTheTipOfANeedleWithoutTangents) {
  const dvec2 foot(0.2, -0.6111);
  for (const char* z : {"2*u+max(0,1-hypot(u-0.2,v+0.6111)/1e-7)",
                        "2*u+max(0,1-((u-0.2)^2+(v+0.6111)^2)^(1/4)/1e-3)"}) {
    const MeshResult result = try_mesh(height_field(z), within_share(1e-3)).value();
    const double from_tip = TriangleTree(result.mesh).distance(dvec3(foot, 2 * foot.x + 1));
    EXPECT_LE(from_tip, *result.report.tolerance) << z;
    EXPECT_LE(distance_from_needle(result, foot), 1.02) << z;
  }
}

TEST(OpenLeaves, AMeshDownAGrooveIsNotFalselyOff) {
  const MeshResult mesh = ridge_mesh("0.7637*u-0.8685*exp(-(u/1.943e-5)^2)");
  const auto crest = [](double v) { return dvec3(0, v, -0.8685); };
  EXPECT_LE(distance_of_curve(mesh.mesh, crest), kRidgeTolerance);
  EXPECT_LE(mesh.report.max_error, kRidgeTolerance);
}

}  // namespace
}  // namespace saddle
