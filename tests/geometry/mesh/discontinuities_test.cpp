// Where normals or positions jump along lines of parameters, to the last double on either side.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "mesh/features/creases.h"
#include "mesh/features/discontinuities.h"
#include "surface/normal.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// What is found on a line. Adds to `work` the points and boxes that were looked at.
LocatedDiscontinuity find_crease(const Surface& surface, const Line& line, std::size_t& work) {
  std::array<dvec3, 2> normals{};
  for (std::size_t end = 0; end < 2; ++end) {
    normals[end] = *normal_direction(evaluate(surface, std::array{line[end]})[0]);
  }
  Patience patience;
  return find_creases(surface, std::span(&line, 1), std::span(&normals, 1), 1, patience, work)[0];
}
LocatedDiscontinuity find_crease(const Surface& surface, const Line& line) {
  std::size_t work = 0;
  return find_crease(surface, line, work);
}

/// How many doubles there are from a to b, a being the smaller one; 9 if there are more.
int doubles_between(double a, double b) {
  int count = 0;
  for (; a < b && count < 9; ++count) a = std::nextafter(a, b);
  return count;
}

const double kPlace = std::sqrt(0.5);

void expect_at_place(const Surface& surface, const Line& line, bool is_cusp = true) {
  const LocatedDiscontinuity found = find_crease(surface, line);
  ASSERT_NE(found.kind, Discontinuity::None);
  const double low = std::min(found.ends[0].x, found.ends[1].x);
  const double high = std::max(found.ends[0].x, found.ends[1].x);
  EXPECT_LE(doubles_between(low, high), 8);  // the place itself may have no normal
  EXPECT_LE(low, kPlace);
  EXPECT_GE(high, kPlace);
  EXPECT_EQ(found.ends[0].y, line[0].y);
  EXPECT_EQ(found.is_cusp, is_cusp);
}

TEST(CreaseSearch, FindsCuspsBetweenTheLastDoubles) {
  // The normal turns to its opposite while r_u goes through zero.
  const Surface cusp = surface_from_text("(u-sqrt(0.5))^2", "(u-sqrt(0.5))^3+u*v*0", "v",
                                         {-1, 2, -1, 1}, {}, Order::Second);
  expect_at_place(cusp, {dvec2(-1, 0.3), dvec2(2, 0.3)});
  expect_at_place(cusp, {dvec2(2, 0.3), dvec2(-1, 0.3)});
  expect_at_place(cusp, {dvec2(kPlace - 1e-9, 0.3), dvec2(2, 0.3)});
  expect_at_place(cusp, {dvec2(kPlace - 1e-9, 0.3), dvec2(kPlace + 1e-12, 0.3)});
}

TEST(CreaseSearch, FindsKinksBetweenTheLastDoubles) {
  // Nothing goes through zero, and the slopes on both sides differ by a factor.
  const Surface kink = surface_from_text("u", "v", "u<sqrt(0.5)?40*(u-sqrt(0.5)):0.1*(u-sqrt(0.5))",
                                         {-1, 2, -1, 1}, {}, Order::Second);
  expect_at_place(kink, {dvec2(-1, 0.3), dvec2(2, 0.3)}, false);
  expect_at_place(kink, {dvec2(kPlace - 1e-9, 0.3), dvec2(2, 0.3)}, false);
}

TEST(CreaseSearch, WorksAtScalesFarFromOne) {
  for (const char* scale : {"1e-150", "1e150"}) {
    const std::string s = scale;
    const Surface cusp = surface_from_text(s + "*(u-sqrt(0.5))^2", s + "*(u-sqrt(0.5))^3", s + "*v",
                                           {-1, 2, -1, 1}, {}, Order::Second);
    expect_at_place(cusp, {dvec2(-1, 0.3), dvec2(2, 0.3)});
  }
}

TEST(CreaseSearch, FindsNoneWhereASmoothSurfaceTurns) {
  const Surface bend = height_field("tanh(1000*(u-0.3))", {-1, 2, -1, 1});
  EXPECT_EQ(find_crease(bend, {dvec2(-1, 0.3), dvec2(2, 0.3)}).kind, Discontinuity::None);
}

