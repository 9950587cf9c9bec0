// Every operation that has GLSL, printed, run by the driver over its arguments and read back as
// floats, against 50 digits at those floats.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "conformance/float_grid.h"
#include "conformance/reference.h"
#include "conformance/report.h"
#include "formula/glsl.h"

namespace saddle::testing {
namespace {

/// The third argument of a choice: the shader has two variables.
constexpr double kThirdArgument = 0.75;

constexpr double kSmallestFloat = std::numeric_limits<float>::min();
constexpr double kLargestFloat = std::numeric_limits<float>::max();

/// Sines of larger floats are left to the driver: a float's last place is 2^-17 there.
constexpr double kTrigonometryRange = 100;

/// GLSL 4.60, 4.7.1, and what drivers are held to: log is 2^-21 off in [1/2, 2] at most.
constexpr double kLogError = 0x1p-21;

/// What a float version may be off: units in the last place of the result, or an absolute error
/// where the result is small.
struct FloatBound {
  double ulps = 4;  ///< polynomials, quotients and roots, a few roundings each
  double absolute = 0;
};

FloatBound bound_of(Op op, const Arguments& at, double exact) {
  const double a = std::fabs(at.a);
  switch (op) {
    case Op::Exp:
    case Op::Sinh:
    case Op::Cosh:
      return {3 + 2 * a, 0};  // GLSL 4.60, 4.7.1, on exp
    case Op::Log:
    case Op::Log2:
    case Op::Log10:
      return {4, kLogError};
    case Op::Pow:  // exp2(b log2(a))
      if (!std::isfinite(at.b * std::log2(a))) return {};
      return {3 + 2 * std::fabs(at.b * std::log2(a)) + std::fabs(at.b) * kLogError * 0x1p24, 0};
    case Op::Sin:
    case Op::Cos:
      return {4, 0x1p-22};
    case Op::Tan:
      return {4, 0x1p-22 * (1 + exact * exact)};
    case Op::Gamma:  // exp(log_gamma)
      return {16 + 4 * std::fabs(std::lgamma(at.a)), 0};
    case Op::Lgamma:  // terms of the size of a ln(a) + 1 cancel
      return {4, 0x1p-21 * (1 + a)};
    default:
      return {};
  }
}

double range_of(Op op) {
  const bool trigonometry = op == Op::Sin || op == Op::Cos || op == Op::Tan;
  return trigonometry ? kTrigonometryRange : kLargestFloat;
}

double unit_in_the_last_place(double x) {
  return std::ldexp(1.0, std::max(std::ilogb(x), -126) - 23);
}

/// Whether the argument as a float is one that GLSL promises to keep: not denormal.
bool is_kept(double x, double range) {
  if (x == 0 || !std::isfinite(x)) return true;
  return std::fabs(x) >= kSmallestFloat && std::fabs(x) <= range;
}

std::vector<Arguments> float_arguments(const Operation& row) {
  std::vector<Arguments> arguments;
  const double range = range_of(row.op);
  for (const Arguments& at : arguments_of(row)) {
    if (!is_kept(at.a, range) || !is_kept(at.b, range)) continue;
    // The sign of a zero is not kept: adding 0 takes it away.
    arguments.push_back(
        {static_cast<float>(at.a) + 0.0, static_cast<float>(at.b) + 0.0, kThirdArgument});
  }
  return arguments;
}

/// The error as a multiple of what is allowed.
double relative_error(Op op, const Arguments& at, double computed) {
  const double exact = static_cast<double>(reference(op, at));
  if (std::isnan(exact) || std::isnan(computed)) {
    return std::isnan(exact) && std::isnan(computed) ? 0 : std::numeric_limits<double>::infinity();
  }
  if (std::fabs(exact) > kLargestFloat) {
    return computed == std::copysign(std::numeric_limits<double>::infinity(), exact)
               ? 0
               : std::numeric_limits<double>::infinity();
  }
  double error = std::fabs(computed - exact);
  double scale = std::fabs(exact);
  if (op == Op::Mod) {
    scale = std::fmax(scale, std::fabs(at.a));
    error = std::fmin(error, std::fabs(error - std::fabs(at.b)));
  }
  const FloatBound bound = bound_of(op, at, exact);
  // A denormal result may be flushed to zero.
  const double allowed = bound.ulps * unit_in_the_last_place(scale) + bound.absolute;
  return error / (std::fabs(exact) < kSmallestFloat ? std::fmax(allowed, kSmallestFloat) : allowed);
}

void compare(const Operation& row) {
  Graph graph;
  const NodeId root = graph.make(row.op, graph.variable(kSymbolU), graph.variable(kSymbolV),
                                 graph.constant(kThirdArgument));
  const std::array<std::string_view, 1> names = {"x"};
  const std::string code = print_glsl(graph, std::array{root}, names).value();
  const std::vector<Arguments> arguments = float_arguments(row);
  const std::vector<std::array<float, 3>> results = run_glsl(code, arguments);
  Worst worst;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Arguments& at = arguments[i];
    const double computed = static_cast<double>(results[i][0]);
    const double error = relative_error(row.op, at, computed);
    worst.take(error, at, computed);
    EXPECT_LE(error, 1) << row.id << " of " << at.a << ", " << at.b << ": " << computed
                        << " is not " << reference(row.op, at) << "\n"
                        << code;
  }
  show("glsl", row.id, 1, worst);
}

TEST(Conformance, EveryOperationWithGlslIsExactToFloats) {
  const std::unique_ptr<Context> context = make_osmesa_context();
  for (const Operation& row : kOperations) {
    if (!glsl_text(row.op).empty()) compare(row);
  }
}

TEST(Conformance, ConstantsReachTheShaderAsTheNearestFloats) {
  const std::unique_ptr<Context> context = make_osmesa_context();
  for (const double value : few_nasty_numbers()) {
    const float nearest = std::fabs(value) > kLargestFloat
                              ? std::copysign(std::numeric_limits<float>::infinity(), value)
                              : static_cast<float>(value);
    if (nearest != 0 && std::fabs(nearest) < kSmallestFloat) continue;
    Graph graph;
    const std::array<std::string_view, 1> names = {"x"};
    const NodeId root = graph.constant(value);
    const float read = run_glsl(print_glsl(graph, std::array{root}, names).value(), {{}})[0][0];
    EXPECT_TRUE(read == nearest || (std::isnan(read) && std::isnan(nearest)))
        << value << " became " << read;
  }
}

}  // namespace
}  // namespace saddle::testing
