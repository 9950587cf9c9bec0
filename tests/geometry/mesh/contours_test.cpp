// Level lines: on the level and on the surface, whole, and honest about what has none.
#include "mesh/color/contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "meshing/tessellate.h"
#include "scene/model/gallery.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr Purpose kLinesOfPicture = {.picture = true, .mesh = false};

Scene field_over(const std::string& z, double half = 1) {
  Scene scene;
  SurfaceSpec& spec = scene.surfaces.emplace_back();
  spec.z = z;
  const std::string end = std::to_string(half);
  spec.u = spec.v = {"-" + end, end};
  return scene;
}

Tessellation with_contours(Scene scene, const std::string& expression,
                           const std::vector<double>& levels = {}) {
  ContourSpec contour{expression, {}};
  contour.levels.assign(levels.begin(), levels.end());
  scene.surfaces[0].contours = {contour};
  return tessellate(scene, scene.surfaces[0], kLinesOfPicture, 0);
}

/// Samples along the lines, straight between their vertices.
std::vector<dvec3> samples(const MeshContours& contours) {
  std::vector<dvec3> result;
  for (const auto& line : contours.lines) {
    for (std::size_t k = 1; k < line.size(); ++k) {
      const dvec3& a = contours.position[line[k - 1]];
      const dvec3& b = contours.position[line[k]];
      for (double s = 0; s < 1; s += 0.25) result.push_back(glm::mix(a, b, s));
    }
  }
  return result;
}

double length(const MeshContours& contours) {
  double sum = 0;
  for (const auto& line : contours.lines) {
    for (std::size_t k = 1; k < line.size(); ++k) {
      sum += glm::distance(contours.position[line[k - 1]], contours.position[line[k]]);
    }
  }
  return sum;
}

/// The largest distance of the lines, by a function that knows it.
double worst(const MeshContours& contours, const std::function<double(const dvec3&)>& distance) {
  double most = 0;
  for (const dvec3& p : samples(contours)) most = std::max(most, std::abs(distance(p)));
  return most;
}

/// Places at which an odd number of chains end: ends of lines.
std::size_t open_ends(const MeshContours& contours) {
  std::map<std::array<double, 3>, int> ends;
  for (const auto& line : contours.lines) {
    for (const std::uint32_t end : {line.front(), line.back()}) {
      const dvec3& p = contours.position[end];
      ++ends[{p.x, p.y, p.z}];
    }
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(ends, [](const auto& end) { return end.second % 2 != 0; }));
}

std::string lines_warnings(const Tessellation& t) {
  std::string all;
  for (const std::string& warning : t.warnings) all += warning + "\n";
  return all;
}

TEST(Contours, OfAParaboloidAreCirclesToTheTolerance) {
  const Tessellation t = with_contours(field_over("u^2+v^2", 1.5), "z", {0.25, 1});
  const double tolerance = t.report.tolerance.value();
  const MeshContours& contours = t.mesh.contours;
  const auto circle = [](const dvec3& p) {
    const double r = std::hypot(p.x, p.y);
    const double nearer = r < 0.75 ? 0.5 : 1;
    return std::hypot(r - nearer, p.z - nearer * nearer);
  };
  EXPECT_LT(worst(contours, circle), tolerance);
  EXPECT_NEAR(length(contours), 2 * kPi * 1.5, 2e-3);
  EXPECT_EQ(open_ends(contours), 0U);
  for (const dvec3& p : contours.position) {  // each vertex is a root
    EXPECT_LT(std::min(std::abs(p.z - 0.25), std::abs(p.z - 1)), 1e-13);
    EXPECT_NEAR(p.z, p.x * p.x + p.y * p.y, 1e-13);
  }
}

TEST(Contours, AreTrueOnACoarseMesh) {
  Scene scene = field_over("sin(3*u)*cos(2*v)", 2);
  scene.mesh.samples = GridSize{6, 6};
  const Tessellation t = with_contours(scene, "z", {0.5});
  ASSERT_FALSE(t.mesh.contours.lines.empty());
  for (const dvec3& p : t.mesh.contours.position) EXPECT_NEAR(p.z, 0.5, 1e-12);
  EXPECT_LT(worst(t.mesh.contours, [](const dvec3& p) { return p.z - 0.5; }),
            2e-3 * t.mesh.bounds.diagonal());
}

