// The differential geometry of r(u, v) = (x, y, z) as formulas, so that normals and curvatures are
// shared, hoisted and run like any other.
// Source: M. P. do Carmo, "Differential geometry of curves and surfaces", 1976, chapters 2 and 3.
#pragma once

#include <array>
#include <vector>

#include "formula/graph.h"

namespace saddle {

using Coordinates = std::array<NodeId, 3>;  ///< x, y, z of a vector, as nodes of a graph

/// A surface and its first derivatives.
struct Tangents {
  Coordinates r, r_u, r_v;
};

/// The derivatives of x(u, v), y(u, v), z(u, v), which depend on u and v alone.
Tangents tangents_of(Graph& graph, const Coordinates& r);

/// x, y, z, their derivatives by u, then by v.
std::vector<NodeId> tangent_outputs(const Tangents& tangents);

/// r, r_u, r_v, r_uu, r_uv, r_vv: three numbers each.
std::vector<NodeId> second_order_outputs(Graph& graph, const Tangents& tangents);

/// x, y, z; r_u x r_v; |r_u|^2; |r_v|^2.
std::vector<NodeId> normal_outputs(Graph& graph, const Tangents& tangents);

/// r_uu, r_uv, r_vv (three numbers each), the Gauss curvature, the mean curvature, and the
/// principal curvatures, larger first. These have the unit 1/length and are positive where the
/// surface bends toward the side that r_u x r_v points to; the Gauss curvature is their product.
inline constexpr std::size_t kGaussCurvature = 9;  ///< of these, counted from 0
inline constexpr std::size_t kMeanCurvature = 10;
std::vector<NodeId> curvature_outputs(Graph& graph, const Tangents& tangents);

}  // namespace saddle
