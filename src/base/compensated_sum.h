// Sums of many numbers, with an error that does not grow with their count.
#pragma once

#include <cmath>

namespace saddle {

/// A sum with the rounding of its additions added back.
/// Source: A. Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen",
/// 1974.
class CompensatedSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    const bool sum_is_larger = std::fabs(sum_) >= std::fabs(term);
    lost_ += sum_is_larger ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;
};

}  // namespace saddle
