#include "conformance/arguments.h"

#include <cmath>
#include <limits>
#include <random>

namespace saddle::testing {
namespace {

constexpr double kPi = 3.141592653589793238462643;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();
constexpr double kSmallest = std::numeric_limits<double>::min();
constexpr double kLargest = std::numeric_limits<double>::max();

constexpr int kHighestOrder = 4;
constexpr int kRandomNumbers = 200;
/// Choices do not compute: three arguments of this many kinds each will do.
constexpr std::size_t kTriples = 9;

/// The number, its neighbours, and the same below zero.
void add_with_neighbours(std::vector<double>& numbers, double x) {
  for (const double y : {std::nextafter(x, 0.0), x, std::nextafter(x, kInfinity)}) {
    numbers.push_back(y);
    numbers.push_back(-y);
  }
}

}  // namespace

std::vector<double> nasty_numbers() {
  std::vector<double> numbers = {0.0, -0.0, kInfinity, -kInfinity, kNan};
  for (const double x :
       {kDenormal,   1e-310, kSmallest, 1e-300, 1e-16, 1e-8,   1e-3,   0.1,  0.5,  1.0,  2.0,
        2.718281828, 10.0,   20.0,      36.0,   100.0, 0x1p52, 0x1p53, 1e15, 1e22, 1e300}) {
    add_with_neighbours(numbers, x);
  }
  // Fractions and multiples of pi, where sines and cosines vanish but for the rounding of pi.
  for (const double turns : {1.0 / 6, 0.25, 1.0 / 3, 0.5, 0.75, 1.0, 1.5, 2.0, 10.0, 100.5, 1e5}) {
    add_with_neighbours(numbers, turns * kPi);
  }
  // Halves, where roundings go one way or the other.
  for (const double x : {1.5, 2.5, 3.5, 7.5, 1e5 + 0.5, 0x1p51 + 0.5, 0x1p52 - 0.5}) {
    add_with_neighbours(numbers, x);
  }
  // Where exponentials, gamma and their like leave the doubles or become denormal, and zeros.
  for (const double x :
       {708.3964185322641, 709.782712893384, 710.4758600739439, 745.1332191019411, 1023.999,
        171.61447887182297, 170.62, 2.404825557695773, 1.4616321449683623, 3.831705970207512,
        0.84375, 1.34e154, 2.5563481638716906e305}) {
    add_with_neighbours(numbers, x);
  }
  numbers.push_back(kLargest);
  numbers.push_back(-kLargest);
  std::mt19937_64 random(1);
  for (int i = 0; i < kRandomNumbers; ++i) {
    const double unit = static_cast<double>(random() >> 11U) * 0x1p-53;
    numbers.push_back(20 * unit - 10);
    const double magnitude = std::exp2(80 * (static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5));
    numbers.push_back((random() & 1U) == 0 ? magnitude : -magnitude);
  }
  return numbers;
}

std::vector<double> few_nasty_numbers() {
  std::vector<double> numbers = {0.0,    kInfinity, kDenormal, kSmallest,   1e-300, 1e-16,
                                 0.1,    1.0 / 3,   0.5,       1 - 0x1p-53, 1.0,    1 + 0x1p-52,
                                 2.0,    2.5,       3.0,       kPi,         7.0,    53.0,
                                 700.25, 0x1p53,    1e15,      1e22,        1e300,  kLargest};
  const std::size_t positive = numbers.size();
  for (std::size_t i = 0; i < positive; ++i) numbers.push_back(-numbers[i]);
  numbers.push_back(kNan);
  return numbers;
}

std::vector<Arguments> arguments_of(const Operation& row) {
  std::vector<Arguments> arguments;
  if (row.arity == 1) {
    for (const double a : nasty_numbers()) arguments.push_back({a, 0, 0});
  } else if (takes_an_order(row.op)) {
    for (int order = 0; order <= kHighestOrder; ++order) {
      for (const double b : nasty_numbers()) {
        arguments.push_back({static_cast<double>(order), b, 0});
      }
    }
  } else if (row.arity == 2) {
    for (const double a : few_nasty_numbers()) {
      for (const double b : few_nasty_numbers()) arguments.push_back({a, b, 0});
    }
  } else {
    std::vector<double> few = few_nasty_numbers();
    std::vector<double> fewer = {kNan, -0.0};
    for (std::size_t i = 0; fewer.size() < kTriples; i += 7) fewer.push_back(few[i % few.size()]);
    for (const double a : fewer) {
      for (const double b : fewer) {
        for (const double c : fewer) arguments.push_back({a, b, c});
      }
    }
  }
  return arguments;
}

}  // namespace saddle::testing
