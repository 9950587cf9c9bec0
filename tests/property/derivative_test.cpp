// Derivatives as graphs, valued with 50 digits, against differences with 50 digits. The only
// roundoff is that of constants, which are folded as doubles: a rule is right or wrong.
#include <gtest/gtest.h>

#include <array>

#include "formula/derive.h"
#include "formula/language.h"
#include "graph_value.h"
#include "random_formula.h"
#include "study/high_precision.h"

namespace saddle {
namespace {

// Central differences with step h are off by h^2/6 of the third derivative, 1e-36, plus 1e-50/h:
// nothing. A folded constant such as ln(pi) is off by 1e-16 of itself; a rule multiplies a few.
const Real kStep("1e-18");
const Real kTolerance("1e-14");

bool is_finite(const Real& x) {
  return boost::multiprecision::isfinite(x);
}

/// Compares d/du of `root` with a difference; false where either is undefined or near a jump.
bool derivative_agrees(Graph& graph, NodeId root, double u, double v, const std::string& what) {
  const NodeId slope = derive(graph, std::array{root}, kSymbolU)[0];
  const Real above = exact_value(graph, root, Real(u) + kStep, v);
  const Real below = exact_value(graph, root, Real(u) - kStep, v);
  const Real difference = (above - below) / (2 * kStep);
  const Real derivative = exact_value(graph, slope, u, v);
  if (!is_finite(difference) || !is_finite(derivative)) return false;
  const Real scale = 1 + abs(above) + abs(derivative) + abs(difference);
  EXPECT_LT(abs(derivative - difference) / scale, kTolerance)
      << what << " at u=" << u << ", v=" << v << ": " << derivative << " is not " << difference;
  return true;
}

/// A real formula with a call of a function of complex numbers or vectors.
std::string typed_call(const BuiltIn& function) {
  std::string text;
  for (const char letter : function.signature) {
    const bool is_first = text.empty();
    text += is_first ? "" : ",";
    text += letter == 'z'               ? "u*v+i*(u-v)"
            : letter == 's'             ? "u"
            : letter == 'r'             ? (is_first ? "u" : "u*v")
            : is_first || letter == 's' ? "(u,u^2+v,u^3)"
                                        : "(v+1.3,2,u)";
  }
  text = std::string(function.name) + "(" + text + ")";
  const bool is_real = function.name == "re" || function.name == "im" || function.name == "arg" ||
                       function.name == "dot" || function.name == "norm";
  if (is_real) return text;
  if (function.name == "conj") return "im(" + text + ")";
  return text + (function.name == "frame" ? ".n.y" : ".y");
}

TEST(Derivative, AgreesWithDifferencesForFunctionsOfComplexNumbersAndVectors) {
  for (const std::string& name : function_names()) {
    const BuiltIn& function = *find_built_in(name);
    if (function.of_typed == nullptr) continue;
    const std::string text = typed_call(function);
    Graph graph;
    const NodeId root = testing::parse(graph, text);
    int compared = 0;
    for (const double u : {-2.3, -0.71, 0.33, 1.61}) {
      compared += derivative_agrees(graph, root, u, 0.37, text) ? 1 : 0;
    }
    EXPECT_EQ(compared, 4) << text;
  }
}

TEST(Derivative, AgreesWithDifferencesForEveryFunctionOfTheLanguage) {
  for (const std::string& name : function_names()) {
    if (name == "diff" || find_built_in(name)->of_typed != nullptr) continue;
    const int arity = find_built_in(name)->min_arguments;
    for (int slot = 0; slot < arity; ++slot) {
      std::string text = name + "(";
      for (int i = 0; i < arity; ++i) {
        text += std::string(i > 0 ? "," : "") + (i == slot ? "u" : i == 0 ? "v" : "(v+1.3)");
      }
      text += ")";
      Graph graph;
      const NodeId root = testing::parse(graph, text);
      int compared = 0;
      for (const double u : {-2.3, -0.71, -0.2, 0.33, 0.9, 1.61, 7.4}) {
        for (const double v : {-1.1, 0.37, 2.2}) {
          compared += derivative_agrees(graph, root, u, v, text) ? 1 : 0;
        }
      }
      EXPECT_GE(compared, 3) << text << " was never compared";
    }
  }
}

TEST(Derivative, AgreesWithDifferencesOnRandomFormulas) {
  testing::RandomFormula random(7);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const std::string text = random(1 + i % 4);
    Graph graph;
    const NodeId root = testing::parse(graph, text);
    compared += derivative_agrees(graph, root, random.number(), random.number(), text) ? 1 : 0;
  }
  EXPECT_GT(compared, 200);
}

TEST(Derivative, OfADerivativeIsTheSecondDerivative) {
  for (const char* text : {"sinc(u)", "besselj0(u)", "gamma(u)", "erf(u)*v", "u^v", "atan2(u,v)"}) {
    Graph graph;
    const NodeId root = testing::parse(graph, std::string("diff(") + text + ",u)");
    EXPECT_TRUE(derivative_agrees(graph, root, 1.37, 0.6, text));
  }
}

TEST(Derivative, IsOneSidedAtKinks) {
  EXPECT_EQ(testing::value("diff(abs(u),u)", 0), 1);
  EXPECT_EQ(testing::value("diff(min(u,2*u),u)", 0), 1);
  EXPECT_EQ(testing::value("diff(max(u,2*u),u)", 0), 1);
  EXPECT_EQ(testing::value("diff(floor(u),u)", 1), 0);
  EXPECT_EQ(testing::value("diff(u>1,u)", 1), 0);
}

TEST(Derivative, OfAPowerIsRightAtZero) {
  EXPECT_EQ(testing::value("diff(u^2,u)", 0), 0);
  EXPECT_EQ(testing::value("diff(u^1,u)", 0), 1);
  EXPECT_EQ(testing::value("diff(u^3,u)", -2), 12);
  EXPECT_EQ(testing::value("diff(u^v,v)", 0, 2), 0);  // the limit of u^2 ln u
  EXPECT_EQ(testing::value("diff(u^0.5,u)", 0), std::numeric_limits<double>::infinity());
}

TEST(Derivative, OfTheBranchThatIsNotTakenDoesNotMatter) {
  EXPECT_EQ(testing::value("diff(u>0 ? sqrt(u) : 0, u)", -1), 0);
  EXPECT_EQ(testing::value("diff(if(u<0, u^2, ln(u)), u)", -3), -6);
}

TEST(Derivative, OfAConstantBranchIsZeroWhateverIsTakenOfIt) {
  for (const char* of : {"sqrt(max(0,u))", "cbrt(max(0,u))", "max(0,u)^0.3", "-asin(-max(-1,u))",
                         "acos(min(1,-u))", "abs(min(1,max(0,u)))^0.5", "sqrt(if(u<0,0,u))",
                         "sqrt(cbrt(max(0,u)))", "sqrt(if(u>0,u,if(u<-1,0,0)))"}) {
    EXPECT_EQ(testing::value("diff(" + std::string(of) + ",u)", -1.5), 0) << of;
    EXPECT_EQ(testing::value("diff(diff(" + std::string(of) + ",u),u)", -1.5), 0) << of;
  }
  // A derivative that happens to be 0 at a place says nothing about what is taken of it.
  EXPECT_TRUE(std::isnan(testing::value("diff(sqrt(u^2),u)", 0)));
  EXPECT_DOUBLE_EQ(testing::value("diff(sqrt(max(0,u)),u)", 0.25), 1);
}

TEST(Derivative, OfWhatIsBoundedIsZeroWhereItsPartsAreBeyondDoubles) {
  for (const char* of : {"1/(1+exp(1000*u))", "atan(exp(1000*u))", "tanh(exp(1000*u))",
                         "erf(exp(1000*u))", "sqrt(1/(1+exp(1000*u)))", "1/(1+9^(1000*u))"}) {
    EXPECT_EQ(testing::value("diff(" + std::string(of) + ",u)", 1), 0) << of;
    EXPECT_EQ(testing::value("diff(diff(" + std::string(of) + ",u),u)", 1), 0) << of;
  }
  EXPECT_DOUBLE_EQ(testing::value("diff(1/(1+exp(u)),u)", 0), -0.25);
  for (const char* of : {"tanh(u/v)", "erf(u/v)", "sqrt(1-tanh(u/v))"}) {
    EXPECT_EQ(testing::value("diff(" + std::string(of) + ",v)", 1, 0), 0) << of;
  }
  // A pole is no end of doubles: v*exp(-u) has a slope where v = 0, which is no number here.
  for (const char* of : {"1/(exp(u)/v)", "atan(exp(u)/v)", "1/(exp(u)+ln(v))"}) {
    EXPECT_FALSE(testing::value("diff(" + std::string(of) + ",v)", 1, 0) == 0) << of;
  }
}

TEST(Derivative, WithRespectToAnArgumentIsTakenBeforeTheCall) {
  Graph graph;
  const Definition f = {"f", "diff(sin(s),s)", {"s"}, true};
  const NodeId root = testing::parse(graph, "f(2u)", {f});
  EXPECT_EQ(testing::value(graph, root, 0.3, 0), std::cos(0.6));
}

TEST(Derivative, WithRespectToAParameterKeepsTheParametersValue) {
  Graph graph;
  const NodeId root = testing::parse(graph, "diff(a^2*u,a)", {{"a", "3"}});
  EXPECT_EQ(testing::value(graph, root, 5, 0), 30);
}

}  // namespace
}  // namespace saddle
