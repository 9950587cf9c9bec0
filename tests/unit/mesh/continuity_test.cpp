#include "mesh/proof/continuity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr int kLines = 40;

/// Short lines along u, side by side, each 1/kLines of the range from -1 to 1.
std::vector<LinePart> lines_along_u() {
  std::vector<LinePart> lines;
  for (std::size_t k = 0; k < kLines; ++k) {
    const double at = -1 + 2.0 * static_cast<double>(k) / kLines;
    lines.push_back({k, {dvec2(at, 0.3), dvec2(at + 2.0 / kLines, 0.3)}});
  }
  return lines;
}

std::vector<LinePart> unproved_of(const Surface& surface, std::vector<LinePart> lines, double delta,
                                  std::size_t& boxes) {
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  return unproved(enclosure, std::move(lines), delta, boxes);
}

std::vector<LinePart> unproved_of(const std::string& z, double delta) {
  std::size_t boxes = 0;
  return unproved_of(height_field(z), lines_along_u(), delta, boxes);
}

/// Whether the parts are where the surface breaks, each place has some, and no more than doubles
/// beside it are in doubt.
void expect_only_at(const std::vector<LinePart>& parts, const std::vector<double>& breaks) {
  const auto is_at = [](const LinePart& part, double u) {
    return part.part[0].x - 1e-14 <= u && u <= part.part[1].x + 1e-14;
  };
  for (const double u : breaks) {
    EXPECT_TRUE(std::ranges::any_of(parts, [&](const LinePart& p) { return is_at(p, u); })) << u;
  }
  for (const LinePart& part : parts) {
    EXPECT_LT(part.part[1].x - part.part[0].x, 1e-15);
    EXPECT_TRUE(std::ranges::any_of(breaks, [&](double u) { return is_at(part, u); }));
  }
  EXPECT_TRUE(std::ranges::is_sorted(parts, {}, &LinePart::line));
}

TEST(Continuity, IsProvedOfManyLinesAtATime) {
  for (const char* z : {"sin(3*u)*exp(v)", "1/(u^2+v^2)", "abs(u)", "tanh(1e5*u)", "cbrt(u)"}) {
    EXPECT_TRUE(unproved_of(z, 1e-9).empty()) << z;
  }
}

TEST(Continuity, IsNotProvedAtJumpsAndPoles) {
  expect_only_at(unproved_of("floor(2*u+0.11)", 1e-3), {-0.555, -0.055, 0.445, 0.945});
  expect_only_at(unproved_of("1/(u-0.33)^2", 1e-3), {0.33});
}

TEST(Continuity, IsNotProvedOnEitherSideOfAPole) {
  const auto parts = unproved_of("1/(u-0.26)^2", 1e-3);
  ASSERT_EQ(parts.size(), 1);
  EXPECT_LT(parts[0].part[0].x, 0.26);
  EXPECT_GT(parts[0].part[1].x, 0.26);
}

/// Two boxes for each of 100 halvings would be 200.
TEST(Continuity, ComesToAPoleAtAnEndInFewBoxes) {
  for (const auto& [from, to] : {std::array{0.0, 1.0}, {-1.0, 0.0}}) {
    std::size_t boxes = 0;
    const auto parts =
        unproved_of(height_field("1/u"), {{0, {dvec2(from, 0.3), dvec2(to, 0.3)}}}, 1e-3, boxes);
    ASSERT_EQ(parts.size(), 1);
    EXPECT_LE(std::min(parts[0].part[0].x, parts[0].part[1].x), 0);
    EXPECT_LE(parts[0].part[1].x - parts[0].part[0].x, 0x1p-100);
    EXPECT_LT(boxes, 120);
  }
}

TEST(Continuity, IsNotProvedWhereAnyCoordinateJumps) {
  const Domain square = {-1, 1, -1, 1};
  for (const auto& [x, y, z] : {std::array{"floor(2*u+0.11)", "v", "u"},
                                {"u", "floor(2*u+0.11)", "v"},
                                {"u", "v", "floor(2*u+0.11)"}}) {
    const Surface surface = surface_from_text(x, y, z, square, {}, Order::Second);
    std::size_t boxes = 0;
    expect_only_at(unproved_of(surface, lines_along_u(), 1e-3, boxes),
                   {-0.555, -0.055, 0.445, 0.945});
  }
}

TEST(Continuity, TellsHowManyBoxesItTested) {
  std::size_t boxes = 10;
  unproved_of(height_field("u"), lines_along_u(), 1e-3, boxes);
  EXPECT_EQ(boxes, 11);  // one around all lines is enough
  unproved_of(height_field("u"), {lines_along_u()[0]}, 1e-3, boxes);
  EXPECT_EQ(boxes, 12);
  const std::array<Line, 1> line = {lines_along_u()[0].part};
  Patience patience;
  unproved_normals(height_field("u"), line, patience, boxes);
  EXPECT_EQ(boxes, 13);
}

