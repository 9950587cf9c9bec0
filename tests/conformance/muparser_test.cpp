// Every operation that muparser has too, by name and number of arguments, at nasty arguments.
#include <gtest/gtest.h>
#include <muParser.h>

#include <cmath>
#include <optional>
#include <string>

#include "conformance/evaluators.h"
#include "conformance/reference.h"
#include "conformance/report.h"

namespace saddle::testing {
namespace {

/// muparser's functions are the C library's, but for these: ln(x + sqrt(x^2 +- 1)) and
/// ln((1+x)/(1-x))/2 lose the digits of small arguments and overflow early, log2 is ln(x)/ln(2).
bool is_composed(Op op) {
  return op == Op::Asinh || op == Op::Acosh || op == Op::Atanh || op == Op::Log2;
}

/// What is meant to differ: sign, min and max of NaN are NaN here, muparser's are 0 or depend on
/// the order of arguments; muparser's rint is floor(x + 1/2), one off where that sum rounds up.
bool differs_by_intent(Op op, const Arguments& at) {
  const bool nan = std::isnan(at.a) || std::isnan(at.b);
  if (op == Op::Sign || op == Op::Min || op == Op::Max) return nan;
  const double rest = at.a - std::floor(at.a);
  return op == Op::Rint && std::floor(at.a + 0.5) != std::floor(at.a) + (rest >= 0.5 ? 1 : 0);
}

/// The operation as a formula of muparser's variables a, b and c, which it may not know.
std::string formula_of(const Operation& row) {
  if (row.op == Op::Select) return "a!=0 ? b : c";
  if (row.op == Op::Min) return "min(a,b)";
  if (row.op == Op::Max) return "max(a,b)";
  if (row.op == Op::Pow) return "a^b";
  if (row.op == Op::Neg) return "-a";
  const std::string name = row.name;
  if (name.empty()) return "";
  const bool function = std::isalpha(static_cast<unsigned char>(name[0])) != 0;
  if (!function) return "a" + name + "b";
  return name + (row.arity == 1 ? "(a)" : row.arity == 2 ? "(a,b)" : "(a,b,c)");
}

class Oracle {
 public:
  explicit Oracle(const std::string& formula) {
    parser_.DefineVar("a", &at_.a);
    parser_.DefineVar("b", &at_.b);
    parser_.DefineVar("c", &at_.c);
    parser_.EnableOptimizer(false);
    parser_.SetExpr(formula);
  }

  std::optional<double> operator()(const Arguments& at) {
    at_ = at;
    try {
      return parser_.Eval();
    } catch (const mu::ParserError&) {
      return std::nullopt;
    }
  }

 private:
  mu::Parser parser_;
  Arguments at_;
};

/// Distance of the tape's values from muparser's, in the row's unit.
void compare(const Operation& row, Oracle& oracle) {
  // Both are within the row's bound of the truth; muparser calls the same C library as `apply`.
  const double bound = 2 * row.ulps;
  Worst worst;
  const std::vector<Arguments> arguments = arguments_of(row);
  const std::vector<double> ours = loop_values(cpu_level(), row.op, arguments);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Arguments& at = arguments[i];
    const std::optional<double> theirs = oracle(at);
    if (!theirs || differs_by_intent(row.op, at)) continue;
    const double error = error_in_ulps(row.op, at, ours[i], *theirs);
    worst.take(error, at, ours[i]);
    EXPECT_LE(error, bound) << row.id << " of " << at.a << ", " << at.b << ", " << at.c << ": "
                            << ours[i] << " is not " << *theirs;
  }
  show("muparser", row.id, bound, worst);
}

TEST(Conformance, EveryOperationOfMuparserHasItsValue) {
  int compared = 0;
  for (const Operation& row : kOperations) {
    const std::string formula = formula_of(row);
    if (formula.empty() || is_composed(row.op)) continue;
    Oracle oracle(formula);
    if (!oracle({0.5, 0.25, 0.125})) continue;  // a name that muparser does not know
    compare(row, oracle);
    ++compared;
  }
  EXPECT_GE(compared, 30) << "muparser has 13 operators, a choice, and two dozen functions";
}

}  // namespace
}  // namespace saddle::testing
