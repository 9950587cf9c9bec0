// Enclosures hold what 50 digits give at points hidden in the box, and what doubles give; what they
// claim about being defined is true. For every row of the table and for random formulas.
#include "eval/interval.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>

#include "eval/batch.h"
#include "eval/enclose.h"
#include "eval/kernels.h"
#include "formula/derive.h"
#include "formula/operations.h"
#include "graph_value.h"
#include "random_formula.h"
#include "strict_value.h"

namespace saddle {
namespace {

using testing::StrictValue;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// What the evaluator's loops give, with SLEEF's functions.
double apply_in_vectors(Op op, double a, double b, double c) {
  const std::array<Operand, 3> in = {Operand{&a, true}, Operand{&b, true}, Operand{&c, true}};
  double out = 0;
  kernels(cpu_level())[op](&out, in.data(), 1);
  return out;
}

std::string text(const Interval& a) {
  static constexpr std::array kNames = {"No", "Maybe", "Yes"};
  std::ostringstream out;
  out.precision(17);
  out << "[" << a.low << ", " << a.high << "] " << kNames[static_cast<std::size_t>(a.defined)]
      << (a.continuous ? " continuous" : "");
  return out.str();
}

/// Seeded boxes of all sizes and points in them.
class RandomBox {
 public:
  explicit RandomBox(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) / 9007199254740992.0);
  }
  std::size_t pick(std::size_t count) { return engine_() % count; }

  /// A box that ends at, holds or is near a number where functions are special, or anywhere.
  /// Up to `reach` large, endless now and then.
  Interval box(double reach, bool endless) {
    static constexpr std::array<double, 16> kSpecial = {
        0,    1,      -1,   0.5,  -0.5, 2, -2, 3, -3, 1.5707963267948966, 3.141592653589793,
        -1.5, 1.4616, -0.0, -2.5, 1e-12};
    const double start = pick(2) == 0 ? kSpecial[pick(kSpecial.size())] : uniform(-4, 4);
    const double width = std::min(reach, std::pow(10.0, uniform(-12, 3)));
    switch (pick(endless ? 10 : 8)) {
      case 0:
        return {start, start};
      case 1:
      case 2:
        return {start, start + width};
      case 3:
      case 4:
        return {start - width, start};
      case 8:
        return {start, kInfinity};
      case 9:
        return {-kInfinity, start};
      default:
        return {start - width * uniform(0, 1), start + width * uniform(0, 1)};
    }
  }

  /// A number in the box: an end, or one inside.
  double inside(const Interval& a) {
    const std::size_t place = pick(4);
    const double far = std::pow(10.0, uniform(-12, 3));
    if (std::isinf(a.low)) return place == 0 ? a.high : a.high - far;
    if (std::isinf(a.high)) return place == 0 ? a.low : a.low + far;
    if (place == 0) return a.low;
    if (place == 1) return a.high;
    return std::clamp(uniform(a.low, a.high), a.low, a.high);
  }

 private:
  std::mt19937_64 engine_;
};

/// The reference's own error: 50 digits, less the ten that cancel in its worst formulas.
const Real kReferenceError("1e-40");

bool holds(const Interval& a, const Real& x) {
  const Real slack = kReferenceError * (1 + abs(x));
  return Real(a.low) - slack <= x && x <= Real(a.high) + slack;
}

/// What an enclosure says against the truth at one point of the box, and against doubles there.
void expect_true_of(const Interval& r, const StrictValue& exact, double computed,
                    const std::string& what) {
  if (exact.kind == StrictValue::Number) {
    EXPECT_NE(r.defined, Defined::No) << what << " has the value " << exact.value;
    EXPECT_TRUE(holds(r, exact.value)) << what << " is " << text(r) << ", not " << exact.value;
  }
  if (exact.kind == StrictValue::Undefined) {
    EXPECT_NE(r.defined, Defined::Yes) << what << " is undefined, not " << text(r);
  }
  if (!std::isfinite(computed)) return;
  EXPECT_TRUE(contains(r, computed)) << what << " is " << text(r) << ", computed " << computed;
}

StrictValue number(double x) {
  return {StrictValue::Number, x};
}

struct Arguments {
  Interval a, b, c;

  static Arguments random(Op op, RandomBox& random) {
    // The reference's series for sin(x)/x is good up to 20, and its gamma slow and huge far out.
    const bool special = takes_an_order(op) || op == Op::Gamma || op == Op::Lgamma;
    const double reach = special ? 10 : 1000;
    Arguments boxes = {random.box(reach, !special), random.box(reach, !special),
                       random.box(reach, !special)};
    if (takes_an_order(op)) boxes.a.low = boxes.a.high = static_cast<double>(random.pick(4));
    if (op == Op::Pow && random.pick(2) == 0) {
      boxes.b.low = boxes.b.high = static_cast<double>(random.pick(9)) - 4;
    }
    return boxes;
  }
};