TEST(Continuity, IsNotProvedAtAnyOfSomeBreaksOfALine) {
  // Five, each in the second half of what was halved last.
  const Surface surface = height_field("floor(20*u)");
  const LinePart line{0, {dvec2(-0.7142857142857143, 0.3), dvec2(-0.45000000000000007, 0.3)}, 1};
  std::size_t boxes = 0;
  const std::vector<LinePart> parts = unproved_of(surface, {line}, 1e-3, boxes);
  for (const double u : {-0.7, -0.65, -0.6, -0.55, -0.5}) {
    const auto is_there = [u](const LinePart& part) {
      return part.part[0].x - 1e-14 <= u && u <= part.part[1].x + 1e-14;
    };
    EXPECT_TRUE(std::ranges::any_of(parts, is_there)) << u;
  }
}

/// Halvings to doubles beside the jump would take two boxes each.
TEST(Continuity, ComesToAJumpAtAShortNumberInFewBoxes) {
  const Surface surface = height_field("exp(u)+rint(u)");
  for (const auto& [from, to] : {std::array{0.31, 0.57}, {0.57, 0.31}, {0.5, 0.31}, {0.31, 0.5}}) {
    for (const bool along_u : {true, false}) {
      const auto place = [along_u = along_u](double at) {
        return along_u ? dvec2(at, 0.3) : dvec2(0.3, at);
      };
      const Surface& of = along_u ? surface : height_field("exp(v)+rint(v)");
      std::size_t boxes = 0;
      const auto parts = unproved_of(of, {{0, {place(from), place(to)}}}, 1e-3, boxes);
      ASSERT_EQ(parts.size(), 1) << from;
      const auto [first, last] = parts[0].part;
      const int axis = along_u ? 0 : 1;
      EXPECT_LE(std::min(first[axis], last[axis]), 0.5);
      EXPECT_GE(std::max(first[axis], last[axis]), 0.5);
      EXPECT_LT(std::fabs(last[axis] - first[axis]), 1e-15);
      EXPECT_LT(boxes, 20) << from;
    }
  }
}

TEST(Continuity, IsNotProvedOnEitherSideOfAKnownBreak) {
  const Surface surface = height_field("ln(abs(u-0.33))");
  const dvec2 pole(0.33, 0.3);
  std::size_t boxes = 0;
  const auto found = unproved_of(
      surface, {{0, {dvec2(-1, 0.3), pole}, 1}, {1, {pole, dvec2(1, 0.3)}, 0}}, 1e-3, boxes);
  EXPECT_LT(boxes, 100);
  ASSERT_EQ(found.size(), 2);
  EXPECT_EQ(found[0].part[1], pole);
  EXPECT_EQ(found[1].part[0], pole);
  for (const LinePart& part : found) EXPECT_LT(part.part[1].x - part.part[0].x, 1e-14);
}

TEST(Continuity, IsGivenUpSoonWhereBoundsAreTooWide) {
  // The bounds of the difference, which is the slope of e^u to rounding, hold 0.
  const Surface surface = height_field("1/((exp(u+1e-9)-e^u)/1e-9)");
  std::size_t boxes = 0;
  const auto parts = unproved_of(surface, lines_along_u(), 1e-3, boxes);
  EXPECT_EQ(parts.size(), kMostLineParts * kLines);  // all of each line
  EXPECT_LT(boxes, 15U * kLines);
}

TEST(Continuity, IsProvedWhereBoundsAreTooWideForLongParts) {
  // A part is proved if it is shorter than the step: 1/25 of a line.
  const Surface surface = height_field("1/((exp(u+2e-3)-e^u)/2e-3)");
  std::size_t boxes = 0;
  EXPECT_TRUE(unproved_of(surface, lines_along_u(), 1e-3, boxes).empty());
}

TEST(Continuity, IsNotAskedForBelowTheJumpsThatMatter) {
  EXPECT_TRUE(unproved_of("sign(u-0.31)*abs(u-0.31)^3", 1e-3).empty());
  EXPECT_TRUE(unproved_of("floor(2*u+0.1)*1e-4", 1e-3).empty());
  EXPECT_FALSE(unproved_of("floor(2*u+0.1)*1e-2", 1e-3).empty());
}

std::vector<std::size_t> lines_without_normals(const Surface& surface) {
  std::vector<Line> lines;
  for (const LinePart& line : lines_along_u()) lines.push_back(line.part);
  std::size_t boxes = 0;
  Patience patience;
  return unproved_normals(surface, lines, patience, boxes).lines;
}

