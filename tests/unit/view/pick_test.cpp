// Points under a pixel: on the surface itself, though only its mesh is hit.
#include "view/model/pick.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/mesher/grid_mesh.h"
#include "scene/model/assignments.h"
#include "scene/model/gallery.h"
#include "scene/model/prepare.h"

namespace saddle {
namespace {

Surface surface_of(const Scene& scene) {
  return prepare_surface(scene, scene.surfaces[0], Order::Second).surface;
}

/// What is picked of a coarse mesh of the surface.
std::optional<SurfacePlace> pick(const Surface& surface, const Ray& ray) {
  const Mesh mesh =
      mesh_on_grid(surface, {.cells_u = 24, .cells_v = 24, .lines_u = 0, .lines_v = 0}).mesh;
  const auto hit = first_hit(mesh, TriangleBoxes(mesh), ray);
  if (!hit) return std::nullopt;
  return place_on_surface(surface, ray, *hit);
}

TEST(Pick, FindsTheSurfaceUnderTheLineOfSight) {
  const Surface torus = surface_of(gallery_scene(*find_gallery_entry("torus")));
  for (int i = 0; i < 50; ++i) {
    // From outside toward the axis, at all heights of the tube.
    const double around = 0.37 * i;
    const double up = 0.7 * std::sin(1.7 * i);
    const dvec3 inward(-std::cos(around), -std::sin(around), 0);
    const auto place = pick(torus, {-10.0 * inward + dvec3(0, 0, up), inward});
    ASSERT_TRUE(place) << i;
    // R + sqrt(r^2 - z^2) from the axis; Newton leaves nothing but rounding.
    EXPECT_NEAR(place->position.z, up, 1e-12);
    EXPECT_NEAR(std::hypot(place->position.x, place->position.y), 2 + std::sqrt(0.64 - up * up),
                1e-9);
    ASSERT_TRUE(place->normal);
    EXPECT_LT(glm::dot(*place->normal, inward), 0) << "the outside is the front";
  }
}

TEST(Pick, TellsTheCurvaturesOfASphere) {
  const Surface sphere = surface_of(gallery_scene(*find_gallery_entry("sphere")));
  const auto place = pick(sphere, {{5, 0.1, 0.2}, {-1, 0, 0}});
  ASSERT_TRUE(place);
  const double radius = glm::length(place->position);
  EXPECT_NEAR(place->curvature.gauss * radius * radius, 1, 1e-9);
}

TEST(Pick, FindsNothingBesideOrBehind) {
  const Surface torus = surface_of(gallery_scene(*find_gallery_entry("torus")));
  EXPECT_FALSE(pick(torus, {{0, 0, 5}, {0, 0, -1}})) << "through the hole";
  EXPECT_FALSE(pick(torus, {{10, 0, 0}, {1, 0, 0}})) << "behind the eye";
}

TEST(Pick, StaysNearTheHitWhereNewtonsMethodGoesAstray) {
  Scene scene;
  assign(scene, "z=abs(u)");
  const auto place = pick(surface_of(scene), {{0.001, 0.3, 5}, {0, 0, -1}});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->position.x, 0.001, 1e-9);
  EXPECT_NEAR(place->position.y, 0.3, 1e-9);
}

}  // namespace
}  // namespace saddle
