// The request for a mesh: the way of meshing, the tolerances and limits that the mesh keeps.
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
    LeastCost,        ///< the same or a grid: whichever costs less to make and to draw
    Samples,          ///< a grid of `samples`, cut along its features, not subdivided
  };
  Method method = Method::FewestTriangles;

  /// The tolerance of a surface that the probe describes; called once, and required.
  /// Method::Samples does not keep it, but tells jumps from slopes by it.
  std::function<Tolerance(const Probe&)> tolerance;
  double normal_tolerance = 180;  ///< degrees between interpolated and exact normals
  std::size_t max_triangles = 4'000'000;
  bool certify = true;  ///< interval proofs find what hides between samples, within a budget

  /// The mesh is cut along this box; its faces may be infinitely far.
  std::optional<Bounds> clip = {};
  /// When meshing stops early, without a mesh; the report tells what was found.
  enum class Stop {
    Never,
    AtPoles,      ///< at a pole
    AtPolesOrFar  ///< at a pole, or at a vertex beyond `far`
  };
  Stop stop = Stop::Never;
  double far = 0;  ///< in diagonals of the box around most of the probe's samples

  /// Drawn lines of constant u and of constant v, evenly spaced from end to end of the range; 0:
  /// none. They run along edges of the mesh.
  int lines_u = 16;
  int lines_v = 16;

  std::optional<CellCounts> samples = {};  ///< for Method::Samples
  double draws = 1;                        ///< for Method::LeastCost: times that the mesh is drawn
  unsigned threads = 0;                    ///< 0: all
};

}  // namespace saddle
