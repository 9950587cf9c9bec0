#include "formula/js.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "graph_value.h"

namespace saddle {
namespace {

JsCode code_of(const std::string& formula) {
  Graph graph;
  const std::array roots = {testing::parse(graph, formula)};
  return print_js(graph, roots, [](Symbol) { return "p"; });
}

TEST(Js, ComputesOnceWhatDependsOnNeitherUNorV) {
  Graph graph;
  const NodeId sine = graph.make(Op::Sin, graph.variable(kSymbolT));
  const std::array roots = {graph.make(Op::Mul, sine, graph.variable(kSymbolU))};
  const JsCode code = print_js(graph, roots, [](Symbol) { return "t"; });
  EXPECT_NE(code.once.find("Math.sin(t)"), std::string::npos) << code.once;
  EXPECT_EQ(code.each.find("Math.sin"), std::string::npos) << code.each;
  EXPECT_EQ(code.outputs.size(), 1U);
  EXPECT_NE(code.each.find(code.outputs[0] + "="), std::string::npos) << code.each;
}

TEST(Js, HasNoStatementsForAVariableOrANumber) {
  EXPECT_EQ(code_of("v").outputs[0], "v");
  EXPECT_EQ(code_of("0.1").outputs[0], "0.1");
  EXPECT_EQ(code_of("v").once + code_of("v").each, "");
}

TEST(Js, HasATextForEveryOperation) {
#define SADDLE_OP(id, ...) EXPECT_FALSE(js_text(Op::id).empty()) << #id;
#include "formula/ops.def"
}

TEST(Js, WritesNumbersThatReadBackTheSame) {
  using Limits = std::numeric_limits<double>;
  EXPECT_EQ(js_number(0.1), "0.1");
  EXPECT_EQ(js_number(-2), "(-2)");  // behind a minus sign it would be a decrement
  EXPECT_EQ(js_number(Limits::quiet_NaN()), "NaN");
  EXPECT_EQ(js_number(-Limits::infinity()), "(-1/0)");
  for (const double value : {1.0 / 3, Limits::max(), Limits::denorm_min(), 0.1 + 0.2}) {
    EXPECT_EQ(std::strtod(js_number(value).c_str(), nullptr), value);
  }
}

TEST(Js, IsEmptyWithoutOutputs) {
  const JsCode code = print_js(Graph{}, {}, [](Symbol) { return std::string(); });
  EXPECT_TRUE(code.outputs.empty());
  EXPECT_EQ(code.once + code.each, "");
}

}  // namespace
}  // namespace saddle