TEST(CreaseSearch, EndsSoonWhereOnlyCuspsCanBe) {
  // The same turn of normals, once with tangents that bounds prove to be continuous.
  const auto work_of = [](const char* z) {
    std::size_t work = 0;
    find_crease(height_field(z, {-1, 2, -1, 1}), {dvec2(-1, 0.3), dvec2(2, 0.3)}, work);
    return work;
  };
  EXPECT_LT(work_of("0.4*u^2"), 8U);
  EXPECT_GT(work_of("0.4*u^2+1e-9*abs(u-0.5)"), 10U);
}

TEST(JumpSearch, FindsJumpsToAnUprightRoot) {
  // The root starts with an infinite slope, at each of several doubles beside the jump.
  const Surface roots = height_field("sqrt(abs(mod(u*v,1)))", {-3, 3, -3, 3});
  for (const double v : {-1.1507151057359097, -1.150715106, 0.75, 2.3}) {
    const dvec2 below(0.99 / v, v);
    const dvec2 above(1.001 / v, v);
    for (const Line& line : {Line{below, above}, Line{above, below}}) {
      std::size_t work = 0;
      const LocatedDiscontinuity found =
          find_discontinuities(roots, std::span(&line, 1), 0.01, 1, work)[0];
      ASSERT_EQ(found.kind, Discontinuity::Jump) << v;
      const std::vector<SurfacePoint> ends = evaluate(roots, found.ends, 1);
      EXPECT_GT(std::fabs(ends[0].position.z - ends[1].position.z), 0.99) << v;
    }
  }
}

LocatedDiscontinuity found_on(const Surface& surface, const Line& line) {
  std::size_t work = 0;
  return find_discontinuities(surface, std::span(&line, 1), 0.003, 1, work)[0];
}

/// At v = -1 a place 2^30 units of rounding from the jump is a quarter of a millionth from it.
TEST(JumpSearch, FindsJumpsBesideRootsOfHighOrder) {
  for (const char* z : {"u<0?1:u^0.17", "u<0?1:u^0.25", "sign(u)*(1+abs(u)^0.2)"}) {
    const auto found = found_on(height_field(z), {dvec2(-0.004, -1), dvec2(0.01, -1)});
    ASSERT_EQ(found.kind, Discontinuity::Jump) << z;
    for (const dvec2& end : found.ends) EXPECT_NEAR(end.x, 0, 1e-15) << z;
    EXPECT_FALSE(found.between) << z;
  }
}

/// Rounding makes cos(u) 1 as far as 1e-8 from 0, and beside that here and there.
TEST(JumpSearch, EndsAtTheEndOfALineThatHasAValueOfItsOwn) {
  const Surface step = height_field("floor(2*cos(u))");
  for (const double v : {-1.0, -0.4667, 0.0, 0.3333}) {
    for (const double from : {-0.0667, 0.00833, 0.00026}) {
      const auto found = found_on(step, {dvec2(from, v), dvec2(0, v)});
      ASSERT_EQ(found.kind, Discontinuity::Jump) << from << ' ' << v;
      EXPECT_NEAR(found.ends[0].x, 0, 3e-8) << from << ' ' << v;
      EXPECT_EQ(found.ends[1].x, 0) << from << ' ' << v;
      EXPECT_FALSE(found.between) << from << ' ' << v;
    }
  }
  // The sheet of a disc begins at its tip, which the line touches.
  const Surface disc = height_field("((u-0.05)^2+((v-0.1)/0.4)^2<0.49)?1:0");
  const auto found = found_on(disc, {dvec2(0.75, 0.0833), dvec2(0.75, 0.1)});
  ASSERT_EQ(found.kind, Discontinuity::Jump);
  EXPECT_LT(found.ends[1].y, 0.1);
}

