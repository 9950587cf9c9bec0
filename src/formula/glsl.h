// Formulas as GLSL 3.30: straight-line float code for the shaders, from the glsl column of ops.def.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "formula/graph.h"

namespace saddle {

/// The row's text for floats a, b, c; empty where the operation has none.
std::string_view glsl_text(Op op);

/// Statements that compute every output from the floats `u` and `v` and assign it to the variable
/// of its name, which the surrounding code declares. Shared parts are computed once, into
/// variables t0, t1 ... The code may call any function of shaders/functions.glsl, so that text
/// goes in front of the shader's main function, whole: it is short, and what is not called costs
/// only its parsing. Returns nothing if an operation has no GLSL: see operation_without_glsl().
/// The outputs depend on u, v and `constants` alone (Scope::bind has replaced the rest); those are
/// constant[0], constant[1] ... in the code.
std::optional<std::string> print_glsl(const Graph& graph, std::span<const NodeId> outputs,
                                      std::span<const std::string_view> names,
                                      std::span<const Symbol> constants = {});

/// The first operation that the outputs need and that has no GLSL, or nothing.
std::optional<Op> operation_without_glsl(const Graph& graph, std::span<const NodeId> outputs);

}  // namespace saddle
