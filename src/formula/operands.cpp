#include "formula/operands.h"

#include <array>
#include <string>
#include <vector>

#include "formula/operations.h"
#include "formula/typed.h"

namespace saddle {
namespace {

bool is_comparison(Op op) {
  return op >= Op::Less && op <= Op::NotEqual;
}

/// The first operand of a type, or -1.
template <class F>
int find_type(std::span<const Value> operands, F is_wanted) {
  for (std::size_t k = 0; k < operands.size(); ++k) {
    if (is_wanted(operands[k].type)) return static_cast<int>(k);
  }
  return -1;
}
bool is_complex(Type type) {
  return type == Type::Complex;
}
bool is_no_number(Type type) {
  return is_vector(type) || type == Type::Frame;
}

TypeFault real_only(std::string_view name, std::span<const Value> operands) {
  const int which = find_type(operands, is_complex);
  return {"'" + std::string(name) + "' takes real numbers, and this is complex",
          "write re(...), im(...) or abs(...)", which};
}

TypeFault no_vectors(std::string_view name, std::span<const Value> operands) {
  const int which = find_type(operands, is_no_number);
  const Type type = operands[static_cast<std::size_t>(which)].type;
  return {"'" + std::string(name) + "' takes numbers, and this is " + name_of(type),
          type == Type::Frame ? "take a component, .t, .n or .b"
                              : "take its length, norm(...), or a component, such as (...).x",
          which};
}

/// The sum or difference of vectors, a multiple or a part of one.
Value operate_on_vectors(Graph& graph, Op op, std::span<const Value> v) {
  const bool is_sum = op == Op::Add || op == Op::Sub;
  const bool is_product = op == Op::Mul || op == Op::Div;
  if (find_type(v, [](Type type) { return type == Type::Frame; }) >= 0 ||
      (!is_sum && !is_product && op != Op::Neg && op != Op::Pow)) {
    throw no_vectors(row_of(op).name, v);
  }
  if (op == Op::Neg) {
    return value_of(Expression{&graph, graph.constant(-1)} * vector_of(graph, v[0]));
  }
  if (op == Op::Pow) {
    throw TypeFault{"a power of a vector", "the square of its length is dot(a, a)"};
  }
  const bool are_vectors = is_vector(v[0].type) && is_vector(v[1].type);
  if (is_sum && !are_vectors) {
    throw TypeFault{"a number and a vector have no sum", "write (a, b, c) for the number"};
  }
  if (is_sum && v[0].type != v[1].type) {
    throw TypeFault{"vectors of 2 and of 3 have no sum", "write (a, b, 0) for the shorter one"};
  }
  if (is_sum) {
    const Components a = vector_of(graph, v[0]);
    const Components b = vector_of(graph, v[1]);
    return value_of(op == Op::Add ? a + b : a - b);
  }
  if (op == Op::Div && is_vector(v[1].type)) {
    throw TypeFault{"a division by a vector", "divide by its length, norm(...)", 1};
  }
  if (are_vectors) throw TypeFault{"a product of two vectors", "write dot(a, b) or cross(a, b)"};
  const std::size_t factor = is_vector(v[0].type) ? 1 : 0;
  if (v[factor].type == Type::Complex) {
    throw TypeFault{"a vector times a complex number", "write re(...), im(...) or abs(...)",
                    static_cast<int>(factor)};
  }
  const Expression number{&graph, v[factor].real()};
  const Components vector = vector_of(graph, v[1 - factor]);
  return value_of(op == Op::Mul ? number * vector : vector / number);
}

/// One of two values of the same type; a real one beside a complex one is complex.
Value choose(Graph& graph, std::span<const Value> v) {
  if (v[0].type != Type::Real) {
    throw TypeFault{"the condition is " + std::string(name_of(v[0].type)),
                    "compare real numbers, for example abs(...) < 1", 0};
  }
  std::array<Value, 2> branches = {v[1], v[2]};
  for (std::size_t k : {0U, 1U}) {
    const bool is_mixed = branches[k].type == Type::Real && branches[1 - k].type == Type::Complex;
    if (is_mixed) branches[k] = value_of(complex_of(graph, branches[k]));
  }
  const auto& [yes, no] = branches;
  if (yes.type != no.type) {
    throw TypeFault{
        "one choice is " + std::string(name_of(v[1].type)) + ", the other " + name_of(v[2].type),
        "both must be of one type", 2};
  }
  std::vector<NodeId> parts;
  for (std::size_t k = 0; k < part_count(yes.type); ++k) {
    parts.push_back(graph.make(Op::Select, v[0].real(), yes.nodes[k], no.nodes[k]));
  }
  return {yes.type, parts};
}

bool are_real(std::span<const Value> values) {
  return find_type(values, [](Type type) { return type != Type::Real; }) < 0;
}

std::vector<Expression> expressions(Graph& graph, std::span<const Value> values) {
  std::vector<Expression> result;
  for (const Value& value : values) result.push_back({&graph, value.real()});
  return result;
}

Value call_complex(Graph& graph, const BuiltIn& function, std::span<const Value> values) {
  if (function.of_complex == nullptr) throw real_only(function.name, values);
  std::vector<Complex> numbers;
  for (const Value& value : values) numbers.push_back(complex_of(graph, value));
  const Complex result = function.of_complex(numbers);
  return function.name == "abs" ? value_of(result.re) : value_of(result);
}

/// sum, prod and avg of what is not real.
Value fold(Graph& graph, const BuiltIn& function, std::span<const Value> values) {
  const bool is_of_real = *function.fold == Op::Min || *function.fold == Op::Max;
  if (is_of_real) {
    if (find_type(values, is_no_number) >= 0) throw no_vectors(function.name, values);
    throw real_only(function.name, values);
  }
  Value result = values[0];
  for (const Value& next : values.subspan(1)) {
    result = operate(graph, *function.fold, std::array{result, next});
  }
  if (function.name != "avg") return result;
  const Value count(graph.constant(static_cast<double>(values.size())));
  return operate(graph, Op::Div, std::array{result, count});
}

}  // namespace

Value operate(Graph& graph, Op op, std::span<const Value> operands) {
  if (are_real(operands)) {
    std::array<NodeId, 3> nodes = {};
    for (std::size_t k = 0; k < operands.size(); ++k) nodes[k] = operands[k].real();
    return Value(graph.make(op, nodes[0], nodes[1], nodes[2]));
  }
  if (op == Op::Select) return choose(graph, operands);
  const BuiltIn& row = built_in_of(op);
  if (is_comparison(op) || op == Op::And || op == Op::Or) {
    const bool is_complex_one = find_type(operands, is_complex) >= 0;
    TypeFault fault =
        is_complex_one ? real_only(row.name, operands) : no_vectors(row.name, operands);
    if (is_complex_one && is_comparison(op)) fault.hint = "compare re(...), im(...) or abs(...)";
    throw fault;
  }
  if (find_type(operands, is_no_number) >= 0) return operate_on_vectors(graph, op, operands);
  return call_complex(graph, row, operands);
}

Value call_built_in(Graph& graph, const BuiltIn& function, std::span<const Value> arguments,
                    const Sampler& sampler) {
  if (function.of_typed != nullptr) {
    return function.of_typed({graph, function.name, function.signature, arguments, sampler});
  }
  if (are_real(arguments)) return value_of(function.of_real(expressions(graph, arguments)));
  if (function.name == "if") return choose(graph, arguments);
  if (function.fold) return fold(graph, function, arguments);
  if (find_type(arguments, is_no_number) >= 0) throw no_vectors(function.name, arguments);
  return call_complex(graph, function, arguments);
}

Value make_vector(std::span<const Value> components) {
  if (components.size() > 3) {
    throw TypeFault{"a vector has 2 or 3 components, not " + std::to_string(components.size()),
                    "write (a, b, c)"};
  }
  std::vector<NodeId> parts;
  for (std::size_t k = 0; k < components.size(); ++k) {
    const Type type = components[k].type;
    if (type != Type::Real) {
      throw TypeFault{"a component of a vector is " + std::string(name_of(type)),
                      type == Type::Complex ? "write re(...), im(...), abs(...) or arg(...)"
                                            : "its components are real numbers, such as (...).x",
                      static_cast<int>(k)};
    }
    parts.push_back(components[k].real());
  }
  return {parts.size() == 2 ? Type::Vector2 : Type::Vector3, parts};
}

Value component_of(const Value& value, std::string_view name) {
  const bool is_frame = value.type == Type::Frame;
  const std::string_view names = is_frame ? "tnb" : "xyz";
  const std::size_t which = name.size() == 1 ? names.find(name) : std::string_view::npos;
  const bool has_parts = is_frame || is_vector(value.type);
  const std::size_t count = is_frame ? 3 : part_count(value.type);
  if (!has_parts || which >= count) {
    const std::string hint = !has_parts ? "a component is of a vector, (a, b, c); a product is a*b"
                             : is_frame ? "a frame has .t, .n and .b"
                             : count == 2 ? "it has .x and .y"
                                          : "it has .x, .y and .z";
    throw TypeFault{
        "this is " + std::string(name_of(value.type)) + " and has no '." + std::string(name) + "'",
        hint, 0};
  }
  if (!is_frame) return Value(value.nodes[which]);
  return {Type::Vector3, value.parts().subspan(3 * which, 3)};
}

}  // namespace saddle
