// What a grid mesh says about itself: errors, evaluations, and surfaces that are none.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "mesh/mesher/grid_mesh.h"
#include "mesh/model/mesh_report.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

GridOptions options_of(int u, int v) {
  GridOptions options;
  options.cells_u = u;
  options.cells_v = v;
  return options;
}

/// The message of the error that meshing ends in; its status must be Nothing.
std::string refusal(const std::string& x, const std::string& y, const std::string& z,
                    const Domain& domain = {}, const GridOptions& options = options_of(20, 20)) {
  try {
    mesh_on_grid(surface_from_text(x, y, z, domain), options);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Nothing);
    EXPECT_FALSE(error.hint().empty());
    return error.what();
  }
  return "a mesh";
}

TEST(GridMeshReport, MeasuresTheErrorOfATorus) {
  const Surface torus = surface_from_text("(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)",
                                          {0, 2 * kPi, 0, 2 * kPi});
  for (const int n : {30, 120}) {  // all cells are measured, and a choice of them
    const double h = 2 * kPi / n;
    const double largest = (3 * h * h + h * h) / 8;  // over a diagonal at the outer equator
    const MeshReport report = mesh_on_grid(torus, options_of(n, n)).report;
    EXPECT_LT(report.max_error, largest) << n;
    // 4 % for points up to a tenth of a cell off the middle; the fourth order of the series.
    EXPECT_GT(report.max_error, largest * (0.96 - h * h)) << n;
  }
}

TEST(GridMeshReport, MeasuresTheErrorOfNormals) {
  const Surface parabola = surface_from_text("u", "v", "u^2/2", {0, 2, 0, 1});
  const MeshReport report = mesh_on_grid(parabola, options_of(8, 8)).report;
  // Between corners the mesh interpolates the angle a = atan(u), linearly to this order, which is
  // off by g |a''|, g = h^2/8. The mesh point nearest to a surface point, g above the chord, is
  // g sin(a) cos(a) further along, where the angle differs by that times a'. The two add up to
  // 3 g u / (1 + u^2)^2, largest at u = 1/sqrt(3). The next order is h times smaller.
  const double h = 0.25;
  const double largest = 3 * h * h / 8 * 9 / (16 * std::sqrt(3)) * 180 / kPi;
  EXPECT_LT(report.max_normal_error, largest * (1 + h));
  EXPECT_GT(report.max_normal_error, largest * (0.96 - h * h));
}

TEST(GridMeshReport, IsExactForAPlane) {
  const MeshReport report =
      mesh_on_grid(surface_from_text("u", "v", "u+v", {}), options_of(7, 3)).report;
  EXPECT_LT(report.max_error, 1e-15);
  EXPECT_LT(report.max_normal_error, 1e-13);
  EXPECT_EQ(report.cells, 21U);
  EXPECT_EQ(report.undefined_fraction, 0);
}

TEST(GridMeshReport, CountsEveryPointThatIsComputed) {
  const Surface plane = surface_from_text("u", "v", "u+v", {});
  const std::size_t before = plane.evaluations();
  const MeshReport report = mesh_uniformly(plane, {options_of(7, 3), {}, {}}).report;
  EXPECT_EQ(report.evaluations, plane.evaluations() - before);
  constexpr std::size_t kVertices = 8 * 4;
  constexpr std::size_t kMeasured = 3 * 21;  // three a cell
  EXPECT_GE(report.evaluations, kVertices + kMeasured);
}

TEST(GridMeshReport, IsHalvedUntilThatDoesNotHelp) {
  // Some cells lie flat between waves of any size that they cannot show.
  const Surface waves = surface_from_text("u", "v", "sin(1e5*u)", {});
  const MeshReport stopped = mesh_uniformly(waves, {options_of(20, 20), 1e-3, {}}).report;
  EXPECT_GT(stopped.max_error, 0.5);
  EXPECT_LE(stopped.cells, 160U * 160);
  // At its apex a cell of side h is off by h^2 / 2: 0.005 for 20 of them, 0.00125 for 40.
  const Surface paraboloid = surface_from_text("u", "v", "u^2+v^2", {});
  const MeshReport halved = mesh_uniformly(paraboloid, {options_of(5, 5), 1e-3, {}}).report;
  EXPECT_LE(halved.max_error, *halved.tolerance);
  EXPECT_EQ(halved.cells, 40U * 40);
}

