#include "formula/special.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/polygamma.hpp>
#include <cmath>

#include "study/high_precision.h"

namespace saddle {
namespace {

/// Largest relative error of our recurrences and series: tens of roundings.
constexpr double kRoundings = 64 * std::numeric_limits<double>::epsilon();

TEST(Polygamma, AgreesWithFiftyDigits) {
  for (int n = 0; n <= 4; ++n) {
    for (const double x :
         {0.01, 0.3, 1.0, 1.4616, 2.5, 7.0, 19.9, 20.5, 33.0, 1e5, -0.25, -3.7, -12.1}) {
      const Real exact = boost::math::polygamma(n, Real(x));
      // Near a zero (1.4616 for digamma) and in the reflection terms cancel: relative to 1 there.
      const double scale = 1 + std::fabs(static_cast<double>(exact));
      EXPECT_NEAR(polygamma(n, x), static_cast<double>(exact), kRoundings * scale) << n << " " << x;
    }
  }
}

TEST(ExactPolygamma, AgreesWithBoostsWhereThatIsRight) {
  for (int n = 0; n <= 6; ++n) {
    for (const double x : {1e-6, 0.25, 1.0, 1.4616, 7.0, 59.5, 60.5, 1e4, -0.25, -3.7}) {
      const Real boosts = boost::math::polygamma(n, Real(x));
      const Real scale = 1 + abs(boosts);
      EXPECT_LT(abs(exact_polygamma(n, Real(x)) - boosts) / scale, Real("1e-45")) << n << " " << x;
    }
  }
}

TEST(Polygamma, IsUndefinedAtItsPoles) {
  EXPECT_TRUE(std::isnan(polygamma(0, 0)));
  EXPECT_TRUE(std::isnan(polygamma(1, -3)));
}

TEST(Polygamma, IsRelativelyExactOnEitherSideOfAPole) {
  for (int n = 0; n <= 3; ++n) {
    for (const double x : {-1e-5, -1 + 0x1p-20, -1 - 0x1p-20, -7 + 0x1p-30, -7 - 0x1p-30}) {
      const double exact = static_cast<double>(exact_polygamma(n, x));
      EXPECT_NEAR(polygamma(n, x) / exact, 1, kRoundings) << n << " " << x;
    }
  }
}

TEST(SincDerivative, AgreesWithFiftyDigits) {
  for (int n = 0; n <= 5; ++n) {
    for (const double x : {0.0, 1e-9, 0.2, -0.9, 1.0, 2.5, -4.9, 5.1, 9.7, 17.0}) {
      const double exact = static_cast<double>(sinc_series(n, x));
      EXPECT_NEAR(sinc_derivative(n, x), exact, kRoundings) << n << " " << x;
    }
  }
}

TEST(LogGamma, IsTheLogarithmOfTheAbsoluteValue) {
  EXPECT_NEAR(log_gamma(-0.5), std::log(std::fabs(std::tgamma(-0.5))), kRoundings);
}

}  // namespace
}  // namespace saddle
