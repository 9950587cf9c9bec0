// The arguments of functions of complex numbers and vectors, and their results: what the rows
// SADDLE_TYPED of ops.def are written in.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "formula/complex.h"
#include "formula/expression.h"
#include "formula/space.h"
#include "formula/value.h"

namespace saddle {

/// A real number is complex, too.
Complex complex_of(Graph& graph, const Value& value);
Components vector_of(Graph& graph, const Value& value);

Value value_of(Expression a);
Value value_of(const Complex& a);
Value value_of(const Components& a);

/// Arguments whose types are those that the signature asks for.
class TypedArguments {
 public:
  /// Throws TypeFault, with what `function` takes.
  TypedArguments(Graph& graph, std::string_view function, std::string_view signature,
                 std::span<const Value> arguments, const Sampler& sampler);

  Complex z(std::size_t k) const { return complex_of(graph_, arguments_[k]); }
  Expression r(std::size_t k) const { return {&graph_, arguments_[k].real()}; }
  Components p(std::size_t k) const { return vector_of(graph_, arguments_[k]); }
  Symbol symbol(std::size_t k) const { return graph_[arguments_[k].real()].symbol; }
  const Sampler& sampler() const { return sampler_; }

 private:
  Graph& graph_;
  std::span<const Value> arguments_;
  const Sampler& sampler_;
};

}  // namespace saddle
