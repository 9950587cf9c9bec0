// Formulas mean what muparser says they mean: thousands of random ones, valued by both.
#include <gtest/gtest.h>
#include <muParser.h>

#include <cmath>
#include <limits>

#include "graph_value.h"
#include "random_formula.h"

namespace saddle {
namespace {

using testing::RandomFormula;

constexpr int kFormulas = 4000;
constexpr int kPointsEach = 5;

class Oracle {
 public:
  explicit Oracle(const std::string& text) {
    parser_.DefineVar("u", &u_);
    parser_.DefineVar("v", &v_);
    parser_.DefineConst("pi", 3.141592653589793238462643);
    parser_.DefineConst("e", 2.718281828459045235360287);
    parser_.EnableOptimizer(false);
    parser_.SetExpr(text);
  }
  double operator()(double u, double v) {
    u_ = u;
    v_ = v;
    return parser_.Eval();
  }

 private:
  mu::Parser parser_;
  double u_ = 0;
  double v_ = 0;
};

/// sign, min and max of NaN are NaN here; in muparser sign(NaN) is 0, and min and max of NaN depend
/// on the order of the arguments.
bool differs_by_intent(const Graph& graph, const std::vector<double>& values) {
  for (NodeId id = 0; id < values.size(); ++id) {
    const Node& node = graph[id];
    if (node.op == Op::Constant && std::isnan(node.value)) return true;  // folded
    if (node.op != Op::Min && node.op != Op::Max && node.op != Op::Sign) continue;
    if (std::isnan(values[node.args[0]])) return true;
    if (node.op != Op::Sign && std::isnan(values[node.args[1]])) return true;
  }
  return false;
}

TEST(MuparserOracle, AgreesToTheBitOnRandomFormulas) {
  RandomFormula random(20260101);
  int compared = 0;
  int finite = 0;
  for (int i = 0; i < kFormulas; ++i) {
    const std::string text = random(1 + i % 5);
    SCOPED_TRACE(text);
    Oracle oracle(text);
    Graph graph;
    const NodeId root = testing::parse(graph, text);
    for (int k = 0; k < kPointsEach; ++k) {
      const double u = random.number();
      const double v = random.number();
      const std::vector<double> ours = testing::values(graph, root, u, v);
      if (differs_by_intent(graph, ours)) continue;
      const double theirs = oracle(u, v);
      const bool equal = ours[root] == theirs || (std::isnan(ours[root]) && std::isnan(theirs));
      EXPECT_TRUE(equal) << ours[root] << " is not " << theirs << " at " << u << ", " << v;
      ++compared;
      finite += std::isfinite(theirs) ? 1 : 0;
    }
  }
  // The comparison must not have gone empty: most points count, half of the values are numbers.
  EXPECT_GT(compared, kFormulas * kPointsEach * 8 / 10);
  EXPECT_GT(finite, compared / 2);
}

TEST(MuparserOracle, AgreesWithinRoundingWhereMuparserUsesLogarithms) {
  // muparser computes ln(x + sqrt(x^2 +- 1)) and ln(x) / ln(2): some roundings of numbers near 1.
  constexpr double kRoundings = 8 * std::numeric_limits<double>::epsilon();
  for (const char* text : {"asinh(u)", "acosh(u)", "atanh(u/9)", "log2(u)"}) {
    for (const double u : {1.25, 2.0, 3.7, 8.9}) {
      EXPECT_NEAR(testing::value(text, u), Oracle(text)(u, 0), kRoundings) << text << u;
    }
  }
}

TEST(MuparserOracle, AgreesOnPrecedence) {
  for (const char* text : {"-2^2", "2^3^2", "2^-2", "0^0", "1-2-3", "2/3/4", "1<2==1", "1||0&&0",
                           "1?2:3?4:5", "-u^2", "2+3*4^2", "1+2<3*4", "u>0?-1:+1", "2*-3",
                           "rint(2.5)", "rint(-2.5)", "(-8)^(1/3)", "avg(1,2,4)", "sum(u,v,3)"}) {
    SCOPED_TRACE(text);
    const double theirs = Oracle(text)(1.25, -0.5);
    const double ours = testing::value(text, 1.25, -0.5);
    EXPECT_TRUE(ours == theirs || (std::isnan(ours) && std::isnan(theirs))) << ours << theirs;
  }
}

}  // namespace
}  // namespace saddle
