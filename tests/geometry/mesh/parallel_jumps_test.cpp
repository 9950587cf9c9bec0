// Lines of jumps side by side, nearer to each other than cells are wide or not: random flat strips
// are meshed with their exact areas, in few cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "base/format.h"
#include "mesh/mesher/mesher.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// Flat sheets over -1:1 x -1:1, one for each strip between the lines dot(across, (u, v)) = at.
struct Strips {
  dvec2 across;
  std::vector<double> at;
  std::vector<double> heights;  ///< one more

  std::string text() const {
    std::string z = formatted("%.17g", heights.back());
    for (std::size_t k = at.size(); k-- > 0;)
      z = formatted("if(%.17g*u+%.17g*v<%.17g,%.17g,", across.x, across.y, at[k], heights[k]) + z +
          ")";
    return z;
  }
};

double twice_the_area(const std::vector<dvec2>& polygon) {
  double area = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const dvec2& a = polygon[k];
    const dvec2& b = polygon[(k + 1) % polygon.size()];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

/// The area of the domain below a line.
double area_below(const dvec2& across, double at) {
  const std::vector<dvec2> square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<dvec2> part;
  for (std::size_t k = 0; k < square.size(); ++k) {
    const dvec2& a = square[k];
    const dvec2& b = square[(k + 1) % square.size()];
    const double of_a = glm::dot(across, a) - at;
    const double of_b = glm::dot(across, b) - at;
    if (of_a < 0) part.push_back(a);
    if ((of_a < 0) != (of_b < 0)) part.push_back(a + of_a / (of_a - of_b) * (b - a));
  }
  return 0.5 * twice_the_area(part);
}

Strips random_strips(std::mt19937& dice) {
  const auto random = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(dice);
  };
  const double angle = random(-3, 3);
  Strips strips = {{std::cos(angle), std::sin(angle)}, {random(-0.5, 0.5)}, {0}};
  const auto lines = static_cast<std::size_t>(random(2, 5));
  while (strips.at.size() < lines)
    strips.at.push_back(strips.at.back() + std::pow(10, random(-6, -1)));
  // With one sheet on both sides, no sample shows the strip between.
  const bool is_same_beyond = random(0, 1) < 0.5;
  for (std::size_t k = 0; k < lines; ++k) strips.heights.push_back(strips.heights.back() + 0.5);
  if (is_same_beyond) strips.heights.back() = strips.heights.front();
  return strips;
}

TEST(ParallelJumps, HaveStripsOfTheirAreasInFewCells) {
  constexpr int kSurfaces = 60;
  // 225 without jumps. A strip is parted where it is wide, or goes around corners on two sides.
  constexpr std::size_t kMostCells = 300;  // on average
  // A leaf in which too much meets is left out where it is too small to see.
  constexpr double kInvisible = 2e-6;
  std::size_t cells = 0;
  std::mt19937 dice(7);
  for (int i = 0; i < kSurfaces; ++i) {
    const Strips strips = random_strips(dice);
    const MeshResult result =
        try_mesh(height_field(strips.text().c_str()), within_share(1e-3)).value();
    const Mesh& mesh = result.mesh;
    std::vector<double> areas(strips.heights.size(), 0);
    for (const Triangle& t : mesh.triangles) {
      const double height = mesh.position[t[0]].z;
      for (const std::uint32_t corner : t)
        ASSERT_EQ(mesh.position[corner].z, height) << strips.text();
      // Beyond the last line may be the sheet before the first.
      const dvec2 middle = (mesh.uv[t[0]] + mesh.uv[t[1]] + mesh.uv[t[2]]) / 3.0;
      const auto strip = std::ranges::upper_bound(strips.at, glm::dot(strips.across, middle));
      const auto number = static_cast<std::size_t>(strip - strips.at.begin());
      ASSERT_EQ(strips.heights[number], height) << strips.text();
      areas[number] += 0.5 * twice_the_area({mesh.uv[t[0]], mesh.uv[t[1]], mesh.uv[t[2]]});
    }
    double before = 0;
    for (std::size_t k = 0; k < areas.size(); ++k) {
      const double until = k < strips.at.size() ? area_below(strips.across, strips.at[k]) : 4;
      EXPECT_NEAR(areas[k], until - before, kInvisible) << strips.text() << " strip " << k;
      before = until;
    }
    cells += result.report.cells;
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << strips.text();
  }
  EXPECT_LE(cells, kSurfaces * kMostCells);
}

}  // namespace
}  // namespace saddle