TEST(Enclosure, HoldsTheExactAndTheComputedValueOfEveryOperation) {
  constexpr int kBoxes = 400;
  RandomBox random(1);
  for (const Operation& row : kOperations) {
    const Op op = row.op;
    int numbers = 0;
    int bounded = 0;
    for (int i = 0; i < kBoxes; ++i) {
      const auto [a, b, c] = Arguments::random(op, random);
      const Interval r = enclose(op, a, b, c);
      bounded += std::isfinite(r.low) && std::isfinite(r.high) ? 1 : 0;
      const double x = random.inside(a);
      const double y = random.inside(b);
      const double z = random.inside(c);
      const StrictValue exact = apply_strictly(op, number(x), number(y), number(z));
      numbers += exact.is_number() ? 1 : 0;
      std::ostringstream what;
      what.precision(17);
      what << row_of(op).id << " at " << x << ", " << y << ", " << z << " in " << text(a) << ", "
           << text(b) << ", " << text(c);
      expect_true_of(r, exact, apply(op, x, y, z), what.str());
      expect_true_of(r, exact, apply_in_vectors(op, x, y, z), what.str() + ", in vectors");
    }
    EXPECT_GT(numbers, kBoxes / 6) << row_of(op).id << " was hardly ever compared";
    EXPECT_GT(bounded, kBoxes / 8) << row_of(op).id << " was hardly ever bounded";
  }
}

/// Any double but NaN: denormal, huge, infinite, or of few bits.
double extreme_number(RandomBox& random) {
  static constexpr std::array<double, 8> kSpecial = {0, -0.0, 1, -1, kInfinity, -kInfinity, 0.5, 2};
  if (random.pick(4) == 0) return kSpecial[random.pick(kSpecial.size())];
  const double size = std::ldexp(random.uniform(1, 2), static_cast<int>(random.pick(2098)) - 1074);
  return random.pick(2) == 0 ? size : -size;
}

Interval extreme_box(RandomBox& random) {
  const double x = extreme_number(random);
  const double y = random.pick(3) == 0 ? x : extreme_number(random);
  return {std::min({x, y, std::numeric_limits<double>::max()}),
          std::max({x, y, -std::numeric_limits<double>::max()})};
}

/// A finite end of the box.
double finite_end(const Interval& a) {
  return std::isfinite(a.low) ? a.low : std::isfinite(a.high) ? a.high : 0;
}

TEST(Enclosure, HasNumbersAsBoundsAndHoldsTheComputedValueAtTheEndsOfTheRangeOfDoubles) {
  RandomBox random(3);
  for (const Operation& row : kOperations) {
    const Op op = row.op;
    for (int i = 0; i < 1000; ++i) {
      Interval a = extreme_box(random);
      if (takes_an_order(op)) a = {1, 1};
      const Interval b = extreme_box(random);
      const Interval c = extreme_box(random);
      const Interval r = enclose(op, a, b, c);
      const double computed = apply(op, finite_end(a), finite_end(b), finite_end(c));
      const std::string what = std::string(row_of(op).id) + " of " + text(a) + text(b) + text(c) +
                               " is " + text(r) + ", computed " + std::to_string(computed);
      EXPECT_TRUE(!std::isfinite(computed) || contains(r, computed)) << what;
      if (r.defined == Defined::No) continue;
      EXPECT_TRUE(r.low <= r.high && r.low < kInfinity && r.high > -kInfinity) << what;
    }
  }
}

/// Width that roundings of a few ULP at both ends explain, and the special functions' series.
double roundings(Op op, double size) {
  const bool special = takes_an_order(op) || op == Op::Gamma || op == Op::Lgamma;
  return special ? 2e-12 * (1 + size) : 24 * kEpsilon * size;
}

/// The least and largest of the values at the corners: the range, of a monotone function.
struct CornerRange {
  double low = kInfinity;
  double high = -kInfinity;
  bool numbers = true;

  CornerRange(Op op, const Interval& a, const Interval& b, const Interval& c) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const double value =
          apply(op, (corner & 1U) == 0 ? a.low : a.high, (corner & 2U) == 0 ? b.low : b.high,
                (corner & 4U) == 0 ? c.low : c.high);
      numbers = numbers && std::isfinite(value);
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
};

