#include "study/exact_surface.h"

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "formula/derive.h"
#include "formula/lexer.h"
#include "scene/model/prepare.h"

namespace saddle {
namespace {

/// The constants of the language that no double is, by a number that is 1.
std::string constant_of_one(std::string_view name, const std::string& one) {
  if (name == "pi") return "acos(-" + one + ")";
  if (name == "tau") return "(2*acos(-" + one + "))";
  if (name == "e") return "exp(" + one + ")";
  if (name == "phi") return "((1+sqrt(5*" + one + "))/2)";
  return std::string(name);
}

/// The formula with every number N as N*one, so that nothing is rounded or folded as a double
/// before it is valued with 50 digits; so with the index of a sum. `hidden`: names that are not the
/// language's constants here.
std::string unfolded(const std::vector<Token>& formula, const std::string& one,
                     const std::vector<std::string>& hidden) {
  const auto begins_range = [&](std::size_t i) {
    return i + 1 < formula.size() && formula[i + 1].text == "=";
  };
  std::set<std::string> indices;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    if (begins_range(i)) indices.insert(formula[i].text);
  }
  std::string result;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const Token& token = formula[i];
    const bool is_index = token.kind == TokenKind::Name && indices.contains(token.text);
    if (token.kind == TokenKind::Number || (is_index && !begins_range(i))) {
      result += "(" + token.text + "*" + one + ")";
    } else if (!is_index && token.kind == TokenKind::Name &&
               std::ranges::find(hidden, token.text) == hidden.end()) {
      result += constant_of_one(token.text, one);
    } else {
      result += token.text;
    }
    result += " ";
  }
  return result;
}

/// The texts with a parameter that is 1 in all of their constants. Plain numbers stay: they are
/// exact, and a name that stands for one can be differentiated by.
SurfaceTexts unfolded(SurfaceTexts texts) {
  std::vector<std::string> names(texts.view.parameters.begin(), texts.view.parameters.end());
  for (const Definition& definition : texts.definitions) {
    names.push_back(definition.name);
    names.insert(names.end(), definition.arguments.begin(), definition.arguments.end());
  }
  std::string one = "one";
  while (std::ranges::find(names, one) != names.end()) one += "_";
  const auto unfold = [&](std::string& text) {
    const auto tokens = tokenize({"", text, {0, text.size()}});
    if (tokens.size() > 1 || tokens[0].kind != TokenKind::Number) {
      text = unfolded(tokens, one, names);
    }
  };
  for (Definition& definition : texts.definitions) unfold(definition.text);
  unfold(texts.spec.v.min);
  unfold(texts.spec.v.max);
  texts.definitions.push_back({one, "1"});
  return texts;
}

}  // namespace

RealVector cross(const RealVector& a, const RealVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real length(const RealVector& a) {
  return sqrt(Real(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]));
}

ExactSurface::ExactSurface(const Scene& scene, const SurfaceSpec& spec) {
  const SurfaceTexts texts = {surface_definitions(scene, spec), surface_view(scene, spec), spec};
  values_[kSymbolT] = scene.t;
  try {
    read(unfolded(texts));
  } catch (const Error&) {
    read(texts);  // diff() by a parameter needs it as a plain number
  }
}

void ExactSurface::read(const SurfaceTexts& texts) {
  graph_ = {};
  Scope scope(graph_, texts.definitions, texts.view);
  std::vector<NodeId> position(3);
  std::ranges::copy(restricted_position(graph_, scope, texts.spec), position.begin());
  const std::array<NodeId, 2> ends = {scope.parse("v", texts.spec.v.min),
                                      scope.parse("v", texts.spec.v.max)};
  if (((graph_[ends[0]].depends | graph_[ends[1]].depends) & kDependsU) != 0) {
    position = substitute(graph_, position, {{kSymbolV, between(graph_, ends)}});
  }
  roots_ = position;
  for (const Symbol by : {kSymbolU, kSymbolV}) {
    const std::vector<NodeId> slopes = derive(graph_, position, by);
    roots_.insert(roots_.end(), slopes.begin(), slopes.end());
  }
  for (const auto& [symbol, value] : scope.constants()) values_[symbol] = value;
}

std::vector<Real> ExactSurface::values(std::span<const NodeId> roots, const Real& u,
                                       const Real& v) const {
  const auto variable = [&](Symbol symbol) {
    return symbol == kSymbolU ? u : symbol == kSymbolV ? v : Real(values_.at(symbol));
  };
  const std::vector<Real> all = exact_values(graph_, roots, variable);
  std::vector<Real> result;
  for (const NodeId root : roots) result.push_back(all[root]);
  return result;
}

ExactPoint ExactSurface::operator()(const Real& u, const Real& v) const {
  const std::vector<Real> all = values(roots_, u, v);
  return {{all[0], all[1], all[2]}, {all[3], all[4], all[5]}, {all[6], all[7], all[8]}};
}

RealVector ExactSurface::position(const Real& u, const Real& v) const {
  const std::vector<Real> all = values(std::span(roots_).first(3), u, v);
  return {all[0], all[1], all[2]};
}

}  // namespace saddle
