// The value of a formula or of a part of it: a type, and a graph node for each of its real parts.
// Types exist while a formula is parsed; afterwards there are real nodes alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "formula/graph.h"

namespace saddle {

enum class Type : std::uint8_t {
  Real,
  Complex,  ///< real and imaginary part
  Vector2,  ///< x, y
  Vector3,  ///< x, y, z
  Frame     ///< three vectors of 3: tangent, normal, binormal
};

/// Number of real parts.
constexpr std::size_t part_count(Type type) {
  constexpr std::array<std::size_t, 5> kCounts = {1, 2, 2, 3, 9};
  return kCounts[static_cast<std::size_t>(type)];
}

/// How messages call it: "real", "complex", "a vector of 2".
inline const char* name_of(Type type) {
  constexpr std::array kNames = {"real", "complex", "a vector of 2", "a vector of 3", "a frame"};
  return kNames[static_cast<std::size_t>(type)];
}

inline bool is_vector(Type type) {
  return type == Type::Vector2 || type == Type::Vector3;
}

struct Value {
  Type type = Type::Real;
  std::array<NodeId, 9> nodes = {};  ///< those past part_count() are 0

  Value() = default;
  explicit Value(NodeId real) : nodes{real} {}
  /// `parts`: as many as the type has.
  Value(Type of, std::span<const NodeId> parts) : type(of) {
    for (std::size_t i = 0; i < parts.size(); ++i) nodes[i] = parts[i];
  }

  std::span<const NodeId> parts() const { return {nodes.data(), part_count(type)}; }
  /// The node of a real number.
  NodeId real() const { return nodes[0]; }
};

/// Operands whose types do not go together. The parser adds the place.
struct TypeFault {
  std::string message;
  std::string hint;
  int operand = -1;  ///< which one it is about; -1: the operator or function
};

}  // namespace saddle
