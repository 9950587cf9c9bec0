// The request for a mesh: the tolerances and limits that the mesh keeps.
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

/// Lines of constant u and of constant v, evenly spaced from end to end of the range; 0: none.
struct LineCounts {
  int u = 16;
  int v = 16;
};

struct MeshRequest {
  /// The tolerance of a surface that the probe describes; called once, and required.
  /// A mesh of `samples` does not keep it, but tells jumps from slopes by it.
  std::function<Tolerance(const Probe&)> tolerance;
  /// Whether a surface with waves that are too short for any mesh is meshed more coarsely: to three
  /// pixels in a picture, in place of half of one. Not if it is clipped.
  bool is_coarse_with_waves = false;
  double normal_tolerance = 180;  ///< degrees between interpolated and exact normals
  std::size_t max_triangles = 4'000'000;
  /// The effort that is allowed however few the triangles are, in places (mesh/sizing/effort.h).
  std::size_t least_effort = 1'000'000;
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
  /// Whether another box is needed to cut the mesh along, by a box around the surface beside the
  /// poles that were found. Asked once, after cells are first subdivided: if so, meshing stops
  /// early, without a mesh. Empty: it does not.
  std::function<bool(const Bounds& beside_poles)> needs_other_box = {};

  /// The lines that are drawn; they run along edges of the mesh.
  LineCounts lines = {};
  /// The same, of a surface that the probe describes; in place of them if it is set.
  std::function<LineCounts(const Probe&, const Tolerance&)> lines_for = {};

  /// A grid of these cells, cut along its features, not subdivided; nothing: cells are subdivided
  /// where the tolerance asks for it.
  std::optional<CellCounts> samples = {};
  unsigned threads = 0;  ///< 0: all

  /// Leaves whose samples are in memory at a time: these take 8 MB. If a generation has more, the
  /// samples of its leaves are forgotten, which would be most of the memory of a fine mesh. As many
  /// are validated at a time.
  std::size_t leaves_at_a_time = std::size_t{1} << 15;
};

}  // namespace saddle
