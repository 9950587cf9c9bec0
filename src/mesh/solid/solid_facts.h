// Facts about a solid: whether it is closed, how many shells it has, its volume, and how often it
// crosses itself.
#pragma once

#include <cstddef>

#include "mesh/model/mesh.h"

namespace saddle {

/// Pairs of triangles without a common point that go through each other; such as only touch do not.
struct Crossings {
  std::size_t pairs = 0;
  bool are_all = true;  ///< else there are so many that the search ended before
};

struct SolidFacts {
  bool closed = false;     ///< each edge has two triangles, and there is an inside
  std::size_t shells = 0;  ///< closed surfaces without a common point: a hollow has two
  double volume = 0;       ///< enclosed; where it crosses itself, counted as often as enclosed
  Crossings crossings;
};

/// Measured on the solid's triangles, from their point numbers and positions. `threads` 0: all.
SolidFacts solid_facts(const Mesh& solid, unsigned threads);

/// `threads` 0: all. The count is the same on any number of them.
Crossings count_crossings(const Mesh& mesh, unsigned threads);

}  // namespace saddle
