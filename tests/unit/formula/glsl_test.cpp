#include "formula/glsl.h"

#include <gtest/gtest.h>

#include <array>

#include "graph_value.h"

namespace saddle {
namespace {

/// The code of formulas that are assigned to x and y.
std::optional<std::string> print(const std::string& x, const std::string& y = "0") {
  Graph graph;
  const std::array roots = {testing::parse(graph, x), testing::parse(graph, y)};
  const std::array<std::string_view, 2> names = {"x", "y"};
  return print_glsl(graph, roots, names);
}

TEST(Glsl, IsOneStatementForEachOperation) {
  EXPECT_EQ(print("sin(u)*v").value(),
            "float t2 = sin(u);\nfloat t3 = v * t2;\nx = t3;\ny = 0.0;\n");
}

TEST(Glsl, ComputesOnceWhatTheOutputsShare) {
  const std::string code = print("exp(u)+1", "exp(u)*v").value();
  EXPECT_EQ(code.find("exp("), code.rfind("exp("));
}

TEST(Glsl, HasNothingThatNoOutputNeeds) {
  EXPECT_EQ(print("u*if(1,2,sin(v))").value().find("sin"), std::string::npos);
}

TEST(Glsl, LowersPowersAsTheTapeDoes) {
  const std::string code = print("u^3", "v^0.5").value();
  EXPECT_EQ(code.find("power"), std::string::npos);
  EXPECT_NE(code.find("safe_sqrt(v)"), std::string::npos);
  EXPECT_NE(print("u^v").value().find("power(u, v)"), std::string::npos);
}

TEST(Glsl, ReplacesWholeWordsOnly) {
  // The column of abs is "abs(a)", that of atan2 "safe_atan2(a, b)".
  EXPECT_NE(print("abs(v)").value().find("= abs(v)"), std::string::npos);
  EXPECT_NE(print("atan2(v,u)").value().find("safe_atan2(v, u)"), std::string::npos);
}

TEST(Glsl, PrintsConstantsAsFloats) {
  EXPECT_EQ(print("2").value(), "x = 2.0;\ny = 0.0;\n");
  EXPECT_EQ(print("1/3").value(), "x = 0.333333343;\ny = 0.0;\n");
  EXPECT_EQ(print("-1e30").value(), "x = (-1.00000002e+30);\ny = 0.0;\n");
  EXPECT_EQ(print("1e300", "-1e300").value(),
            "x = uintBitsToFloat(0x7f800000u);\ny = uintBitsToFloat(0xff800000u);\n");
  EXPECT_EQ(print("nan").value(), "x = uintBitsToFloat(0x7fc00000u);\ny = 0.0;\n");
}

TEST(Glsl, SaysWhichOperationHasNone) {
  EXPECT_FALSE(print("besselj0(u)+sin(u)"));
  Graph graph;
  const NodeId root = testing::parse(graph, "besselj0(u)+sin(u)");
  EXPECT_EQ(operation_without_glsl(graph, std::array{root}), Op::BesselJ);
  const NodeId other = testing::parse(graph, "sin(u)");
  EXPECT_EQ(operation_without_glsl(graph, std::array{other}), std::nullopt);
}

}  // namespace
}  // namespace saddle
