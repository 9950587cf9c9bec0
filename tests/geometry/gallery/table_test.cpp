// Every surface of the gallery against its entry of the table: extents, equation, curvature,
// topology and report. A surface without an entry fails.
#include <algorithm>
#include <array>
#include <set>

#include <glm/vector_relational.hpp>

#include "geometry/gallery/forms.h"
#include "geometry/gallery/table.h"
#include "mesh/mesher/grid_mesh.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/topology.h"
#include "surface/normal.h"

namespace saddle {
namespace {

TEST(Gallery, HasFactsOfEachSurfaceOfTheList) {
  std::multiset<std::string> listed;
  std::multiset<std::string> known;
  for (const GalleryEntry& entry : gallery()) listed.emplace(entry.name);
  for (const GalleryFacts& facts : gallery_facts()) known.insert(facts.name);
  EXPECT_EQ(known, listed);
}

class GalleryTable : public testing::TestWithParam<std::string> {
 protected:
  const GalleryFacts& facts() const {
    return *std::ranges::find(gallery_facts(), GetParam(), &GalleryFacts::name);
  }
};

/// Whether the clip box, if there is one, holds the point.
bool is_drawn(const Scene& scene, const dvec3& p) {
  return !scene.clip.box || scene.clip.box->contains(p);
}

/// Of points of a grid that includes the ends of both ranges, that are drawn, and of the mesh,
/// whose rims are where a condition or the clip box ends the surface.
void expect_extents(const GalleryFacts& facts, const Scene& scene, const Mesh& mesh) {
  // A peak is missed by half a step at most. The formulas have up to 12 waves in a range, 32 steps
  // for each: 1 - cos(pi / 32) = 0.48 %. The table's rounding is far less. Clip boxes are met by
  // points as well: a wall that rises to one does so over some tens of steps.
  constexpr int kPoints = 12 * 32 + 1;
  constexpr double kTolerance = 5e-3;
  Bounds bounds;
  bool is_holed = false;
  for (const SurfacePoint& point : sample(scene, kPoints).points) {
    const bool is_defined = is_finite(point.position);
    is_holed = is_holed || !is_defined;
    if (is_defined && is_drawn(scene, point.position)) bounds.add(point.position);
  }
  EXPECT_EQ(is_holed, facts.holed);
  for (const dvec3& p : mesh.position) bounds.add(p);
  for (int axis = 0; axis < 3; ++axis) {
    const double expected = facts.extents[axis];
    if (std::isinf(expected)) continue;
    EXPECT_NEAR(bounds.size()[axis], expected, kTolerance * expected) << "axis " << axis;
  }
}

void expect_identities(const GalleryFacts& facts, const Scene& scene) {
  EXPECT_TRUE(facts.equation || facts.minimal || facts.gauss) << "no closed form to hold it to";
  if (facts.minimal) expect_minimal(scene);
  if (facts.gauss) expect_gauss_curvature(scene, *facts.gauss);
  if (!facts.equation) return;
  // Off the ends, where a factor of the equation may be 0 on more than the surface.
  const Samples s = sample(scene, 17);
  std::size_t tested = 0;
  for (std::size_t j = 0; j < s.v.size(); ++j) {
    for (std::size_t i = 0; i < s.u.size(); ++i) {
      const dvec3& p = s.at(i, j).position;
      if (!is_finite(p)) continue;
      ++tested;
      const double reach = std::pow(std::max(glm::length(p), 1.0), facts.equation->degree);
      EXPECT_LE(std::abs(facts.equation->value(p, s.u[i], s.v[j])),
                64 * kEpsilon * facts.equation->coefficients * reach)
          << "u = " << s.u[i] << ", v = " << s.v[j];
    }
  }
  EXPECT_GT(tested, s.points.size() / 5);
}

/// What vanishes like a cube counts as degenerate at 1e-7 already, some 1e-3 from where it does.
constexpr double kNearPlace = 5e-3;

void expect_places(const char* what, const std::vector<Places>& expected,
                   const std::vector<dvec2>& listed) {
  for (const dvec2& uv : listed) {
    const auto is_on = [&](const Places& p) { return std::abs(p.off(uv.x, uv.y)) <= kNearPlace; };
    EXPECT_TRUE(std::ranges::any_of(expected, is_on))
        << what << " at u = " << uv.x << ", v = " << uv.y;
  }
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const auto is_on = [&](const dvec2& uv) {
      return std::abs(expected[k].off(uv.x, uv.y)) <= kNearPlace;
    };
    EXPECT_TRUE(std::ranges::any_of(listed, is_on)) << what << ": none of set " << k;
  }
}

void expect_report(const GalleryFacts& facts, const MeshReport& report) {
  EXPECT_EQ(report.closed_u, facts.closed_u);
  EXPECT_EQ(report.closed_v, facts.closed_v);
  std::vector<dvec2> singular;
  for (const SingularPoint& point : report.singular_points) singular.push_back(point.uv);
  expect_places("singular", facts.singular, singular);
  expect_places("pole", facts.poles, report.poles);
  expect_places("jump", facts.jumps, report.jumps);
  EXPECT_EQ(report.pole_count > 0, !facts.poles.empty());
  EXPECT_EQ(report.jump_count > 0, !facts.jumps.empty());
  if (facts.proof != Proof::May) {
    EXPECT_EQ(report.certified, facts.proof == Proof::Holds);
  }
  EXPECT_LE(report.max_error, *report.tolerance);
}

void expect_grid(const GalleryFacts& facts, const Surface& surface) {
  const MeshResult grid = mesh_on_grid(surface, {40, 40, 16, 16, 0});
  EXPECT_EQ(grid.report.undefined_fraction > 0, facts.holed);
  EXPECT_GT(grid.mesh.triangles.size(), 400U);  // 3200 less what is not there
}

/// The cosine of 1 degree: normals are the formula's.
constexpr double kSameNormal = 0.99985;

/// Vertex normals that face away from the front of their own triangle and are not the formula's, if
/// the triangle is higher than what may be missing. About a fold, and at the curve of a cusp,
/// smaller ones may face anywhere.
std::size_t count_opposed(const Surface& surface, const Mesh& mesh, double tolerance) {
  std::vector<std::uint32_t> opposed;
  for (const Triangle& t : mesh.triangles) {
    const std::array<dvec3, 3> p = {mesh.position[t[0]], mesh.position[t[1]], mesh.position[t[2]]};
    const dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double longest =
        std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    if (!(glm::length(area) > tolerance * longest)) continue;
    for (const std::uint32_t corner : t) {
      if (glm::dot(area, mesh.normal[corner]) < 0) opposed.push_back(corner);
    }
  }
  std::vector<dvec2> uv;
  for (const std::uint32_t corner : opposed) uv.push_back(mesh.uv[corner]);
  const std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
  std::size_t count = 0;
  for (std::size_t k = 0; k < opposed.size(); ++k) {
    const auto normal = known_normal(points[k], surface.flip);
    count += normal && glm::dot(*normal, mesh.normal[opposed[k]]) > kSameNormal ? 0 : 1;
  }
  return count;
}

/// With the tolerances that the program has for meshes, too.
TEST_P(GalleryTable, HasOnlyExactNormalsThatOpposeTheirTriangle) {
  const Scene scene = scene_of(GetParam());
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
  MeshRequest options = within_share(1e-3, 3);
  options.clip = scene.clip.box;
  const MeshResult mesh = try_mesh(surface, options).value();
  EXPECT_EQ(count_opposed(surface, mesh.mesh, mesh.report.tolerance.value()), 0U);
}

TEST_P(GalleryTable, Holds) {
  const Scene scene = scene_of(GetParam());
  expect_identities(facts(), scene);
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
  expect_grid(facts(), surface);
  const MeshResult mesh = mesh_of(surface, scene, 3e-3);
  expect_extents(facts(), scene, mesh.mesh);
  expect_report(facts(), mesh.report);
  EXPECT_EQ(count_opposed(surface, mesh.mesh, mesh.report.tolerance.value()), 0U);
  const Topology t = topology(mesh.mesh);
  EXPECT_EQ(t.orientable, facts().orientable);
  EXPECT_EQ(t.components, facts().components);
  EXPECT_EQ(is_orientable(mesh.mesh, mesh.report), facts().orientable);
  if (!facts().euler_number) return;
  EXPECT_EQ(t.euler_number, facts().euler_number);
  EXPECT_EQ(t.boundary_loops, facts().boundary_loops);
  EXPECT_EQ(t.open_edges == 0, facts().boundary_loops == 0);
  EXPECT_EQ(t.shared_edges, 0U);
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const GalleryFacts& facts : gallery_facts()) names.push_back(facts.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(, GalleryTable, testing::ValuesIn(names()), [](const auto& surface) {
  std::string name = surface.param;
  std::ranges::replace(name, '-', '_');  // names of tests have no hyphens
  return name;
});

}  // namespace
}  // namespace saddle