TEST(Continuity, OfNormalsIsProvedButWhereTheyMayJump) {
  const auto of_height = [](const char* z) { return lines_without_normals(height_field(z)); };
  for (const char* z : {"sin(300*u*v)", "tanh(1e5*u)", "sign(u-2)"}) {
    EXPECT_TRUE(of_height(z).empty()) << z;
  }
  // Lines are a twentieth long, and most are proved.
  constexpr std::size_t kAt = 26;
  for (const char* z : {"abs(u-0.33)", "floor(u+0.67)", "1/(u-0.33)", "cbrt(u-0.33)"}) {
    const std::vector<std::size_t> lines = of_height(z);
    EXPECT_EQ(std::ranges::count(lines, kAt), 1) << z;
    EXPECT_LE(lines.size(), kLines / 4) << z;
    EXPECT_TRUE(std::ranges::is_sorted(lines)) << z;
  }
  const Surface cusp =
      surface_from_text("(u-0.33)^2", "v", "(u-0.33)^3", {-1, 1, -1, 1}, {}, Order::Second);
  EXPECT_EQ(std::ranges::count(lines_without_normals(cusp), kAt), 1);
}

TEST(Continuity, OfTangentsIsProvedForAllLinesAtOnce) {
  std::vector<Line> lines;
  for (const LinePart& line : lines_along_u()) lines.push_back(line.part);
  const auto is_proved = [&](const Surface& surface) {
    std::size_t boxes = 0;
    Patience patience;
    return unproved_normals(surface, lines, patience, boxes).only_cusps;
  };
  for (const char* z : {"sin(300*u*v)", "tanh(1e5*u)", "(u-0.33)^5"}) {
    EXPECT_TRUE(is_proved(height_field(z))) << z;
  }
  EXPECT_TRUE(is_proved(
      surface_from_text("(u-0.33)^2", "v", "(u-0.33)^3", {-1, 1, -1, 1}, {}, Order::Second)));
  for (const char* z : {"abs(u-0.33)", "max(u,v)", "floor(u)", "1/(u-0.33)", "sqrt(u+1)"}) {
    EXPECT_FALSE(is_proved(height_field(z))) << z;
  }
}

TEST(Continuity, OfNormalsIsNotProvedByRounding) {
  // On v = 2 pi there is no normal, but for the digits that 2 pi lacks.
  const Surface surface = surface_from_text("u*sin(v)", "cos(v)", "u^2*sin(v)",
                                            {-1, 1, 0, 8 * std::atan(1.0)}, {}, Order::Second);
  const std::array<Line, 8> lines = [&] {
    std::array<Line, 8> result;
    for (std::size_t k = 0; k < result.size(); ++k) {
      const double u = 0.1 * static_cast<double>(k);
      result[k] = {dvec2(u, surface.domain.v1), dvec2(u + 0.1, surface.domain.v1)};
    }
    return result;
  }();
  std::size_t boxes = 0;
  Patience patience;
  EXPECT_EQ(unproved_normals(surface, lines, patience, boxes).lines.size(), lines.size());
  EXPECT_GT(boxes, 0U);
}

TEST(Continuity, OfNormalsIsProvedWhicheverWayTheyPoint) {
  for (const auto& [x, y, z] :
       {std::array{"0", "u", "v"}, {"u", "0", "v"}, {"u", "v", "0"}, {"1e-8*u", "1e-8*v", "0"}}) {
    const Surface plane = surface_from_text(x, y, z, {-1, 1, -1, 1}, {}, Order::Second);
    EXPECT_TRUE(lines_without_normals(plane).empty()) << x << " " << y << " " << z;
  }
}

TEST(Continuity, OfNormalsIsNotProvedOfTangentsThatAreParallel) {
  for (const auto& [x, y, z] : {std::array{"u+v+1", "2*(u+v)", "3*(u+v)"},
                                // Parallel but for what may be rounding, and large.
                                {"1e3*(u+v)", "1e-6*v", "1e3*(u+v)"}}) {
    const Surface line = surface_from_text(x, y, z, {-1, 1, -1, 1}, {}, Order::Second);
    EXPECT_EQ(lines_without_normals(line).size(), kLines) << x;
  }
}

TEST(Continuity, OfNormalsIsGivenUpWhereProofsAreInVain) {
  constexpr std::size_t kMany = 10000;
  std::vector<Line> lines;
  for (std::size_t k = 0; k < kMany; ++k) {
    const double u = -1 + 2.0 * static_cast<double>(k) / kMany;
    lines.push_back({dvec2(u, 0.3), dvec2(u + 1e-4, 0.3)});
  }
  Patience patience;
  const auto boxes_for = [&](const char* z, std::size_t unproved) {
    std::size_t boxes = 0;
    EXPECT_EQ(unproved_normals(height_field(z), lines, patience, boxes).lines.size(), unproved)
        << z;
    return boxes;
  };
  const std::size_t first = boxes_for("floor(1e6*u)", kMany);
  EXPECT_LT(first, kMany / 100);
  EXPECT_LT(boxes_for("floor(1e6*u)", kMany), first);  // the next lines with less patience
  patience.learn(true);
  EXPECT_EQ(boxes_for("floor(1e6*u)", kMany), first);
  patience.learn(true);
  // Half of them are proved before the others are tried.
  EXPECT_GT(boxes_for("floor(max(0.5, 1e6*u))", kMany / 2), kMany / 10);
}

}  // namespace
}  // namespace saddle
