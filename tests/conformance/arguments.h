// Arguments at which evaluators go wrong: ends of domains and of the doubles, poles, zeros, halves.
#pragma once

#include <vector>

#include "formula/operations.h"

namespace saddle::testing {

struct Arguments {
  double a = 0;
  double b = 0;
  double c = 0;
};

/// For operations of one argument: all nasty numbers, and seeded random ones of every magnitude.
std::vector<double> nasty_numbers();

/// Nasty numbers, fewer, of which all pairs are tried.
std::vector<double> few_nasty_numbers();

/// What a row is tried with.
std::vector<Arguments> arguments_of(const Operation& row);

}  // namespace saddle::testing
