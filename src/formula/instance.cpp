#include "formula/instance.h"

#include <unordered_map>

namespace saddle {

Pattern pattern_of(Parameters& parameters, std::span<const Value> values, bool real_are_known) {
  Pattern pattern;
  for (const Value& value : values) {
    auto& [type, parts] = pattern.emplace_back(value.type, Pattern::value_type::second_type{});
    if (type == Type::Real && !real_are_known) continue;
    for (std::size_t k = 0; k < part_count(type); ++k) {
      if (parameters.known_value(value.nodes[k])) parts[k] = value.nodes[k];
    }
  }
  return pattern;
}

std::vector<Value> make_arguments(Graph& graph, const Pattern& pattern,
                                  std::vector<Symbol>& symbols) {
  std::vector<Value> arguments;
  for (const auto& [type, parts] : pattern) {
    std::vector<NodeId> nodes;
    for (std::size_t k = 0; k < part_count(type); ++k) {
      if (!parts[k]) symbols.push_back(graph.new_symbol());
      nodes.push_back(parts[k] ? *parts[k] : graph.variable(symbols.back()));
    }
    arguments.emplace_back(type, nodes);
  }
  return arguments;
}

Value apply(Graph& graph, const FunctionForTypes& instance, const Pattern& pattern,
            std::span<const Value> values) {
  std::unordered_map<Symbol, NodeId> replacements;
  auto symbol = instance.symbols.begin();
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < part_count(values[i].type); ++k) {
      if (!pattern[i].second[k]) replacements[*symbol++] = values[i].nodes[k];
    }
  }
  return {instance.body.type, substitute(graph, instance.body.parts(), replacements)};
}

}  // namespace saddle
