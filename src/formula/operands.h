// Operators and calls by the types of their operands.
#pragma once

#include <span>
#include <string_view>

#include "formula/graph.h"
#include "formula/language.h"
#include "formula/space.h"
#include "formula/value.h"

namespace saddle {

/// `op` of as many operands as its arity. Throws TypeFault.
Value operate(Graph& graph, Op op, std::span<const Value> operands);

/// A call of a function of the language other than diff; the number of arguments is right.
/// `sampler`: of the formula's domain. Throws TypeFault.
Value call_built_in(Graph& graph, const BuiltIn& function, std::span<const Value> arguments,
                    const Sampler& sampler);

/// The vector of 2 or 3 real numbers. Throws TypeFault.
Value make_vector(std::span<const Value> components);

/// The part `name` of a value: x, y or z of a vector; t, n or b of a frame. Throws TypeFault.
Value component_of(const Value& value, std::string_view name);

}  // namespace saddle