TEST(JumpSearch, EndsBesidePolesThatHaveAValueOfTheirOwn) {
  for (const char* z : {"(u==v)?0:1/(u-v)", "(abs(u-v)<1e-12)?0:1/(u-v)"}) {
    const Surface guarded = height_field(z);
    const auto found = found_on(guarded, {dvec2(0.5, 0.25), dvec2(0.5, 0.75)});
    ASSERT_EQ(found.kind, Discontinuity::Pole) << z;
    const std::vector<SurfacePoint> ends = evaluate(guarded, found.ends, 1);
    EXPECT_GT(ends[0].position.z, 1e9) << z;
    EXPECT_LT(ends[1].position.z, -1e9) << z;
  }
}

/// Three jumps as far apart as the step of a difference, 1e-5 of the line and less.
const char* const kThreeSteps = "(u>0.3?1:0)-2*(u>0.30001?1:0)+3*(u>0.300015?1:0)";

TEST(JumpSearch, FindsJumpsWithoutAValueBetweenTheirSides) {
  const Line line = {dvec2(-1, 0.25), dvec2(1, 0.25)};
  const auto kind_of = [&](const char* z) {
    std::size_t work = 0;
    const auto found = find_discontinuities(height_field(z), std::span(&line, 1), 0.01, 1, work)[0];
    if (found.kind == Discontinuity::Jump) {
      EXPECT_NEAR(found.ends[0].x, 0.25, 1e-6) << z;
      EXPECT_NEAR(found.ends[1].x, 0.25, 1e-6) << z;
    }
    return found.kind;
  };
  for (const char* z : {"(u-v)/abs(u-v)", "(u^2-v^2)/abs(u^2-v^2)*(u+1)", "abs(u-v)/(u-v)+u"})
    EXPECT_EQ(kind_of(z), Discontinuity::Jump) << z;
  for (const char* z : {"1/(u-v)", "1/(u-v)^2", "ln(abs(u-v))"})
    EXPECT_EQ(kind_of(z), Discontinuity::Pole) << z;
  for (const char* z : {"sin(u-v)/(u-v)", "(u-v)^2/abs(u-v)", "(u^3-v^3)/(u-v)"})
    EXPECT_EQ(kind_of(z), Discontinuity::None) << z;
}

TEST(JumpSearch, FindsOnePoleWhereRoundingMakesMore) {
  // Values at neighbouring doubles beside the pole differ by more than the tolerance.
  const Surface tangents = height_field("tan(1.605*u)*v");
  for (const double v : {1.3636423165604259e-05, -1.9165264946354918e-05, -0.0333}) {
    const Line line = {dvec2(0.97868667679372201, v), dvec2(0.97868999249428301, v)};
    std::size_t work = 0;
    const auto found = find_discontinuities(tangents, std::span(&line, 1), 0.008, 1, work)[0];
    EXPECT_EQ(found.kind, Discontinuity::Pole);
    EXPECT_FALSE(found.between) << v;
  }
}

TEST(JumpSearch, FindsJumpsAcrossTheTipOfAHole) {
  const Surface ring =
      height_field("(u^2+v^2<4&&u^2+v^2>1)?atan2(v,u):nan", {-2.5, 2.5, -2.5, 2.5});
  const Surface sectors = height_field("(abs(v)<abs(u))?atan2(v,u):nan");
  const Surface hole = height_field("(hypot(u,v)>1e-8)?v:nan");
  const Line beside_rim = {dvec2(-1, -5e-7), dvec2(-1, 2e-6)};
  const Line beside_tip = {dvec2(-1.4e-7, 3e-8), dvec2(1.4e-7, 3e-8)};
  const auto kind_of = [](const Surface& surface, const Line& line) {
    std::size_t work = 0;
    return find_discontinuities(surface, std::span(&line, 1), 0.01, 1, work)[0].kind;
  };
  EXPECT_EQ(kind_of(ring, beside_rim), Discontinuity::Jump);
  EXPECT_EQ(kind_of(sectors, beside_tip), Discontinuity::Jump);
  EXPECT_EQ(kind_of(hole, beside_tip), Discontinuity::None) << "both sides are of one sheet";
}

