// Meshes for pictures that are stretched along an axis: as fine as they are drawn, and of the
// surface itself.
#include "meshing/stretch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "meshing/tessellate.h"
#include "scene/model/assignments.h"
#include "scene/model/instances.h"

namespace saddle {
namespace {

Scene stretched_scene(const std::vector<std::string>& assignments, const dvec3& factors) {
  Scene scene;
  for (const std::string& text : assignments) assign(scene, text);
  scene.scale = {.automatic = false, .factors = factors};
  return scene;
}

Tessellation mesh_for_picture(const Scene& scene) {
  return tessellate(scene, scene.surfaces[0], {.picture = true}, 2);
}

/// The largest angle between the interpolated and the true normal in the middle of a triangle, as
/// the picture has them.
double worst_normal(const Scene& scene, const Mesh& mesh) {
  const Surface surface = prepare_surface(scene, scene.surfaces[0]).surface;
  const dvec3 factors = scene.scale.factors;
  double worst = 0;
  for (const Triangle& t : mesh.triangles) {
    dvec2 uv(0);
    dvec3 normal(0);
    for (const auto corner : t) {
      uv += mesh.uv[corner] / 3.0;
      normal += glm::normalize(mesh.normal[corner] / factors);
    }
    const SurfacePoint point = evaluate(surface, std::vector{uv}, 1)[0];
    const dvec3 exact = glm::cross(point.r_u * factors, point.r_v * factors);
    worst = std::max(worst, degrees_between(normal, exact));
  }
  return worst;
}

void expect_exact(const Scene& scene, const Mesh& mesh) {
  const Surface surface = prepare_surface(scene, scene.surfaces[0]).surface;
  const std::vector<SurfacePoint> points =
      evaluate(surface, std::vector(mesh.uv.begin(), mesh.uv.end()), 1);
  std::size_t off = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    off += points[i].position == mesh.position[i] ? 0 : 1;
    const dvec3 normal = glm::normalize(glm::cross(points[i].r_u, points[i].r_v));
    EXPECT_LT(degrees_between(normal, mesh.normal[i]), 1e-6);
    EXPECT_NEAR(glm::length(mesh.normal[i]), 1, 1e-12);
  }
  EXPECT_EQ(off, 0U);
}

TEST(Stretch, IsTheNextPowerOfTwo) {
  const auto stretch = [](const dvec3& factors) {
    const Scene scene = stretched_scene({"z=u"}, factors);
    return mesh_stretch(scene, scene.surfaces[0], {.picture = true});
  };
  EXPECT_EQ(stretch({1, 1, 0.06}), dvec3(1, 1, 0.0625));
  EXPECT_EQ(stretch({1, 1, 100}), dvec3(1.0 / 128, 1.0 / 128, 1));
  EXPECT_EQ(stretch({7, 7, 7}), dvec3(1)) << "a larger picture of the same";
  Scene scene = stretched_scene({"z=u"}, {1, 1, 0.06});
  EXPECT_EQ(mesh_stretch(scene, scene.surfaces[0], {.mesh = true}), dvec3(1));
  scene.surfaces[0].in = {"node"};
  EXPECT_EQ(mesh_stretch(scene, scene.surfaces[0], {.picture = true}), dvec3(1));
}

TEST(Stretch, KeepsTheNormalToleranceAsItIsDrawn) {
  for (const dvec3& factors : {dvec3(1, 1, 0.06), dvec3(1, 1, 40), dvec3(0.3, 1, 2)}) {
    const Scene scene = stretched_scene({"z=0.1*sin(3*u)*cos(2*v)", "u=-3:3", "v=-3:3"}, factors);
    const Tessellation made = mesh_for_picture(scene);
    EXPECT_LT(worst_normal(scene, made.mesh), scene.mesh.normal_tolerance);
    expect_exact(scene, made.mesh);
  }
  // Without the stretch it is not kept.
  Scene flat = stretched_scene({"z=0.1*sin(3*u)*cos(2*v)", "u=-3:3", "v=-3:3"}, dvec3(1));
  const Tessellation made = mesh_for_picture(flat);
  flat.scale.factors = dvec3(1, 1, 40);
  EXPECT_GT(worst_normal(flat, made.mesh), 10);
}

TEST(Stretch, LeavesBoxesAndErrorsInTrueUnits) {
  Scene scene = stretched_scene({"z=u^2+v^2", "u=-10:10", "v=-10:10"}, {1, 1, 0.06});
  const Tessellation whole = mesh_for_picture(scene);
  EXPECT_EQ(whole.mesh.bounds.high, dvec3(10, 10, 200));
  scene.clip.box = Bounds{dvec3(-20, -20, -1), dvec3(20, 20, 50.3)};
  const Tessellation clipped = mesh_for_picture(scene);
  EXPECT_EQ(clipped.mesh.bounds.high.z, 50.3);
  // A length on the command line is a true one: a thousandth of the diagonal, 0.2.
  scene.clip.box.reset();
  scene.mesh.tolerance = ToleranceValue{1e-3, false};
  const Tessellation asked = mesh_for_picture(scene);
  EXPECT_NEAR(asked.report.tolerance.value(), 1e-3 * asked.mesh.bounds.diagonal(), 0.01);
  EXPECT_LE(asked.report.max_error, *asked.report.tolerance);
}

}  // namespace
}  // namespace saddle
