// The thickness of surfaces: in which units, how thick each may be, and what their solids are.
#pragma once

#include <functional>
#include <optional>

#include "base/vec.h"
#include "mesh/model/mesh.h"
#include "mesh/solid/solid_facts.h"
#include "mesh/solid/thicken.h"
#include "scene/model/scene.h"
#include "surface/surface.h"

namespace saddle {

/// Where a surface bends most sharply toward its front and toward its back, at the corners of its
/// mesh; curvatures in 1/length, 0 where it bends to neither side.
struct SharpestBends {
  double toward_front = 0;
  double toward_back = 0;
  dvec2 at_front{0, 0};  ///< the user's parameters
  dvec2 at_back{0, 0};
};

/// For a surface of second order. `threads` 0: all.
SharpestBends sharpest_bends(const Surface& surface, const Mesh& mesh, unsigned threads);

/// A solid in a report.
struct SolidReport {
  SolidFacts facts;
  double thickness = 0;          ///< in the surface's units
  double largest_thickness = 0;  ///< with which no sheet folds where it bends; may be infinite
  std::optional<dvec2> at;       ///< where a larger one would, if there is such a place
};

/// Units per millimetre of a print whose longest side is `print_size` millimetres; without one, 1.
/// `longest_side`: of the box around all that is printed, in units, where a millimetre is so many
/// units; it grows with them, as solids do. The result is the fixed point x of
/// print_size x = longest_side(x). Throws Error (Input) if there is none: the thickness alone
/// exceeds the print's size.
double units_per_millimetre(std::optional<double> print_size,
                            const std::function<double(double)>& longest_side);

/// How far a solid goes to each side. `unit`: units per millimetre.
Thickening thickening_of(const Thickness& thickness, double unit);

/// The farthest that a solid goes from its surface, about, before there is a mesh; 0 without a
/// thickness. `longest`: the longest side of the surface's box.
double reach_of_solid(const Scene& scene, const SurfaceSpec& spec, double longest);

/// The largest thickness on the same sides with which no sheet folds.
SolidReport solid_report(const SolidFacts& facts, const Thickening& thickening,
                         const SharpestBends& bends);

}  // namespace saddle