TEST(Contours, OfSmallLevelsAreFoundOnALargeSurface) {
  const Tessellation t = with_contours(field_over("0", 30), "(u-0.6)^2+(v+0.8)^2", {0.25});
  EXPECT_NEAR(length(t.mesh.contours), kPi, 0.2);
  for (const dvec3& p : t.mesh.contours.position) {
    EXPECT_NEAR(std::hypot(p.x - 0.6, p.y + 0.8), 0.5, 1e-12);
  }
  EXPECT_EQ(open_ends(t.mesh.contours), 0U);
}

TEST(Contours, OfZeroCurvatureAreTheTopAndBottomCirclesOfATorus) {
  const Tessellation t = with_contours(gallery_scene(*find_gallery_entry("torus")), "gauss", {0});
  const auto circle = [](const dvec3& p) {
    return std::hypot(std::hypot(p.x, p.y) - 2, std::abs(p.z) - 0.8);
  };
  ASSERT_FALSE(t.mesh.contours.lines.empty());
  EXPECT_LT(worst(t.mesh.contours, circle), t.report.tolerance.value());
  EXPECT_NEAR(length(t.mesh.contours), 2 * 2 * kPi * 2, 1e-2);
}

TEST(Contours, CrossInASaddlePointWhereverTheMeshIs) {
  const Tessellation t = with_contours(field_over("(u-0.123)^2-(v+0.071)^2"), "z", {0});
  const double tolerance = t.report.tolerance.value();
  const auto cross = [](const dvec3& p) {
    return (std::abs(p.x - 0.123) - std::abs(p.y + 0.071)) / std::sqrt(2.0);
  };
  EXPECT_LT(worst(t.mesh.contours, cross), tolerance);
  double nearest = 1;
  for (const dvec3& p : samples(t.mesh.contours)) {
    nearest = std::min(nearest, glm::distance(p, dvec3(0.123, -0.071, 0)));
  }
  EXPECT_LT(nearest, 2 * tolerance);
  const double whole = std::sqrt(2.0) * (2 - 0.194 + 2 - 0.052);
  EXPECT_NEAR(length(t.mesh.contours), whole, 4 * tolerance);
}

TEST(Contours, GoOnAcrossASeam) {
  const Tessellation t = with_contours(gallery_scene(*find_gallery_entry("torus")), "x", {0.7});
  const auto on_plane = [](const dvec3& p) { return p.x - 0.7; };
  EXPECT_LT(worst(t.mesh.contours, on_plane), t.report.tolerance.value());
  // Twice the parameters 0 and 2 pi give points that differ by rounding.
  double widest = 0;
  std::vector<dvec3> ends;
  for (const auto& line : t.mesh.contours.lines) {
    ends.push_back(t.mesh.contours.position[line.front()]);
    ends.push_back(t.mesh.contours.position[line.back()]);
  }
  for (const dvec3& end : ends) {
    std::vector<double> near;
    for (const dvec3& other : ends) near.push_back(glm::distance(end, other));
    std::ranges::nth_element(near, near.begin() + 1);
    widest = std::max(widest, near[1]);
  }
  EXPECT_LT(widest, 1e-12);
}

TEST(Contours, EndWhereTheSurfaceJumps) {
  const Tessellation t = with_contours(field_over("u<0.2?v:v+3"), "z", {0.5, 2.75});
  double left = -1;
  double right = 1;
  for (const dvec3& p : t.mesh.contours.position) {
    EXPECT_TRUE(p.z == 0.5 || p.z == 2.75) << p.z;
    (p.z == 0.5 ? left : right) = p.z == 0.5 ? std::max(left, p.x) : std::min(right, p.x);
  }
  EXPECT_NEAR(left, 0.2, 1e-12);
  EXPECT_NEAR(right, 0.2, 1e-12);
  EXPECT_NEAR(length(t.mesh.contours), 2, 1e-9);
}

