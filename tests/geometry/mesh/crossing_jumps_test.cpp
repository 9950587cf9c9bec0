// Jumps that cross anywhere, in leaves and at their vertices: meshes of random flat sheets are
// compared with the formula as C++, without any part of the mesher.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "mesh/mesher/mesher.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// A surface of flat sheets over -1:1 x -1:1. Its steps are higher than the tolerance.
struct Sheets {
  std::string text;
  std::function<double(double, double)> height;
};

/// A random number with three decimals, which are its text.
double decimal(std::mt19937& dice, double low, double high) {
  return std::round(1000 * std::uniform_real_distribution<double>(low, high)(dice)) / 1000;
}
std::string text(double decimal) {
  return "(" + std::to_string(decimal) + ")";
}

/// Steps across two sets of lines. Diagonals and whole factors lead lines through vertices of the
/// root grid.
Sheets aslant_steps(std::mt19937& dice) {
  const bool is_diagonal = decimal(dice, 0, 1) < 0.5;
  const double some = decimal(dice, 1, 3);
  const double factor = decimal(dice, 0, 1) < 0.5 ? std::round(some) : some;
  const double shift = decimal(dice, 0, 1) < 0.5 ? 0 : decimal(dice, 0, 1);
  const double slope = is_diagonal ? 1 : decimal(dice, -1, 1);
  const double other = is_diagonal ? -1 : decimal(dice, -1, 1);
  return {"(floor(" + text(factor) + "*(u+" + text(slope) + "*v+" + text(shift) + "))+3*floor(" +
              text(factor) + "*(u+" + text(other) + "*v)))/8",
          [=](double u, double v) {
            return (std::floor(factor * (u + slope * v + shift)) +
                    3 * std::floor(factor * (u + other * v))) /
                   8;
          }};
}

/// A disc, a half-plane and a parabola that cross.
Sheets curved_steps(std::mt19937& dice) {
  const double u = decimal(dice, -1, 1);
  const double v = decimal(dice, -1, 1);
  const double radius = decimal(dice, 0.1, 0.5);
  const double slope = decimal(dice, -2, 2);
  const double bend = decimal(dice, -2, 2);
  return {"(hypot(u-" + text(u) + ",v-" + text(v) + ")<" + text(radius) + ")+2*(v-" + text(v) +
              ">" + text(slope) + "*(u-" + text(u) + "))+4*(v>" + text(bend) + "*u^2)",
          [=](double x, double y) {
            return (std::hypot(x - u, y - v) < radius ? 1 : 0) + (y - v > slope * (x - u) ? 2 : 0) +
                   (y > bend * x * x ? 4 : 0);
          }};
}

/// Whether sheets have a height at a place, within rounding.
bool have_height(const Sheets& sheets, const dvec2& place, double height) {
  constexpr double kBeside = 1e-9;
  for (int way = 0; way < 32; ++way) {
    const double angle = (way + 0.37) * kPi / 16;
    const dvec2 at = place + kBeside * dvec2(std::cos(angle), std::sin(angle));
    if (sheets.height(at.x, at.y) == height) return true;
  }
  return false;
}

class CrossingJumps : public testing::TestWithParam<double> {
 protected:
  /// Calls check(sheets, result) for random surfaces, with lines on every other mesh.
  template <class Check>
  void for_meshes(Check check) {
    constexpr int kSurfaces = 24;
    std::mt19937 dice(7);
    for (int k = 0; k < kSurfaces; ++k) {
      const Sheets sheets = k % 3 < 2 ? aslant_steps(dice) : curved_steps(dice);
      MeshRequest request = within_share(GetParam());
      if (k % 2 == 1) request.lines = {0, 0};
      check(sheets, try_mesh(height_field(sheets.text), request).value());
      if (HasFatalFailure()) return;
    }
  }
};

TEST_P(CrossingJumps, HaveNoTriangleBetweenTwoSheets) {
  for_meshes([](const Sheets& sheets, const MeshResult& result) {
    for (const Triangle& t : result.mesh.triangles) {
      const double height = result.mesh.position[t[0]].z;
      for (const std::uint32_t corner : t) {
        const dvec2& uv = result.mesh.uv[corner];
        ASSERT_EQ(result.mesh.position[corner].z, height)
            << sheets.text << " at " << uv.x << ' ' << uv.y;
        ASSERT_TRUE(have_height(sheets, uv, height))
            << sheets.text << " at " << uv.x << ' ' << uv.y;
      }
    }
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << sheets.text;
  });
}

INSTANTIATE_TEST_SUITE_P(Tolerances, CrossingJumps, testing::Values(5e-3, 1e-3, 1e-4));

/// Sheets end at the boundary beside a jump.
TEST(JumpsThatEndAtBoundaries, HaveNoTriangleBetweenTwoSheets) {
  // Below v = 0 both are undefined; v is small where u jumps up to it.
  const MeshResult result =
      try_mesh(height_field("sqrt((u^2>max(v,u-v))?u:v)", {-2, 2, -2, 2}), within_share(1e-3))
          .value();
  for (const Triangle& t : result.mesh.triangles) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::uint32_t corner : t) {
      const dvec3& p = result.mesh.position[corner];
      if (std::fabs(p.x - 1) > 0.1 || std::fabs(p.y) > 0.1) continue;
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
    ASSERT_FALSE(low < 0.5 && high > 0.9) << low << ' ' << high;
  }
}

}  // namespace
}  // namespace saddle
