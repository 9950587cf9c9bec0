// Tops of waves at edges of the surface: of the domain, of rims and of jumps.
#include <gtest/gtest.h>

#include "mesh/mesher/mesher.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// The mesh reaches as high as the surface within the tolerance, although the next vertex along the
/// edge may be anywhere on a steep slope.
TEST(EdgeTurns, MeshesReachTheTopsOfWavesAtEdges) {
  const struct {
    const char* z;
    Domain domain;
    double top;
  } cases[] = {{"40*cos(9*v)*u", {-1, 1, -1, 1}, 40},
               {"100*u*sin(3*v)", {-3, 3, -3, 3}, 300},
               {"u/(.05+v^2)", {-1, 1, -1, 1}, 20},
               {"(v>.013)?100*exp(-((u-.37)^2+v^2)/.001):nan", {-1, 1, -1, 1}, 84.4511},
               {"(v>.013)?1000*exp(-((u-.37)^2+v^2)/.001):0", {-1, 1, -1, 1}, 844.511},
               {"7*sign(v)*exp(-hypot(u-.37,v)/.01)", {-1, 1, -1, 1}, 7}};
  for (const auto& [z, domain, top] : cases) {
    const MeshResult result = try_mesh(height_field(z, domain), within_share(1e-3)).value();
    const double tolerance = *result.report.tolerance;
    EXPECT_GT(result.mesh.bounds.high.z, top - tolerance) << z;
    EXPECT_LT(result.mesh.bounds.high.z, top + tolerance) << z;
  }
}

}  // namespace
}  // namespace saddle
