// The gallery's list, and every surface of it: extents, orientation, mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include <glm/vector_relational.hpp>

#include "geometry/gallery_samples.h"
#include "mesh/grid_mesh.h"

namespace saddle {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kPi = std::numbers::pi;
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

bool same(const dvec3& a, const dvec3& b) {
  return a == b || (!is_finite(a) && !is_finite(b));
}

TEST(Gallery, HasNamesInKebabCaseAndDescriptionsOfOneLine) {
  std::set<std::string_view> names;
  for (const GalleryEntry& entry : gallery()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " is there twice";
    EXPECT_TRUE(std::ranges::all_of(entry.name, [](char c) {
      return c == '-' || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    })) << entry.name;
    EXPECT_FALSE(entry.description.empty()) << entry.name;
    EXPECT_EQ(entry.description.find('\n'), std::string_view::npos) << entry.name;
    EXPECT_LE(entry.name.size() + entry.description.size(), 95U) << entry.name << ": one line";
  }
  EXPECT_GE(names.size(), 24U);
}

TEST(Gallery, FindsEntriesByName) {
  EXPECT_EQ(find_gallery_entry("torus")->name, "torus");
  EXPECT_EQ(find_gallery_entry("Torus"), nullptr);
  EXPECT_EQ(find_gallery_entry(""), nullptr);
}

TEST(Gallery, HelpsWithUnknownNames) {
  const Error error = unknown_gallery_name("helocoid");
  EXPECT_EQ(error.status(), Status::Input);
  EXPECT_NE(error.hint().find("did you mean 'helicoid'?"), std::string::npos);
  EXPECT_NE(error.hint().find("trefoil-tube"), std::string::npos);
}

TEST(Gallery, DrawsTheFunctionGraphersSceneFromItsOwnCamera) {
  const Scene scene = scene_of("eck-default");
  EXPECT_EQ(dvec3(scene.camera.view), dvec3(2, 1, 3));
  EXPECT_EQ(dvec3(scene.camera.up), dvec3(0, 1, 0));
  EXPECT_EQ(dvec3(scene.camera.target.value()), dvec3(0, 0, 0));
  EXPECT_EQ(scene.camera.distance.value(), 24);
  EXPECT_EQ(scene.camera.fov, 45);
}

TEST(Gallery, EveryParameterChangesItsSurface) {
  for (const GalleryEntry& entry : gallery()) {
    const Scene scene = gallery_scene(entry);
    const Samples before = sample(scene, 7);
    for (const Definition& definition : scene.definitions) {
      Scene changed = scene;
      const std::string name = display_name(definition);
      override_assignment(changed, name + "=1.25*(" + definition.text + ")");
      const Samples after = sample(changed, 7);
      EXPECT_FALSE(std::ranges::equal(before.points, after.points, same, &SurfacePoint::position,
                                      &SurfacePoint::position))
          << entry.name << ": " << name;
    }
  }
}

/// Surfaces with places where they are not defined.
const std::set<std::string_view>& holed() {
  static const std::set<std::string_view> names = {"funnel", "costa", "scherk-1-chequerboard",
                                                   "scherk-2-tower", "plucker-conoid-cartesian"};
  return names;
}

TEST(Gallery, EverySurfaceHasAMesh) {
  for (const GalleryEntry& entry : gallery()) {
    const Scene scene = gallery_scene(entry);
    GridOptions options;
    options.cells_u = 40;
    options.cells_v = 40;
    const Surface surface = prepare_surface(scene, scene.surfaces[0]).surface;
    const GridMesh result = mesh_on_grid(surface, options);
    EXPECT_EQ(result.report.undefined_fraction > 0, holed().contains(entry.name)) << entry.name;
    EXPECT_GT(result.mesh.triangles.size(), 400U) << entry.name;  // 3200 less what is not there
  }
}

/// dx, dy, dz of the bounding box, from independent sampling, of the part that is in the clip box.
const std::map<std::string, dvec3>& extents() {
  static const std::map<std::string, dvec3> table = {
      {"sphere", {2, 2, 2}},
      {"ellipsoid", {6, 4, 2}},
      {"torus", {5.6, 5.6, 1.6}},
      {"horn-torus", {4, 4, 2}},
      {"spindle-torus", {3.2, 3.2, 2}},
      {"cylinder", {2, 2, 2}},
      {"cone-double", {2, 2, 2}},
      {"hyperboloid-1", {4.705, 4.705, 4.259}},
      {"paraboloid", {4, 4, 4}},
      {"hyperbolic-paraboloid", {2, 2, 2}},
      {"monkey-saddle", {2, 2, 4}},
      {"gabriel-horn", {19, 2, 2}},
      {"hyperboloid-2", {4.259, 4.259, 4.705}},
      {"funnel", {4, 4, kUnbounded}},
      {"eight-surface", {2, 2, 2}},
      {"astroidal-ellipsoid", {2, 2, 2}},
      {"pillow", {2, 2, 1}},
      {"catenoid", {3.621, 3.621, 2.4}},
      {"helicoid", {3, 3, 3.142}},
      {"catenoid-helicoid", {3.019, 3.019, 6.283}},  // 2*sinh(1.2), 2*pi: the helicoid, t = 0
      {"enneper", {14.67, 14.67, 8}},
      {"enneper-polar", {3.193, 3.193, 2.074}},
      {"scherk-1", {3, 3, 5.298}},
      {"scherk-1-chequerboard", {10, 10, 6}},  // clipped
      {"scherk-2-tower", {6, 6, kPi}},
      {"scherk-2", {1.5, 1.5, 1.485}},
      {"henneberg", {15.77, 15.77, 15.05}},
      {"catalan", {14.56, 4.705, 6.579}},
      {"bour", {2.25, 2.597, 2.667}},
      {"pseudosphere", {2, 2, 4.01}},
      {"dini", {2, 2, 6.839}},
      {"kuen", {3.024, 2.126, 4.108}},
      {"kuen-log", {3.024, 2.126, 3.575}},
      {"costa", {6, 6, 6}},  // clipped
      {"mobius", {2.529, 2.728, 1}},
      {"klein-figure8", {6.019, 6.489, 2.5}},
      {"klein-bottle", {22.85, 36.1, 12}},
      {"cross-cap", {2, 2, 2}},
      {"roman", {1, 1, 1}},
      {"boy", {3.648, 3.855, 3}},
      {"whitney-umbrella", {2, 2, 1}},
      {"cuspidal-edge", {2, 1, 2}},
      {"swallowtail", {2.842, 10.5, 4}},
      {"menn", {2, 2, 2.25}},
      {"plucker-conoid", {2, 2, 2}},
      {"plucker-conoid-cartesian", {2, 2, 2}},
      {"wallis-conical-edge", {2, 2, 0.5}},
      {"riemann-sqrt", {2, 2, 2}},
      {"riemann-cbrt", {2, 2, 2}},
      {"riemann-log", {2, 2, 3.142}},  // half the turns that the sampled one had
      {"riemann-asin", {4.705, 4.259, 6.283}},
      {"bohemian-dome", {1, 4, 2}},
      {"corkscrew", {2, 2, 5.142}},
      {"guimard", {3, 1, 1}},
      {"steinbach-screw", {8, 8, 12.57}},
      {"bent-horns", {15.76, 6, 6}},
      {"trefoil-tube", {6.67, 6.262, 3.2}},
      {"seashell", {6.049, 5.258, 8.107}},
      {"conic-spiral", {0.9012, 0.8024, 1.2}},
      {"horn", {5.01, 6.505, 2}},
      {"bourke-harmonic", {3.076, 4.273, 3.076}},
      {"spherical-harmonic", {0.5723, 0.5036, 0.3717}},
      {"superellipsoid", {2, 2, 2}},
      {"superellipsoid-star", {2, 2, 2}},
      {"supertoroid", {5.4, 5.4, 1.4}},
      {"eck-default", {12, 4, 12}},
  };
  return table;
}

/// Whether the clip box, if there is one, holds the point.
bool is_drawn(const Scene& scene, const dvec3& p) {
  const auto& box = scene.clip.box;
  return !box || (glm::all(glm::greaterThanEqual(p, box->low)) &&
                  glm::all(glm::lessThanEqual(p, box->high)));
}

TEST(Gallery, EverySurfaceIsFiniteAndHasItsExtents) {
  // A peak is missed by half a step at most. The formulas have up to 12 waves in a range, 32 steps
  // for each: 1 - cos(pi / 32) = 0.48 %. The table's rounding is far less. Clip boxes are met by
  // points as well: a wall that rises to one does so over some tens of steps.
  constexpr int kPoints = 12 * 32 + 1;
  constexpr double kTolerance = 5e-3;
  for (const GalleryEntry& entry : gallery()) {
    const auto expected = extents().find(std::string(entry.name));
    ASSERT_NE(expected, extents().end()) << entry.name << " has no entry";
    Bounds bounds;
    const Scene scene = gallery_scene(entry);
    for (const SurfacePoint& point : sample(scene, kPoints).points) {
      if (is_finite(point.position)) {
        if (is_drawn(scene, point.position)) bounds.add(point.position);
      } else {
        ASSERT_TRUE(holed().contains(entry.name)) << entry.name;
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (expected->second[axis] == kUnbounded) continue;
      EXPECT_NEAR(bounds.size()[axis], expected->second[axis], kTolerance * expected->second[axis])
          << entry.name << " axis " << axis;
    }
  }
}

/// The volume inside by the divergence theorem; the trapezoidal rule.
double enclosed_volume(const Scene& scene) {
  const Samples s = sample(scene, 181);
  double sum = 0;
  for (std::size_t j = 0; j < s.v.size(); ++j) {
    for (std::size_t i = 0; i < s.u.size(); ++i) {
      const SurfacePoint& p = s.at(i, j);
      const double at_ends =
          (i == 0 || i + 1 == s.u.size() ? 0.5 : 1) * (j == 0 || j + 1 == s.v.size() ? 0.5 : 1);
      sum += at_ends * glm::dot(p.position, glm::cross(p.r_u, p.r_v)) / 3;
    }
  }
  return sum * (s.u[1] - s.u[0]) * (s.v[1] - s.v[0]);
}

TEST(Gallery, ClosedSurfacesFaceOutwardAndEncloseTheirVolume) {
  // The trapezoidal rule with 180 steps is exact along closed parameters and within (pi/180)^2/6 of
  // the whole along the meridian.
  const double meridian = kPi * kPi / (180.0 * 180.0);
  EXPECT_NEAR(enclosed_volume(scene_of("sphere", {"r=2"})), 32 * kPi / 3, 32 * kPi / 3 * meridian);
  EXPECT_NEAR(enclosed_volume(scene_of("ellipsoid")), 8 * kPi, 8 * kPi * meridian);
  const double torus = 2 * kPi * kPi * 2 * 0.64;
  EXPECT_NEAR(enclosed_volume(scene_of("torus")), torus, 1e-12 * torus);
  EXPECT_NEAR(enclosed_volume(scene_of("horn-torus")), 2 * kPi * kPi, 1e-12 * torus);
  // Areas inside |a|^(2/e) + |b|^(2/e) = 1, and bodies that such curves make.
  const auto area = [](double e) {
    return 4 * std::tgamma(1 + e / 2) * std::tgamma(1 + e / 2) / std::tgamma(1 + e);
  };
  const auto body = [](double e) {
    return 2 * e * e * std::beta(e / 2 + 1, e) * std::beta(e / 2, e / 2);
  };
  EXPECT_NEAR(enclosed_volume(scene_of("superellipsoid")), body(0.2), body(0.2) * meridian);
  EXPECT_NEAR(enclosed_volume(scene_of("superellipsoid-star")), body(3), body(3) * meridian);
  const double supertoroid = 2 * 2 * 0.49 * area(0.3) * area(0.3);
  EXPECT_NEAR(enclosed_volume(scene_of("supertoroid")), supertoroid, supertoroid * meridian);
  const double harmonic = 8.0 / (9 * 5.5 * 6.5);  // the integral of r^3 / 3 over all directions
  EXPECT_NEAR(enclosed_volume(scene_of("spherical-harmonic")), harmonic, harmonic * meridian);
  EXPECT_GT(enclosed_volume(scene_of("spindle-torus")), 0);
  EXPECT_GT(enclosed_volume(scene_of("astroidal-ellipsoid")), 0);
  EXPECT_GT(enclosed_volume(scene_of("pillow")), 0);
}

TEST(Gallery, SurfacesOfRevolutionFaceAwayFromTheirAxis) {
  const std::map<std::string, dvec3> axes = {
      {"cylinder", {0, 0, 1}}, {"hyperboloid-1", {0, 0, 1}}, {"paraboloid", {0, 0, 1}},
      {"catenoid", {0, 0, 1}}, {"pseudosphere", {0, 0, 1}},  {"gabriel-horn", {1, 0, 0}},
  };
  for (const auto& [name, axis] : axes) {
    for (const SurfacePoint& p : sample(scene_of(name), 31).points) {
      const dvec3 from_axis = p.position - axis * glm::dot(p.position, axis);
      const dvec3 normal = glm::cross(p.r_u, p.r_v);
      // Zero at the bowl's pole and the pseudosphere's edge, negative nowhere but for rounding.
      EXPECT_GE(glm::dot(from_axis, normal), -8 * kEpsilon) << name;
    }
  }
}

/// Sum of normal times distance from the middle, over the closed section at one parameter.
double outwardness(const Samples& s, std::size_t at, bool section_is_along_v) {
  std::vector<SurfacePoint> section;
  for (std::size_t k = 1; k < s.u.size(); ++k) {
    section.push_back(section_is_along_v ? s.at(at, k) : s.at(k, at));
  }
  dvec3 middle{0};
  for (const SurfacePoint& p : section) middle += p.position / double(section.size());
  double sum = 0;
  for (const SurfacePoint& p : section) {
    sum += glm::dot(p.position - middle, glm::cross(p.r_u, p.r_v));
  }
  return sum;
}

TEST(Gallery, TubesFaceAwayFromTheirMiddle) {
  const std::map<std::string, bool> section_is_along_v = {
      {"trefoil-tube", true}, {"seashell", true}, {"horn", true}, {"conic-spiral", false}};
  for (const auto& [name, along_v] : section_is_along_v) {
    const Samples s = sample(scene_of(name), 31);
    for (std::size_t at = 1; at + 1 < s.u.size(); ++at) {
      EXPECT_GT(outwardness(s, at, along_v), 0) << name << " section " << at;
    }
  }
}

}  // namespace
}  // namespace saddle
