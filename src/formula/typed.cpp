#include "formula/typed.h"

#include <string>

namespace saddle {
namespace {

/// Which types a letter of a signature admits, in words.
struct Wanted {
  char letter;
  const char* what;
  const char* hint;
};
constexpr std::array kWanted = {
    Wanted{'z', "a number", "take a component, such as (...).x"},
    Wanted{'r', "a real number", "write re(...), im(...), abs(...) or norm(...)"},
    Wanted{'p', "a vector", "write (a, b, c) or (a, b)"},
    Wanted{'q', "a vector of 3", "write (a, b, c)"},
    Wanted{'s', "the variable of the curve, a plain name",
           "write u in frame((cos(u), sin(u), u), u)"},
};

bool admits(const Graph& graph, char letter, const Value& value) {
  switch (letter) {
    case 'z':
      return value.type == Type::Real || value.type == Type::Complex;
    case 'p':
      return is_vector(value.type);
    case 'q':
      return value.type == Type::Vector3;
    case 's':
      return value.type == Type::Real && graph[value.real()].op == Op::Variable;
    default:
      return value.type == Type::Real;
  }
}

}  // namespace

Complex complex_of(Graph& graph, const Value& value) {
  const NodeId im = value.type == Type::Complex ? value.nodes[1] : graph.constant(0);
  return {{&graph, value.nodes[0]}, {&graph, im}};
}

Components vector_of(Graph& graph, const Value& value) {
  Components result;
  for (const NodeId part : value.parts()) result.push_back({&graph, part});
  return result;
}

Value value_of(Expression a) {
  return Value(a.id);
}
Value value_of(const Complex& a) {
  return {Type::Complex, std::array{a.re.id, a.im.id}};
}
Value value_of(const Components& a) {
  std::vector<NodeId> parts;
  for (const Expression component : a) parts.push_back(component.id);
  return {a.size() == 2 ? Type::Vector2 : Type::Vector3, parts};
}

TypedArguments::TypedArguments(Graph& graph, std::string_view function, std::string_view signature,
                               std::span<const Value> arguments, const Sampler& sampler)
    : graph_(graph), arguments_(arguments), sampler_(sampler) {
  for (std::size_t k = 0; k < signature.size(); ++k) {
    if (admits(graph, signature[k], arguments[k])) continue;
    for (const Wanted& wanted : kWanted) {
      if (wanted.letter != signature[k]) continue;
      const bool is_name = wanted.letter == 's';
      throw TypeFault{
          "'" + std::string(function) + "' takes " + wanted.what + " here" +
              (is_name ? "" : ", and this is " + std::string(name_of(arguments[k].type))),
          wanted.hint, static_cast<int>(k)};
    }
  }
  if (signature == "pp" && arguments[0].type != arguments[1].type) {
    throw TypeFault{"'" + std::string(function) + "' takes two vectors of the same length",
                    "write (a, b, 0) for a vector of 2 in space"};
  }
}

}  // namespace saddle
