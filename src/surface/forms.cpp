#include "surface/forms.h"

#include "formula/derive.h"
#include "formula/tangent.h"

namespace saddle {
namespace {

/// A vector of formulas. A component that is zero by structure, as z_u of a surface of revolution,
/// drops out of products and sums.
struct Vector {
  std::array<Tangent, 3> component;
};

Tangent product(const Tangent& s, const Tangent& t) {
  return s.slope && t.slope ? s * *t.slope : Tangent{};
}

Tangent dot(const Vector& a, const Vector& b) {
  Tangent sum;
  for (int k = 0; k < 3; ++k) sum = sum + product(a.component[k], b.component[k]);
  return sum;
}

Vector cross(const Vector& a, const Vector& b) {
  Vector result;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    result.component[k] =
        product(a.component[i], b.component[j]) - product(a.component[j], b.component[i]);
  }
  return result;
}

Vector vector_of(Graph& graph, const Coordinates& nodes) {
  Vector result;
  for (int k = 0; k < 3; ++k) {
    if (!graph.is_constant(nodes[k], 0)) result.component[k].slope = Expression{&graph, nodes[k]};
  }
  return result;
}

Expression value(Graph& graph, const Tangent& tangent) {
  return tangent.slope.value_or(Expression{&graph, graph.constant(0)});
}

Coordinates derivative(Graph& graph, const Coordinates& r, Symbol symbol) {
  const std::vector<NodeId> slopes = derive(graph, r, symbol);
  return {slopes[0], slopes[1], slopes[2]};
}

void append(std::vector<NodeId>& outputs, const Coordinates& vector) {
  outputs.insert(outputs.end(), vector.begin(), vector.end());
}

/// r_uu, r_uv, r_vv.
std::array<Coordinates, 3> second_derivatives(Graph& graph, const Tangents& tangents) {
  return {derivative(graph, tangents.r_u, kSymbolU), derivative(graph, tangents.r_u, kSymbolV),
          derivative(graph, tangents.r_v, kSymbolV)};
}

}  // namespace

Tangents tangents_of(Graph& graph, const Coordinates& r) {
  return {r, derivative(graph, r, kSymbolU), derivative(graph, r, kSymbolV)};
}

std::vector<NodeId> tangent_outputs(const Tangents& tangents) {
  std::vector<NodeId> outputs;
  append(outputs, tangents.r);
  append(outputs, tangents.r_u);
  append(outputs, tangents.r_v);
  return outputs;
}

std::vector<NodeId> normal_outputs(Graph& graph, const Tangents& tangents) {
  std::vector<NodeId> outputs;
  append(outputs, tangents.r);
  const Vector r_u = vector_of(graph, tangents.r_u);
  const Vector r_v = vector_of(graph, tangents.r_v);
  const Vector normal = cross(r_u, r_v);
  for (const Tangent& component : normal.component) {
    outputs.push_back(value(graph, component).id);
  }
  outputs.push_back(value(graph, dot(r_u, r_u)).id);
  outputs.push_back(value(graph, dot(r_v, r_v)).id);
  return outputs;
}

std::vector<NodeId> second_order_outputs(Graph& graph, const Tangents& tangents) {
  std::vector<NodeId> outputs = tangent_outputs(tangents);
  for (const Coordinates& vector : second_derivatives(graph, tangents)) append(outputs, vector);
  return outputs;
}

std::vector<NodeId> curvature_outputs(Graph& graph, const Tangents& tangents) {
  const std::array<Coordinates, 3> second = second_derivatives(graph, tangents);
  const Vector r_u = vector_of(graph, tangents.r_u);
  const Vector r_v = vector_of(graph, tangents.r_v);
  const Vector normal = cross(r_u, r_v);
  const Expression area = sqrt(value(graph, dot(normal, normal)));
  std::array<Tangent, 3> form;  // L, M, N: second derivatives along the unit normal
  for (int k = 0; k < 3; ++k) form[k] = dot(vector_of(graph, second[k]), normal) / area;

  // The shape operator in the orthonormal frame r_u / |r_u| and, across it, (r_v - f r_u) / h. Its
  // entries a, b, c give principal curvatures that keep their digits where the two are equal, which
  // H +- sqrt(H^2 - K) does not.
  const Expression E = value(graph, dot(r_u, r_u));
  const Tangent f = dot(r_u, r_v) / E;
  const Expression h_squared = area * area / E;
  const auto& [L, M, N] = form;
  const Expression a = value(graph, L / E);
  const Expression b = value(graph, (M - product(f, L)) / area);
  const Tangent cross_term = product(f, M + (M - product(f, L)));
  const Expression c = value(graph, (N - cross_term) / h_squared);
  const Expression mean = (a + c) / 2;
  const Expression half_gap = hypot((a - c) / 2, b);

  std::vector<NodeId> outputs;
  for (const Coordinates& vector : second) append(outputs, vector);
  for (const Expression& curvature : {a * c - b * b, mean, mean + half_gap, mean - half_gap}) {
    outputs.push_back(curvature.id);
  }
  return outputs;
}

}  // namespace saddle
