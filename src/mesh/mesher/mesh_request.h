// The request for a mesh: how it is to be made, and what it is to keep.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "base/bounds.h"
#include "mesh/model/tolerance.h"

namespace saddle {

class Probe;

/// Cells along u and along v, at least one each.
struct CellCounts {
  std::size_t u, v;
};

struct MeshRequest {
  enum class Method {
    FewestTriangles,  ///< cells are subdivided where the tolerance asks for it
    LeastCost,        ///< the same or a grid, whichever costs less to make and to draw
    Samples,          ///< a grid of `samples`, cut along its features, not subdivided
  };
  Method method = Method::FewestTriangles;

  /// The tolerance of a surface that the probe describes; called once. With Method::Samples it is
  /// not kept, but tells jumps from slopes.
  std::function<Tolerance(const Probe&)> tolerance;
  double normal_tolerance = 180;  ///< degrees between interpolated and exact normals
  std::size_t max_triangles = 4'000'000;
  bool certify = true;  ///< prove that nothing hides between samples, within the budget

  /// The mesh is cut along this box; its faces may be infinitely far.
  std::optional<Bounds> clip = {};
  /// Conditions under which the work stops without a mesh; the report then tells what was found.
  enum class Stop {
    Never,
    AtPoles,      ///< where the surface goes to infinity
    AtPolesOrFar  ///< the same, or where a vertex is beyond `far`
  };
  Stop stop = Stop::Never;
  double far = 0;  ///< diagonals of the box that most of the probe's samples keep to

  /// Lines of constant u and of constant v, evenly spaced, first and last on the ends of the range;
  /// 0: none. They are among the mesh's edges.
  int lines_u = 16;
  int lines_v = 16;

  std::optional<CellCounts> samples = {};  ///< for Method::Samples
  double draws = 1;                        ///< for Method::LeastCost: times that the mesh is drawn
  unsigned threads = 0;                    ///< 0: all
};

}  // namespace saddle