TEST(Contours, EndWhereTheNumberJumpsAndNeverRunAlongTheJump) {
  const Tessellation t = with_contours(field_over("0"), "v+floor(2*u+0.3)", {0.25});
  const double tolerance = t.report.tolerance.value();
  for (const dvec3& p : samples(t.mesh.contours)) {
    EXPECT_NEAR(p.y + std::floor(2 * p.x + 0.3), 0.25, tolerance) << p.x << " " << p.y;
  }
  EXPECT_NEAR(length(t.mesh.contours), 1, 8 * tolerance);  // two steps, each 1/2 wide
  EXPECT_TRUE(with_contours(field_over("0"), "sign(u)", {0.5}).mesh.contours.lines.empty());
  EXPECT_TRUE(with_contours(field_over("0"), "1/(u-0.1)", {0}).mesh.contours.lines.empty());
}

TEST(Contours, EndWhereTheNumberIsNotDefined) {
  const Tessellation t = with_contours(field_over("0"), "v+0*sqrt(u-0.1)", {0.25});
  double least = 1;
  for (const dvec3& p : t.mesh.contours.position) least = std::min(least, p.x);
  EXPECT_NEAR(least, 0.1, 4 * t.report.tolerance.value());
}

TEST(Contours, AreAtAboutTenRoundLevels) {
  const Tessellation t = with_contours(field_over("exp(-4*(u^2+v^2))"), "z");
  std::set<double> levels;
  for (const dvec3& p : t.mesh.contours.position) levels.insert(std::round(p.z * 1e9) / 1e9);
  EXPECT_EQ(levels, (std::set{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}));
}

TEST(Contours, TakeTheRangeOfAnAnimationForRoundLevels) {
  Scene scene = field_over("u");
  scene.surfaces[0].contours = {{"z", {}, ColorRange{0, 100}}};
  const Tessellation t = tessellate(scene, scene.surfaces[0], kLinesOfPicture, 0);
  EXPECT_TRUE(t.warnings.empty());
  EXPECT_TRUE(t.mesh.contours.lines.empty());  // 10, 20, ... are beyond this moment's numbers
}

TEST(Contours, OfWholeAreasAreWarnings) {
  const Tessellation flat = with_contours(field_over("1"), "z", {1});
  EXPECT_NE(lines_warnings(flat).find("the contours of z: it is 1 on a whole area"),
            std::string::npos);
  const Tessellation tread = with_contours(field_over("max(abs(u),0.5)"), "z", {0.5, 0.75});
  EXPECT_NE(lines_warnings(tread).find("it is 0.5 on a whole area"), std::string::npos);
  EXPECT_GT(tread.mesh.contours.lines.size(), 0U);
  const Tessellation rounding =
      with_contours(gallery_scene(*find_gallery_entry("cylinder")), "gauss", {0});
  EXPECT_NE(lines_warnings(rounding).find("it is 0 on a whole area"), std::string::npos);
  EXPECT_TRUE(rounding.mesh.contours.lines.empty());
}

TEST(Contours, OutsideOfTheRangeAreAWarningThatTellsIt) {
  const Tessellation t = with_contours(field_over("u^2+v^2"), "z", {7, 8});
  EXPECT_NE(lines_warnings(t).find("the contours of z: none at 7, 8; it runs from 0 to 2"),
            std::string::npos)
      << lines_warnings(t);
}

TEST(Contours, LeaveTheMeshAsItIs) {
  const Scene scene = field_over("u^2*v");
  const Tessellation plain = tessellate(scene, scene.surfaces[0], kLinesOfPicture, 0);
  const Tessellation lined = with_contours(scene, "z");
  EXPECT_EQ(plain.mesh.triangles, lined.mesh.triangles);
  EXPECT_EQ(plain.mesh.position.size(), lined.mesh.position.size());
  EXPECT_TRUE(lined.mesh.color.empty());
}

TEST(Contours, AreTheSameOnAnyNumberOfThreads) {
  Scene scene = field_over("sin(3*u)*v");
  scene.surfaces[0].contours = {{"gauss", {}}};
  const Tessellation one = tessellate(scene, scene.surfaces[0], kLinesOfPicture, 1);
  const Tessellation all = tessellate(scene, scene.surfaces[0], kLinesOfPicture, 3);
  EXPECT_EQ(one.mesh.contours.position, all.mesh.contours.position);
  EXPECT_EQ(one.mesh.contours.lines, all.mesh.contours.lines);
}

}  // namespace
}  // namespace saddle
