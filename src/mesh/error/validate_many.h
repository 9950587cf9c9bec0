// Validates many leaves at a time, by vector loops. Most leaves are two triangles beside a smooth
// surface.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/distance/sampled_error.h"
#include "mesh/tree/leaf_mesh.h"

namespace saddle {

/// Places in a leaf, in sides of the leaf from its low corner.
using PlacesInLeaf = std::array<dvec2, 4>;

/// A leaf that is cut into two triangles along one of its diagonals.
struct TwoTriangles {
  dvec2 low, high;  ///< parameters
  std::array<Triangle, 2> triangles;
  PlacesInLeaf places;  ///< where it is measured
};

struct LeafError {
  SampledError worst;  ///< at its places
  double predicted;    ///< largest distance predicted beside them: mesh/distance/newton_step.h
};

/// The errors of leaves; nothing for leaves to which only sampled_error() applies.
std::vector<std::optional<LeafError>> validate_many(const Surface& surface, const Grid& grid,
                                                    std::span<const TwoTriangles> leaves,
                                                    unsigned threads);

/// A place on one of several triangles of a leaf.
struct PlaceOnTriangle {
  dvec2 uv;
  std::array<std::uint32_t, 4> corners;  ///< of that triangle, 2 3 0, and of one beside it, 0 1 2
  dvec3 weights;                         ///< of corners 2, 3 and 0; negative: it is outside
};

/// The errors at places; nothing for places to which only sampled_error() applies.
std::vector<std::optional<LeafError>> validate_places(const Surface& surface, const Grid& grid,
                                                      std::span<const PlaceOnTriangle> places,
                                                      unsigned threads);

}  // namespace saddle
