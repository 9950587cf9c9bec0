// A helper function for arguments of certain types.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "formula/parameters.h"
#include "formula/value.h"

namespace saddle {

/// For each argument of a function its type and, where the formula must know them, its parts.
using Pattern = std::vector<std::pair<Type, std::array<std::optional<NodeId>, 9>>>;

/// The formula of a function for arguments of one pattern; a symbol for each unknown part.
struct FunctionForTypes {
  std::vector<Symbol> symbols;
  Value body;
};

/// Parts that are constants make complex numbers and vectors simpler, and are what bounds of sums
/// and exponents must be. The parts of real numbers are known only if `real_are_known`: diff()
/// needs variables.
Pattern pattern_of(Parameters& parameters, std::span<const Value> values, bool real_are_known);

/// The arguments as the formula sees them; `symbols` are made for it.
std::vector<Value> make_arguments(Graph& graph, const Pattern& pattern,
                                  std::vector<Symbol>& symbols);

/// The value for arguments of that pattern.
Value apply(Graph& graph, const FunctionForTypes& instance, const Pattern& pattern,
            std::span<const Value> values);

}  // namespace saddle
