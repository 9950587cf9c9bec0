// Largest errors per row, shown when the environment variable SADDLE_SHOW_ERRORS is set:
//   SADDLE_SHOW_ERRORS=1 build/release/test_conformance
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "conformance/arguments.h"

namespace saddle::testing {

struct Worst {
  double error = 0;
  Arguments at;
  double computed = 0;

  void take(double new_error, const Arguments& where, double value) {
    if (new_error > error) *this = {new_error, where, value};
  }
};

inline void show(const char* evaluator, const std::string& row, double bound, const Worst& worst) {
  if (std::getenv("SADDLE_SHOW_ERRORS") == nullptr) return;
  std::printf("%-10s %-12s %10.4g of %-8g at %.17g, %.17g: %.17g\n", evaluator, row.c_str(),
              worst.error, bound, worst.at.a, worst.at.b, worst.computed);
}

}  // namespace saddle::testing
