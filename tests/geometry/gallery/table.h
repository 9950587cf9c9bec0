// What is true of each surface of the gallery, by mathematics.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec.h"

namespace saddle {

/// Something that is 0 at every point of a surface. `size` bounds the sum of its terms' absolute
/// values: coefficients times the distance from the origin (1 at the least) to a power.
struct Equation {
  std::function<double(const dvec3& p, double u, double v)> value;
  double coefficients;
  int degree;
};

/// Places in (u, v): where `off` is 0. A report names at least one of them.
struct Places {
  std::function<double(double u, double v)> off;
};

/// Whether a mesh within a tolerance can be proved to miss nothing.
enum class Proof {
  Holds,  ///< it must: the formula is smooth everywhere, and bounds of its derivatives are near
  May,    ///< it depends on how well bounds do beside a point at which there are no derivatives
  Fails,  ///< it cannot: there is a rim, a jump or a pole, or derivatives grow beyond bounds
};

struct GalleryFacts {
  std::string name;
  dvec3 extents;  ///< of the part in the scene's clip box; infinite: not bounded
  std::optional<long> euler_number = 0;  ///< nothing: it is decided by what is below a tolerance
  std::size_t boundary_loops = 0;
  bool orientable = true;
  std::size_t components = 1;
  std::string closed_u = {}, closed_v = {};  ///< Seam::name()
  Proof proof = Proof::Holds;
  std::vector<Places> singular = {}, poles = {}, jumps = {};
  bool holed = false;  ///< undefined somewhere
  std::optional<Equation> equation = {};
  bool minimal = false;              ///< no mean curvature
  std::optional<double> gauss = {};  ///< constant Gauss curvature
};

/// One entry for each surface of `saddle list`.
std::span<const GalleryFacts> gallery_facts();

}  // namespace saddle
