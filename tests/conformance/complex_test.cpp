// Complex functions against their definitions with 100 digits: over the plane, on both sides of
// each branch cut, and on the cuts by the signs of zeros.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "conformance/complex_accuracy.h"
#include "formula/derive.h"
#include "graph_value.h"

namespace saddle::testing {
namespace {

TEST(ComplexFunctions, AgreeWithTheirDefinitionsOnBothSidesOfCuts) {
  constexpr int kPoints = 500;
  for (const ComplexFunction& function : complex_functions()) {
    const ComplexAccuracy accuracy = measure_accuracy(function, kPoints);
    for (const ComplexError& worst : {accuracy.plane, accuracy.axes, accuracy.beside}) {
      EXPECT_LE(worst.ulps, function.ulps)
          << function.formula << " at " << worst.at[0] << " + " << worst.at[1] << "i";
    }
  }
}

TEST(ComplexFunctions, HaveExactDerivatives) {
  for (const ComplexFunction& function : complex_functions()) {
    if (function.formula.starts_with("a") || function.formula.starts_with("conj")) {
      if (function.formula.find('+') != std::string::npos || function.ulps == 0) continue;
    }
    Graph graph;
    const std::vector<Definition> w = {{"w", "u+i*v"}};
    const NodeId re = parse(graph, "re(diff(" + function.formula + ",u))", w);
    const NodeId im = parse(graph, "im(diff(" + function.formula + ",u))", w);
    for (const auto& at : {std::array{0.3, 0.7}, std::array{-1.6, 0.4}, std::array{-0.8, -2.1},
                           std::array{2.5, -0.2}, std::array{0.5, 1e-9}}) {
      // With 100 digits a difference has more than a double's.
      const Wide step("1e-40");
      const WideComplex above = function.exact({Wide(at[0]) + step, Wide(at[1])});
      const WideComplex below = function.exact({Wide(at[0]) - step, Wide(at[1])});
      const auto exact_re = static_cast<double>((above.re - below.re) / (2 * step));
      const auto exact_im = static_cast<double>((above.im - below.im) / (2 * step));
      const double size = std::hypot(exact_re, exact_im);
      constexpr double kRelative = 1e-13;  // some hundred operations
      EXPECT_NEAR(value(graph, re, at[0], at[1]), exact_re, kRelative * size)
          << function.formula << " at " << at[0] << " + " << at[1] << "i";
      EXPECT_NEAR(value(graph, im, at[0], at[1]), exact_im, kRelative * size)
          << function.formula << " at " << at[0] << " + " << at[1] << "i";
    }
  }
}

TEST(ComplexFunctions, OfRealNumbersStayReal) {
  for (const char* formula : {"sqrt(u)", "ln(u)", "asin(u)", "u^0.5", "acosh(u)"}) {
    EXPECT_TRUE(std::isnan(value(formula, -2))) << formula;
  }
}

}  // namespace
}  // namespace saddle::testing
