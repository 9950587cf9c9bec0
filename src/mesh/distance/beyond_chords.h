// The surface beyond the chords of its boundary, in their leaves: where the boundary has a cusp or
// a tongue, it may leave a chord farther than it is from the chord on the way straight across.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/distance/strip_distance.h"
#include "mesh/features/thin_parts.h"
#include "mesh/grid/grid.h"
#include "surface/parameter_box.h"

namespace saddle {

class BeyondChords {
 public:
  /// The surface outside of `clip` does not count.
  BeyondChords(const Surface& surface, const Grid& grid, const std::optional<Bounds>& clip,
               unsigned threads)
      : surface_(surface), grid_(grid), clip_(clip), threads_(threads) {}

  /// Adds the first side of `t`, a chord in a leaf over `box`. `triangles`, the leaf's, must
  /// outlive this; `allowed`: the leaf's tolerance.
  void add(const ParameterBox& box, std::size_t leaf, std::span<const Triangle> triangles,
           const Triangle& t, double allowed);

  /// Looks for the surface on lines of constant u and v, about one, two, four... tolerances beyond
  /// each chord, until there is none, or some that is farther than the tolerance from the
  /// triangles. Returns the latter.
  std::vector<LeafDistance> measure();

  /// Points and boxes.
  std::size_t looks() const { return looks_; }

 private:
  /// Lines on one side of a chord's box of parameters.
  struct Beyond {
    ParameterBox box;
    std::size_t leaf;
    std::span<const Triangle> triangles;
    double allowed;
    int axis;     ///< that the lines are straight across
    double from;  ///< the chord's last place along the axis
    double step;  ///< from there to the next line
  };
  static std::optional<Line> next_line(Beyond& beyond);

  const Surface& surface_;
  const Grid& grid_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  std::vector<Beyond> open_;
  std::size_t looks_ = 0;
};

}  // namespace saddle