TEST(GridMeshReport, FindsOutASurfaceThatOscillatesInStepWithTheGrid) {
  const Surface waves = surface_from_text("u", "v", "sin(60*u)", {0, 2 * kPi, 0, 1});
  const MeshReport report = mesh_on_grid(waves, options_of(60, 4)).report;
  EXPECT_GT(report.max_error, 0.5);
  EXPECT_GT(report.max_normal_error, 90);
}

TEST(GridMeshReport, FindsTheWorstCellsOfALargeGrid) {
  const Surface bump = surface_from_text("u", "v", "exp(-400*(u^2+v^2))", {});
  const MeshReport report = mesh_on_grid(bump, options_of(201, 201)).report;
  // z_uu + z_vv = -1600 at the top: the sagitta over the diagonal of the middle cell.
  const double h = 2.0 / 201;
  EXPECT_GT(report.max_error, 0.9 * 1600 * h * h / 8);
}

TEST(GridMeshReport, SaysThatASurfaceIsUndefinedEverywhere) {
  EXPECT_EQ(refusal("u", "v", "sqrt(-1-u^2)"), "the surface is undefined everywhere");
}

TEST(GridMeshReport, SaysThatASurfaceIsDefinedAtIsolatedSamples) {
  EXPECT_EQ(refusal("u", "v", "sqrt(-(u^2))"), "the surface is defined at isolated samples only");
}

TEST(GridMeshReport, SaysThatASurfaceIsAPoint) {
  EXPECT_EQ(refusal("1", "2", "-0.5"), "the surface is a single point, (1, 2, -0.5)");
}

TEST(GridMeshReport, SaysThatASurfaceIsALine) {
  EXPECT_EQ(refusal("u", "2*u", "3*u"), "the surface is a straight line");
  EXPECT_EQ(refusal("u+v", "2*(u+v)", "1"), "the surface is a straight line");
}

TEST(GridMeshReport, SaysThatASurfaceIsACurve) {
  EXPECT_EQ(refusal("cos(v)", "sin(v)", "0"), "the surface is a curve");
  // No cell is flat here: neighbouring samples are three points of a helix.
  EXPECT_EQ(refusal("cos(u+v)", "sin(u+v)", "u+v"), "the surface is a curve");
}

TEST(GridMeshReport, SaysThatTheSamplesAreTooFew) {
  EXPECT_EQ(
      refusal("cos(u)*sin(v)", "sin(u)*sin(v)", "cos(v)", {0, 2 * kPi, 0, kPi}, options_of(1, 1)),
      "no cell of the grid has any area");
}

TEST(GridMeshReport, SaysThatARangeHoldsFewDoubles) {
  EXPECT_EQ(refusal("u", "v", "u*v", {1, 1 + 2e-14, -1, 1}),
            "the range of u is too short for double precision");
  EXPECT_EQ(refusal("u", "v", "u*v", {-1, 1, 1e6 + 2e-9, 1e6}),
            "the range of v is too short for double precision");
}

TEST(GridMeshReport, SaysThatTheExtentIsNotFinite) {
  EXPECT_EQ(refusal("1e308*u", "1e308*v", "0"), "the surface has no finite extent");
}

TEST(GridMeshReport, TellsASurfaceThatIsSingularAtAllSamplesFromACurve) {
  // x_u = 6 u (1 - u) is 0 at both ends of the only cell.
  EXPECT_EQ(refusal("u^2*(3-2*u)", "v", "0", {0, 1, 0, 1}, options_of(1, 1)), "a mesh");
}

TEST(GridMeshReport, TellsAThinStripFromACurve) {
  EXPECT_EQ(refusal("cos(u)", "sin(u)", "1e-9*v"), "a mesh");
}

TEST(GridMeshReport, TellsASmallSurfaceFarAwayFromAPoint) {
  EXPECT_EQ(refusal("1e7+1e-3*u", "1e7+1e-3*v", "1e7+1e-3*u*v"), "a mesh");
  EXPECT_EQ(refusal("u", "v", "1e16"), "a mesh");
}

TEST(GridMeshReport, RefusesGridsThatCannotBeNumbered) {
  const Surface plane = surface_from_text("u", "v", "0", {});
  try {
    mesh_on_grid(plane, options_of(1 << 20, 1 << 20));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::Input);
  }
}

}  // namespace
}  // namespace saddle
