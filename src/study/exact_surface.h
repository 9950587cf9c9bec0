// A surface in 50 digits: the formulas as they are typed, with the real pi, nothing rounded on the
// way. Slow to compile: see high_precision.h.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "formula/scope.h"
#include "scene/model/scene.h"
#include "study/high_precision.h"

namespace saddle {

using RealVector = std::array<Real, 3>;

RealVector cross(const RealVector& a, const RealVector& b);
Real length(const RealVector& a);

/// A point with its tangents; NaN or infinite where it is undefined.
struct ExactPoint {
  RealVector r, r_u, r_v;
};

/// The texts of a surface.
struct SurfaceTexts {
  std::vector<Definition> definitions;
  Scope::View view;
  SurfaceSpec spec;  ///< for its range of v and its condition
};

/// Parameters are those of bind_surface(): where the ends of v depend on u, v is the part of the
/// way between them.
class ExactSurface {
 public:
  /// Throws Error (Input): anything wrong with a formula.
  ExactSurface(const Scene& scene, const SurfaceSpec& spec);

  ExactPoint operator()(const Real& u, const Real& v) const;
  RealVector position(const Real& u, const Real& v) const;

 private:
  void read(const SurfaceTexts& texts);
  std::vector<Real> values(std::span<const NodeId> roots, const Real& u, const Real& v) const;

  Graph graph_;
  std::vector<NodeId> roots_;        ///< x, y, z, their derivatives by u, then by v
  std::map<Symbol, double> values_;  ///< of t and the parameters
};

}  // namespace saddle
