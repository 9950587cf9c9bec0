#include "formula/glsl.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "base/format.h"
#include "formula/lower.h"
#include "formula/operations.h"

namespace saddle {
namespace {

/// A double as the nearest float. Past the largest float it is infinite, as rounding has it.
float to_float(double value) {
  // Halfway between the largest float and the power of two above it.
  constexpr double kOverflow = 0x1.ffffffp127;
  if (std::fabs(value) >= kOverflow) {
    return static_cast<float>(std::copysign(std::numeric_limits<double>::infinity(), value));
  }
  return static_cast<float>(value);
}

/// A constant that GLSL reads as exactly this float; GLSL has no literals for infinity and NaN.
std::string literal(double value) {
  const float number = to_float(value);
  if (std::isnan(number)) return "uintBitsToFloat(0x7fc00000u)";
  if (std::isinf(number)) {
    return number > 0 ? "uintBitsToFloat(0x7f800000u)" : "uintBitsToFloat(0xff800000u)";
  }
  std::string result = formatted("%.9g", static_cast<double>(number));
  if (result.find_first_of(".e") == std::string::npos) result += ".0";
  return number < 0 ? "(" + result + ")" : result;  // - -1.0 would be a decrement
}

std::string operand(const Graph& graph, NodeId id, std::span<const Symbol> constants) {
  const Node& node = graph[id];
  if (node.op == Op::Constant) return literal(node.value);
  if (node.op == Op::Variable) {
    if (node.symbol == kSymbolU) return "u";
    if (node.symbol == kSymbolV) return "v";
    const auto found = std::ranges::find(constants, node.symbol);
    assert(found != constants.end());
    return "constant[" + std::to_string(found - constants.begin()) + "]";
  }
  return "t" + std::to_string(id);
}

std::optional<Op> first_without_glsl(const Graph& graph, const std::vector<bool>& needed) {
  for (NodeId id = 0; id < needed.size(); ++id) {
    const bool leaf = arity(graph[id].op) == 0;
    if (needed[id] && !leaf && glsl_text(graph[id].op).empty()) return graph[id].op;
  }
  return std::nullopt;
}

}  // namespace

std::string_view glsl_text(Op op) {
  constexpr std::string_view NO_GLSL;
  switch (op) {
    case Op::Constant:
    case Op::Variable:
    case Op::Hull:
    case Op::Narrow:
      break;
#define SADDLE_OP(id, name, arity, help, value, vector, ulps, glsl, ...) \
  case Op::id:                                                           \
    return glsl;
#include "formula/ops.def"
  }
  return {};
}

std::optional<std::string> print_glsl(const Graph& graph, std::span<const NodeId> outputs,
                                      std::span<const std::string_view> names,
                                      std::span<const Symbol> constants) {
  assert(outputs.size() == names.size());
  std::vector<NodeId> roots(outputs.begin(), outputs.end());
  const Graph lowered = lower(graph, roots);
  const std::vector<bool> needed = reachable(lowered, roots);
  if (first_without_glsl(lowered, needed)) return std::nullopt;
  std::string code;
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (!needed[id]) continue;
    const Node& node = lowered[id];
    if (arity(node.op) == 0) continue;
    std::array<std::string, 3> arguments;
    for (int i = 0; i < arity(node.op); ++i) {
      arguments[i] = operand(lowered, node.args[i], constants);
    }
    code += "float " + operand(lowered, id, constants) + " = ";
    code += with_arguments(glsl_text(node.op), arguments) + ";\n";
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    code.append(names[i]).append(" = ").append(operand(lowered, roots[i], constants)).append(";\n");
  }
  return code;
}

std::optional<Op> operation_without_glsl(const Graph& graph, std::span<const NodeId> outputs) {
  std::vector<NodeId> roots(outputs.begin(), outputs.end());
  const Graph lowered = lower(graph, roots);
  return first_without_glsl(lowered, reachable(lowered, roots));
}

}  // namespace saddle
