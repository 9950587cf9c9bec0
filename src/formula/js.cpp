#include "formula/js.h"

#include <array>
#include <charconv>
#include <cmath>

#include "formula/lower.h"
#include "formula/operations.h"

namespace saddle {
namespace {

std::string js_operand(const Graph& graph, NodeId id,
                       const std::function<std::string(Symbol)>& name) {
  const Node& node = graph[id];
  if (node.op == Op::Constant) return js_number(node.value);
  if (node.op != Op::Variable) return "t" + std::to_string(id);
  if (node.symbol == kSymbolU) return "u";
  if (node.symbol == kSymbolV) return "v";
  return name(node.symbol);
}

}  // namespace

std::string_view js_text(Op op) {
  switch (op) {
    case Op::Constant:
    case Op::Variable:
    case Op::Hull:
    case Op::Narrow:
      break;
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, glsl, js, ...) \
  case Op::id:                                                               \
    return js;
#include "formula/ops.def"
  }
  return {};
}

std::string js_number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "(1/0)" : "(-1/0)";
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  const std::string result(digits.data(), end);
  return result.front() == '-' ? "(" + result + ")" : result;  // - -1 would be a decrement
}

JsCode print_js(const Graph& graph, std::span<const NodeId> outputs,
                const std::function<std::string(Symbol)>& name) {
  std::vector<NodeId> roots(outputs.begin(), outputs.end());
  const Graph lowered = lower(graph, roots);
  const std::vector<bool> needed = reachable(lowered, roots);
  JsCode code;
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (!needed[id]) continue;
    const Node& node = lowered[id];
    if (arity(node.op) == 0) continue;
    std::array<std::string, 3> arguments;
    for (int i = 0; i < arity(node.op); ++i) arguments[i] = js_operand(lowered, node.args[i], name);
    const bool is_each = (node.depends & (kDependsU | kDependsV)) != 0;
    std::string& part = is_each ? code.each : code.once;
    part +=
        "const t" + std::to_string(id) + "=" + with_arguments(js_text(node.op), arguments) + ";\n";
  }
  for (const NodeId root : roots) code.outputs.push_back(js_operand(lowered, root, name));
  return code;
}

}  // namespace saddle
