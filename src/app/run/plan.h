// The pictures and files of a run of saddle FORMULAS, checked before anything is computed.
#pragma once

#include <vector>

#include "app/command_line/cli.h"
#include "app/run/outputs.h"
#include "app/run/shots.h"
#include "meshing/tolerance.h"
#include "scene/options/resolve.h"

namespace saddle {

struct Plan {
  std::vector<Output> outputs;
  Timeline timeline;
  std::vector<Shot> shots;
  Purpose purpose;  ///< of the meshes, without moments

  /// Throws Error as checked_outputs(), build_scene(), Timeline, shots_of() and
  /// check_names_differ() do, in this order.
  explicit Plan(const CommandLine& line);

  const Scene& scene() const { return timeline.scene(); }
  /// Shots that are frames of an animation.
  int frames() const;
  /// Pictures are drawn: a page is seen, and drawn elsewhere.
  bool draws(const CommandLine& line) const;
  /// Pixels are drawn, or are the unit of the mesh's tolerance.
  bool needs_camera() const;
};

}  // namespace saddle
