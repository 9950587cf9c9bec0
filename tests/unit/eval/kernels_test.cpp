// The loops of all CPU levels give the same bits, and those of the plain function to a rounding.
#include "eval/kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "formula/operations.h"

namespace saddle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Numbers of all kinds; more than a vector's width, and not a multiple of it.
std::vector<double> nasty_numbers() {
  std::vector<double> numbers = {0.0,
                                 -0.0,
                                 1.0,
                                 -1.0,
                                 0.5,
                                 -0.5,
                                 2.0,
                                 -2.0,
                                 1e-310,
                                 -1e-310,
                                 1e-16,
                                 1e15,
                                 -1e15,
                                 1e308,
                                 1e22,
                                 0.1,
                                 kInfinity,
                                 -kInfinity,
                                 std::nan(""),
                                 3.14159265358979,
                                 1.5707963267949,
                                 709.7,
                                 -745.0};
  for (int i = -20; i <= 20; ++i) numbers.push_back(0.37 * i + 0.011);
  return numbers;
}

struct Pairs {
  std::vector<double> a, b;
};

Pairs all_pairs() {
  Pairs pairs;
  for (const double a : nasty_numbers()) {
    for (const double b : nasty_numbers()) {
      pairs.a.push_back(a);
      pairs.b.push_back(b);
    }
  }
  return pairs;
}

std::vector<double> run(CpuLevel level, Op op, const Pairs& pairs) {
  std::vector<double> out(pairs.a.size());
  const double order = 1;
  const Operand first = takes_an_order(op) ? Operand{&order, false} : Operand{pairs.a.data(), true};
  const std::array<Operand, 3> in = {first, Operand{pairs.b.data(), true},
                                     Operand{pairs.a.data(), true}};
  kernels(level)[op](out.data(), in.data(), out.size());
  return out;
}

bool same(double x, double y) {
  return std::memcmp(&x, &y, sizeof x) == 0 || (std::isnan(x) && std::isnan(y));
}

TEST(Kernels, GiveTheSameBitsOnEveryCpuLevel) {
  const Pairs pairs = all_pairs();
  for (const Operation& row : kOperations) {
    const Op op = row.op;
    const std::vector<double> lowest = run(CpuLevel::Sse2, op, pairs);
    for (std::size_t level = 1; level < supported_level_count(); ++level) {
      const std::vector<double> other = run(static_cast<CpuLevel>(level), op, pairs);
      for (std::size_t i = 0; i < lowest.size(); ++i) {
        ASSERT_TRUE(same(lowest[i], other[i]))
            << level_name(static_cast<CpuLevel>(level)) << " op " << static_cast<int>(op) << " of "
            << pairs.a[i] << ", " << pairs.b[i] << ": " << lowest[i] << " " << other[i];
      }
    }
  }
}

/// Both are within an ULP of the truth, so within two of each other; near poles and zeros of gamma,
/// and where the result is denormal, SLEEF promises less.
bool nearly_same(double x, double y) {
  if (same(x, y) || x == y) return true;
  constexpr double kUlps = 4 * std::numeric_limits<double>::epsilon();
  return std::fabs(x - y) <= kUlps * std::fmax(std::fabs(x), std::fabs(y)) + 1e-300;
}

TEST(Kernels, AgreeWithThePlainFunction) {
  const Pairs pairs = all_pairs();
  for (const Operation& row : kOperations) {
    const Op op = row.op;
    if (takes_an_order(op) || op == Op::Gamma || op == Op::Lgamma) continue;
    const std::vector<double> values = run(CpuLevel::Sse2, op, pairs);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_TRUE(nearly_same(values[i], apply(op, pairs.a[i], pairs.b[i], pairs.a[i])))
          << "op " << static_cast<int>(op) << " of " << pairs.a[i] << ", " << pairs.b[i] << ": "
          << values[i] << " is not " << apply(op, pairs.a[i], pairs.b[i], pairs.a[i]);
    }
  }
}

TEST(Kernels, GiveSineAndCosineTogetherAsOneByOne) {
  const std::vector<double> numbers = nasty_numbers();
  std::vector<double> lowest_sin;
  std::vector<double> lowest_cos;
  for (std::size_t level = 0; level < supported_level_count(); ++level) {
    const Kernels& loops = kernels(static_cast<CpuLevel>(level));
    for (std::size_t count = 1; count <= numbers.size(); ++count) {
      std::vector<double> sin(count + 1, -5);
      std::vector<double> cos(count + 1, -5);
      loops.sin_cos(sin.data(), cos.data(), numbers.data(), count);
      EXPECT_EQ(sin[count], -5) << "wrote past the end";
      EXPECT_EQ(cos[count], -5) << "wrote past the end";
      const double x = numbers[count - 1];
      EXPECT_TRUE(nearly_same(sin[count - 1], std::sin(x))) << x;
      EXPECT_TRUE(nearly_same(cos[count - 1], std::cos(x))) << x;
      if (level == 0) {
        lowest_sin.push_back(sin[count - 1]);
        lowest_cos.push_back(cos[count - 1]);
      } else {
        EXPECT_TRUE(same(sin[count - 1], lowest_sin[count - 1])) << x;
        EXPECT_TRUE(same(cos[count - 1], lowest_cos[count - 1])) << x;
      }
    }
  }
}

TEST(Kernels, TakeBroadcastOperandsAndTails) {
  const double two = 2;
  const std::vector<double> a = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  for (std::size_t level = 0; level < supported_level_count(); ++level) {
    const Kernel power = kernels(static_cast<CpuLevel>(level))[Op::Pow];
    for (std::size_t count = 1; count <= a.size(); ++count) {
      std::vector<double> out(count + 1, -1.0);
      const std::array<Operand, 3> squares = {Operand{a.data(), true}, Operand{&two, false}, {}};
      power(out.data(), squares.data(), count);
      EXPECT_EQ(out[count - 1], a[count - 1] * a[count - 1]);
      EXPECT_EQ(out[count], -1.0) << "wrote past the end";
      const std::array<Operand, 3> exponents = {Operand{&two, false}, Operand{a.data(), true}, {}};
      power(out.data(), exponents.data(), count);
      EXPECT_EQ(out[count - 1], std::ldexp(1.0, static_cast<int>(count)));
    }
  }
}

}  // namespace
}  // namespace saddle
