// Names and what they mean: the user's definitions, in any order, turned into graph nodes on
// demand. This is the way from text to graph; formula/parser.h is its inner part.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/error.h"
#include "formula/definition.h"
#include "formula/graph.h"

namespace saddle {

/// The names of a surface's two parameters.
using ParameterNames = std::array<std::string, 2>;
inline const ParameterNames kUsualParameters = {"u", "v"};

class Scope {
 public:
  /// How a surface sees the definitions.
  struct View {
    ParameterNames parameters = kUsualParameters;
    /// Shared definitions are parsed when they are used: those of other surfaces may use the names
    /// of other parameters.
    bool lazy = false;
    /// parse() and constant() are for formulas of the surface; else for shared ones.
    bool of_surface = true;
    /// Formulas of the ends of the parameters' ranges; empty: unknown.
    std::array<std::array<std::string, 2>, 2> ranges = {};
    bool keeps_time = false;  ///< bind() leaves t in place, as it leaves parameters that are kept
  };

  /// `definitions`: parameters, shared sub-expressions, helper functions and the surface's own x,
  /// y, z, in any order; they may use each other. A name means the surface's own definition, else
  /// its parameter, else the shared definition; in a shared definition the shared one comes first,
  /// and own ones are not seen. All are parsed here, used or not, unless the view is lazy. Throws
  /// Error (Input) with the place: a malformed formula, an unknown name, a definition of a
  /// function's name or of u or v, the same name twice, a circle (the circle is shown), an x, y or
  /// z that is not real, an xyz that is no vector of 3.
  Scope(Graph& graph, std::vector<Definition> definitions, View view);
  Scope(Graph& graph, std::vector<Definition> definitions)
      : Scope(graph, std::move(definitions), View{}) {}
  ~Scope();
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

  /// The node of a real definition that is no function, or of a parameter of the surface. Constants
  /// that have a name are variables in it: see bind().
  NodeId node(const std::string& name) const;

  /// Parses one more formula: the bytes `part` of `text` (all of it by default), called `name` in
  /// messages. It is real. Throws Error (Input).
  NodeId parse(const std::string& name, const std::string& text,
               std::optional<Span> part = std::nullopt);

  /// The same where some names mean more than elsewhere, unless the user has defined them; they are
  /// made when they are used.
  using LocalNames = std::map<std::string, std::function<NodeId()>>;
  NodeId parse_with(const LocalNames& locals, const std::string& name, const std::string& text);

  /// parse() for a formula that must not depend on u, v or, unless that has a value here, t: its
  /// value. It may be infinite or NaN: what is allowed is for the caller to say.
  double constant(const std::string& name, const std::string& text,
                  std::optional<Span> part = std::nullopt, std::optional<double> t = std::nullopt);

  /// constant() of a node that parse() gave for the formula at `place`.
  double value(NodeId node, const Place& place, std::optional<double> t);

  /// A value of constant() or value() depended on t.
  bool has_used_time() const;

  /// The roots with every parameter replaced by its value and t by `t`, but for those that are
  /// kept.
  std::vector<NodeId> bind(std::span<const NodeId> roots, double t);

  /// The variables that stand for constants with a name, and their values.
  std::unordered_map<Symbol, double> constants() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace saddle
