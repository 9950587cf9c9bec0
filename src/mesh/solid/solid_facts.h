// Facts about a solid: whether it is closed, how many shells it has, its volume, and how often it
// crosses itself.
#pragma once

#include <cstddef>

#include "mesh/model/mesh.h"

namespace saddle {

struct SolidFacts {
  bool closed = false;        ///< each edge has two triangles, and there is an inside
  std::size_t shells = 0;     ///< closed surfaces without a common point: a hollow has two
  double volume = 0;          ///< enclosed; where it crosses itself, counted as often as enclosed
  std::size_t crossings = 0;  ///< pairs of triangles that go through each other
};

/// Measured on the solid's triangles, from their point numbers and positions. `threads` 0: all.
SolidFacts solid_facts(const Mesh& solid, unsigned threads);

/// Pairs of triangles without a common point that go through each other; such as only touch do not.
std::size_t count_crossings(const Mesh& mesh, unsigned threads);

}  // namespace saddle
