// The mesh for a camera that is close to a surface: as fine as its picture needs where it looks,
// and no finer elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/gallery/samples.h"
#include "meshing/tessellate.h"
#include "view/model/pick.h"

namespace saddle {
namespace {

/// Places that are looked at, each way.
constexpr int kPlaces = 12;

dvec3 normal_of(const SurfacePoint& point) {
  return glm::normalize(glm::cross(point.r_u, point.r_v));
}

/// A surface as a camera sees it from this distance of a point of it.
struct CloseUp {
  Scene scene;
  Mesh mesh;
  Grip grip;

  CloseUp(const std::string& name, const dvec2& uv, double distance, bool ortho = false)
      : scene(scene_of(name)) {
    const Surface surface = prepare_surface(scene, scene.surfaces[0], Order::First).surface;
    const SurfacePoint target = evaluate(surface, std::vector{uv}, 1)[0];
    scene.camera.target = target.position;
    scene.camera.distance = distance;
    scene.camera.ortho = ortho;
    scene.camera.view = normal_of(target) + dvec3(0.1, 0.2, 0.3);
    mesh = tessellate(scene, scene.surfaces[0], {.picture = true}, 1).mesh;
    const dvec2 size(scene.picture.width, scene.picture.height);
    grip = {scene.camera, fit_camera(scene.camera, mesh.bounds, size.x / size.y), size};
  }

  /// The largest distance of the surface from the mesh, in pixels of the picture, over places all
  /// over the picture. `seen`: in how many of them there is something.
  double worst_pixels(int& seen) const {
    const Surface surface = prepare_surface(scene, scene.surfaces[0], Order::First).surface;
    const TriangleBoxes boxes(mesh);
    double worst = 0;
    seen = 0;
    for (int y = 0; y < kPlaces; ++y) {
      for (int x = 0; x < kPlaces; ++x) {
        const Ray ray = ray_through(grip, grip.size * dvec2(x + 0.5, y + 0.5) / double(kPlaces));
        const auto hit = first_hit(mesh, boxes, ray);
        if (!hit) continue;
        ++seen;
        const SurfacePoint point = evaluate(surface, std::vector{hit->uv}, 1)[0];
        const dvec3 off = point.position - ray.origin - hit->distance * ray.direction;
        const double depth = scene.camera.ortho ? grip.fitted.distance : hit->distance;
        const double tangent = std::tan(0.5 * scene.camera.fov * std::numbers::pi / 180);
        const double pixel = 2 * depth * tangent / grip.size.y;
        worst = std::max(worst, std::fabs(glm::dot(off, normal_of(point))) / pixel);
      }
    }
    return worst;
  }
};

class CloseUps : public ::testing::TestWithParam<const char*> {};

TEST_P(CloseUps, AreSmoothAndTakeAboutAsManyTrianglesAsTheWhole) {
  const Scene whole = scene_of(GetParam());
  const std::size_t most =
      4 * tessellate(whole, whole.surfaces[0], {.picture = true}, 1).mesh.triangles.size();
  for (const double distance : {1.0, 0.1, 0.01, 0.001}) {
    for (const bool ortho : {false, true}) {
      const CloseUp close(GetParam(), {1.1, 0.7}, distance, ortho);
      int seen = 0;
      EXPECT_LE(close.worst_pixels(seen), 0.5) << distance;
      EXPECT_GT(seen, kPlaces * kPlaces / 2) << distance;
      EXPECT_LE(close.mesh.triangles.size(), most) << distance;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gallery, CloseUps,
                         ::testing::Values("torus", "klein-figure8", "sphere", "helicoid"));

TEST(CloseUp, KeepsNothingFromTheEye) {
  const CloseUp close("torus", {1.1, 0.7}, 1e-3);
  EXPECT_LT(close.grip.fitted.near_plane, 0.2e-3);
}

}  // namespace
}  // namespace saddle
