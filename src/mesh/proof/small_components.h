// Finds small components of a surface: places where it is defined in boxes of parameters in which
// no sample is.
// Source: J. Tupper, "Reliable two-dimensional graphing methods for mathematical formulae with two
// free variables", 2001.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "surface/parameter_box.h"
#include "surface/surface.h"

namespace saddle {

/// A place in each box where the surface is defined. Empty where bounds prove that there is none,
/// or where none was found. Boxes are halved until a middle is defined; at most `most_parts` parts
/// of each are followed. Each bound takes one of the budget `boxes`.
std::vector<std::optional<dvec2>> find_defined(const Surface& surface,
                                               std::span<const ParameterBox> where,
                                               std::size_t& boxes, unsigned threads,
                                               std::size_t most_parts = SIZE_MAX);

/// A small part of the domain, outside of which no place is known to be defined.
struct SmallComponent {
  ParameterBox where;
  std::vector<dvec3> positions;  ///< finite, of points spread over it
};

/// Zooms in on the defined part of the domain. Empty if no place was found to be defined.
std::optional<SmallComponent> find_small_component(const Surface& surface, unsigned threads);

}  // namespace saddle
