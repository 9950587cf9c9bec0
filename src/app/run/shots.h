// Which moments a run draws, and for which of its outputs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/command_line/cli.h"
#include "app/run/outputs.h"
#include "scene/model/scene.h"

namespace saddle {

struct Shot {
  double t = 0;
  std::optional<int> frame = {};  ///< its number in the animation, for outputs that take frames
  bool still = false;             ///< for the others

  /// The output shows this moment.
  bool is_for(const Output& output) const {
    return output.takes_frames() ? frame.has_value() : still;
  }
};

/// "frame 12, t = 0.4"; empty for a moment outside of the animation.
std::string name_of(const Shot& shot);

/// An output is made of frames.
bool has_frames(const CommandLine& line, std::span<const Output> outputs);

/// The scene's own moment, if an output is of it, then the animation's frames, if one is of these.
/// `scene` is resolved, with an animation if outputs have frames. Throws Error (Input): frames that
/// the animation does not have, several for a file without a number, none for an option about
/// frames, a moment that no output is of, a GIF that is too fast.
std::vector<Shot> shots_of(const CommandLine& line, const Scene& scene,
                           std::span<const Output> outputs);

}  // namespace saddle
