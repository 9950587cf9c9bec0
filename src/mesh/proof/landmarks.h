// Landmarks: points of a surface beside its jumps and boundaries, and places in its holes. A branch
// and bound over the domain finds features of any size down to 2^-20 of the range, before there is
// a mesh.
// Source: J. Tupper, "Reliable two-dimensional graphing methods for mathematical formulae with two
// free variables", 2001.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mesh/proof/hole_rim.h"
#include "surface/parameter_box.h"
#include "surface/surface.h"

namespace saddle {

/// A point of the surface, or a box in which the surface is undefined.
struct Landmark {
  dvec2 uv;
  dvec3 position;  ///< NaN in a hole
  dvec2 size;      ///< of the undefined box around `uv`; 0 at a point of the surface
  dvec2 across;    ///< (1, 0) beside a line of constant u, (0, 1) of constant v, else 0
  dvec2 speed{0};  ///< |r_u| and |r_v|
  HoleRim rim{};   ///< around `uv` in a hole

  bool is_hole() const { return size.x > 0; }
};

struct Landmarks {
  std::vector<Landmark> places;
  /// Height of the highest step that bisection did not find to be a slope; infinite beside a pole.
  double highest_step = 0;
  /// A box around the boxes in which points of the surface were found.
  ParameterBox around = {dvec2(std::numeric_limits<double>::infinity()),
                         dvec2(-std::numeric_limits<double>::infinity())};
  /// A place beside one where the surface is defined was found to be undefined.
  bool has_boundary = false;
};

/// The landmarks of a surface of second order. Few boxes stay open around a small feature; along a
/// curve a share of them is followed. Where bounds are too wide, the search ends with its budget.
Landmarks find_landmarks(const Surface& surface, unsigned threads);

/// A small part of the domain, outside of which no place is known to be defined.
struct SmallComponent {
  ParameterBox where;
  std::vector<dvec3> positions;  ///< finite, of points spread over it
};

/// The part of the domain around all landmarks and the samples that met the surface. Empty without
/// landmarks.
std::optional<SmallComponent> component_of(const Landmarks& landmarks, std::span<const dvec2> met,
                                           const Surface& surface, unsigned threads);

}  // namespace saddle
