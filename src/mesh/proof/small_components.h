// Finds places where a surface is defined in boxes of parameters none of whose samples is.
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

/// Where the surface is defined in each box, or nothing: bounds prove that it is not, or it was not
/// found. Boxes are halved, all alike, until their middles are defined, as long as there are
/// `boxes` left, of which each bound takes one. Of each box at most `most_parts` are followed.
std::vector<std::optional<dvec2>> find_defined(const Surface& surface,
                                               std::span<const ParameterBox> where,
                                               std::size_t& boxes, unsigned threads,
                                               std::size_t most_parts = SIZE_MAX);

/// A small part of the domain outside of which nothing of the surface is known.
struct SmallComponent {
  ParameterBox where;
  std::vector<dvec3> positions;  ///< finite, of some points that are spread over it
};

/// Looks for one closer and closer; nothing if the surface was found to be defined nowhere.
std::optional<SmallComponent> find_small_component(const Surface& surface, unsigned threads);

}  // namespace saddle
