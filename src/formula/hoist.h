// Parts of formulas that depend on neither u nor v, taken out of them: a shader gets their values
// with each picture, and stays the same program while a parameter or t changes.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "formula/graph.h"

namespace saddle {

struct Hoisted {
  std::vector<NodeId> roots;    ///< as before, with variables of their own for the parts
  std::vector<Symbol> symbols;  ///< those variables
  std::vector<double> values;   ///< and what they stand for
};

/// `values` gives the number that each node is, all of which depend on parameters and t alone.
/// Parts without these are constants of the formulas already, and stay. So do exponents that are
/// whole: powers of them are products, which are faster and more exact.
Hoisted hoist(Graph& graph, std::span<const NodeId> roots,
              const std::function<std::vector<double>(std::span<const NodeId> nodes)>& values);

}  // namespace saddle
