// Formulas as JavaScript: straight-line code of doubles, from the js column of ops.def.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formula/graph.h"

namespace saddle {

/// The row's text for numbers a, b, c.
std::string_view js_text(Op op);

/// A number that JavaScript reads as exactly this double.
std::string js_number(double value);

/// The code of some outputs. Shared parts are computed once, into constants t0, t1 ...
struct JsCode {
  std::string once;                  ///< statements of what depends on neither u nor v
  std::string each;                  ///< statements of the rest, which need `once` before them
  std::vector<std::string> outputs;  ///< an expression for each output, a name or a number
};

/// Code that computes every output from `u` and `v`; other variables are called what `name` gives.
/// It may call any function of src/export/page/functions.js.
JsCode print_js(const Graph& graph, std::span<const NodeId> outputs,
                const std::function<std::string(Symbol)>& name);

}  // namespace saddle