TEST(JumpSearch, TellsPolesApartWhereTheOtherParameterIsLarge) {
  const Surface poles = height_field("1e-9/((u-0.31)*(u-0.33))", {0, 1, 0, 2e8});
  for (const double v : {0.3, 1e8}) {
    const Line line = {dvec2(0.3, v), dvec2(0.37, v)};
    std::size_t work = 0;
    EXPECT_TRUE(find_discontinuities(poles, std::span(&line, 1), 0.001, 1, work)[0].between) << v;
  }
}

/// Doubles are 1.2e-10 apart there: places far enough from a jump for rounding are elsewhere.
TEST(JumpSearch, FindsJumpsFarFromZeroBetweenTheLastDoubles) {
  const Surface parabola = height_field("(u-1e6<v^2)?1:-1", {999999, 1000001, -1, 1});
  const Line line = {dvec2(1000000.02, 0.16), dvec2(1000000.03, 0.16)};
  std::size_t work = 0;
  const auto found = find_discontinuities(parabola, std::span(&line, 1), 0.003, 1, work)[0];
  ASSERT_EQ(found.kind, Discontinuity::Jump);
  for (const dvec2& end : found.ends) EXPECT_NEAR(end.x, 1000000.0256, 1e-9);
}

TEST(JumpSearch, FindsAllJumpsOfALineAtOnce) {
  const Surface steps = height_field(kThreeSteps, {-1, 2, -1, 1});
  for (const Line& line :
       {Line{dvec2(-1, 0.3), dvec2(2, 0.3)}, Line{dvec2(2, 0.3), dvec2(-1, 0.3)}}) {
    std::size_t work = 0;
    const auto found = find_discontinuities(steps, std::span(&line, 1), 0.01, 1, work);
    EXPECT_LT(work, 600U);
    const std::size_t before = work;
    const auto jumps = find_all_jumps(steps, std::span(&line, 1), found, 0.01, 1, work)[0];
    EXPECT_EQ(work, before);
    ASSERT_EQ(jumps.size(), 3U);
    std::array places = {0.3, 0.30001, 0.300015};
    if (line[0].x > line[1].x) std::ranges::reverse(places);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LE(std::min(jumps[k][0].x, jumps[k][1].x), places[k]);
      EXPECT_GE(std::max(jumps[k][0].x, jumps[k][1].x), places[k]);
      EXPECT_LE(doubles_between(std::min(jumps[k][0].x, jumps[k][1].x),
                                std::max(jumps[k][0].x, jumps[k][1].x)),
                2);
    }
  }
}

TEST(JumpSearch, FindsAllJumpsWhereBoundsProveNothing) {
  // The bounds of the difference, which is 1 to rounding, hold 0 on all lines that are searched.
  const std::string one = "((u+1e-9)-u)/1e-9";
  const Surface steps =
      height_field("(" + std::string(kThreeSteps) + ")/(" + one + ")", {-1, 2, -1, 1});
  const Line line = {dvec2(-1, 0.3), dvec2(2, 0.3)};
  std::size_t work = 0;
  const auto found = find_discontinuities(steps, std::span(&line, 1), 0.01, 1, work);
  EXPECT_EQ(found[0].kind, Discontinuity::Jump);
  EXPECT_EQ(found[0].jumps.size(), 3U);
  EXPECT_EQ(find_all_jumps(steps, std::span(&line, 1), found, 0.01, 1, work)[0].size(), 3U);
}

TEST(JumpSearch, GivesUpAtOnceWhereALineIsKnownToHaveWaves) {
  const Surface waves = height_field("floor(40*u)/4", {-1, 2, -1, 1});
  const Line line = {dvec2(-1, 0.3), dvec2(2, 0.3)};
  std::size_t work = 0;
  const auto found = find_discontinuities(waves, std::span(&line, 1), 0.01, 1, work);
  EXPECT_EQ(found[0].kind, Discontinuity::Jump);
  EXPECT_TRUE(found[0].has_waves);
  const std::size_t before = work;
  EXPECT_TRUE(find_all_jumps(waves, std::span(&line, 1), found, 0.01, 1, work)[0].empty());
  EXPECT_EQ(work, before);
}

}  // namespace
}  // namespace saddle
