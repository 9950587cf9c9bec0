// The gallery's list, and which way its surfaces face. What else is true of each of them stands in
// table.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "geometry/gallery/forms.h"
#include "geometry/gallery/samples.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

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
  EXPECT_NE(error.hint().find("saddle list"), std::string::npos);
}

TEST(Gallery, DrawsTheFunctionGraphersSceneFromItsOwnCamera) {
  const Scene scene = scene_of("eck-default");
  EXPECT_EQ(dvec3(scene.camera.view), dvec3(2, 1, 3));
  EXPECT_EQ(dvec3(scene.camera.up), dvec3(0, 1, 0));
  EXPECT_EQ(dvec3(scene.camera.target.value()), dvec3(0, 0, 0));
  EXPECT_EQ(scene.camera.distance.value(), 24);
  EXPECT_EQ(scene.camera.fov, 45);
}

bool changes(const Scene& scene, const std::string& assignment) {
  constexpr int kPoints = 9;
  Scene changed = scene;
  override_assignment(changed, assignment);
  return !std::ranges::equal(sample(scene, kPoints).points, sample(changed, kPoints).points, same,
                             &SurfacePoint::position, &SurfacePoint::position);
}

TEST(Gallery, EveryParameterChangesItsSurface) {
  for (const GalleryEntry& entry : gallery()) {
    const Scene scene = gallery_scene(entry);
    for (const Definition& definition : scene.definitions) {
      const std::string name = display_name(definition);
      // Doubled: the number of terms of a sum stays a whole one. Squared: of some definitions the
      // ratio alone counts.
      EXPECT_TRUE(changes(scene, name + "=2*(" + definition.text + ")") ||
                  changes(scene, name + "=(" + definition.text + ")^2"))
          << entry.name << ": " << name;
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