TEST(Enclosure, IsAsNarrowAsTheRangeWhereAFunctionIsMonotone) {
  struct Box {
    Interval a, b;
  };
  // No function turns within these, and a few are undefined in each.
  const std::array<Box, 6> boxes = {{{{0.2, 0.9}, {0.3, 0.8}},
                                     {{1.1, 1.4}, {2.1, 2.3}},
                                     {{-0.45, -0.15}, {0.3, 0.35}},
                                     {{0.3, 0.3 + 1e-9}, {1.7, 1.7 + 1e-9}},
                                     {{2.2, 2.2 + 1e-7}, {-2.7, -2.7 + 1e-7}},
                                     {{1e-5, 1.1e-5}, {1e-3, 1.1e-3}}}};
  for (const Operation& row : kOperations) {
    const Op op = row.op;
    int compared = 0;
    for (Box box : boxes) {
      if (takes_an_order(op)) box.a = {1, 1};
      const Interval c = {0.6, 0.7};
      const Interval r = enclose(op, box.a, box.b, c);
      const CornerRange range(op, box.a, box.b, c);
      if (!range.numbers || !r.continuous || r.defined != Defined::Yes) continue;
      ++compared;
      const double slack = roundings(op, std::max(std::fabs(range.low), std::fabs(range.high)));
      EXPECT_GE(r.low, range.low - slack) << row_of(op).id << text(box.a) << text(box.b) << text(r);
      EXPECT_LE(r.high, range.high + slack)
          << row_of(op).id << text(box.a) << text(box.b) << text(r);
    }
    EXPECT_GE(compared, 2) << row_of(op).id << " was never compared";
  }
}

/// A formula with its first and second derivatives, to be valued in every way.
struct Formula {
  Graph graph;
  std::vector<NodeId> roots;

  explicit Formula(const std::string& formula) {
    const NodeId f = testing::parse(graph, formula);
    const NodeId f_u = derive(graph, std::array{f}, kSymbolU)[0];
    const NodeId f_v = derive(graph, std::array{f}, kSymbolV)[0];
    roots = {f,
             f_u,
             f_v,
             derive(graph, std::array{f_u}, kSymbolU)[0],
             derive(graph, std::array{f_u}, kSymbolV)[0],
             derive(graph, std::array{f_v}, kSymbolV)[0]};
  }

  /// In doubles; NaN for all roots if any value on the way is infinite or NaN.
  std::vector<double> computed(double u, double v) const {
    std::vector<double> result(roots.size());
    std::vector<double*> outputs;
    for (double& x : result) outputs.push_back(&x);
    evaluate_points(compile(graph, roots), std::array{u}, std::array{v}, outputs, 1);
    for (std::size_t k = 0; k < roots.size(); ++k) {
      const std::vector<bool> needed = reachable(graph, std::array{roots[k]});
      const std::vector<double> values = testing::values(graph, roots[k], u, v);
      for (NodeId id = 0; id <= roots[k]; ++id) {
        if (needed[id] && !std::isfinite(values[id])) result[k] = std::nan("");
      }
    }
    return result;
  }
};

TEST(Enclosure, HoldsTheValuesOfRandomFormulasAndOfTheirDerivatives) {
  constexpr int kFormulas = 1200;
  testing::RandomFormula random_formula(11);
  RandomBox random(12);
  int numbers = 0;
  int bounded = 0;
  for (int i = 0; i < kFormulas; ++i) {
    const std::string formula = random_formula(1 + i % 4);
    const Formula f(formula);
    Enclosure whole(compile(f.graph, f.roots, Powers::Whole));
    Enclosure products(compile(f.graph, f.roots, Powers::Products));
    for (int k = 0; k < 3; ++k) {
      const Interval u = random.box(3, i % 8 == 0);
      const Interval v = random.box(3, false);
      std::vector<Interval> of_whole(f.roots.size());
      std::vector<Interval> of_products(f.roots.size());
      whole(u, v, of_whole);
      products(u, v, of_products);
      const double x = random.inside(u);
      const double y = random.inside(v);
      const std::vector<StrictValue> exact = testing::strict_values(f.graph, f.roots, x, y);
      const std::vector<double> computed = f.computed(x, y);
      for (std::size_t j = 0; j < f.roots.size(); ++j) {
        std::ostringstream what;
        what.precision(17);
        what << "derivative " << j << " of " << formula << " at " << x << ", " << y << " in "
             << text(u) << ", " << text(v);
        expect_true_of(of_whole[j], exact[f.roots[j]], computed[j], what.str());
        expect_true_of(of_products[j], exact[f.roots[j]], computed[j], what.str() + ", products");
        numbers += exact[f.roots[j]].is_number() ? 1 : 0;
        bounded += of_whole[j].high - of_whole[j].low < 1e3 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(numbers, kFormulas * 5);
  EXPECT_GT(bounded, kFormulas * 5);
}

}  // namespace
}  // namespace saddle
