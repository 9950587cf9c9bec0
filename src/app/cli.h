// The command line as data.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/context.h"
#include "scene/scene.h"
#include "scene/values.h"

namespace saddle {

/// Largest --reference error that passes: pictures up to it are hard to tell apart.
inline constexpr double kDefaultThreshold = 0.04;

struct CommandLine {
  enum class Command { Graph, Check, Chart, List, Show, Help, Functions, Keys, Version };

  Command command = Command::Graph;
  std::vector<std::string> arguments;  ///< assignments and names, without a verb
  std::vector<std::string> outputs;
  std::string format;                              ///< of outputs without an extension of their own
  std::vector<std::function<void(Scene&)>> edits;  ///< what options change, in their order
  std::optional<FrameRange> frame_range;           ///< of the animation; none: all
  std::string frame_option;                        ///< the last one that is about frames
  bool has_moment = false;                         ///< --t
  std::string reference;
  double threshold = kDefaultThreshold;
  bool watch = false;
  Backend renderer = Backend::Any;
  unsigned threads = 0;  ///< 0: all
  std::string report;
  bool strict = false;  ///< warnings are failures
  bool quiet = false;
  bool verbose = false;
};

/// Throws Error (Input): an unknown option, a value that is missing, malformed or out of range.
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace saddle
