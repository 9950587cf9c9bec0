// The settings of a run that are not part of its scene, from the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/model/values.h"

namespace saddle {

/// Largest --reference error that passes: rims that move by a part of a pixel do, a line that is
/// missing does not.
inline constexpr double kDefaultThreshold = 0.05;

/// Ways to OpenGL without a window.
enum class Backend {
  Any,     ///< the first of the others that starts
  Osmesa,  ///< off-screen Mesa: in software, the same picture on every machine
  Egl      ///< EGL without a surface: what newer Mesa has left, or a graphics card
};

/// The axis of an exported mesh that points up.
enum class MeshUp { Z, Y };

struct RunSettings {
  std::vector<std::string> outputs;       ///< paths; "-": standard output
  std::string format;                     ///< of outputs without an extension of their own
  std::string sliders = "all";            ///< of pages: "all", "off", or names of parameters
  bool fragment = false;                  ///< pages without html and body
  std::string reference;                  ///< the picture to compare with; empty: none
  double threshold = kDefaultThreshold;   ///< largest difference from it that passes, 0 to 1
  std::string report;                     ///< path; "-": standard output; empty: none
  MeshUp mesh_up = MeshUp::Z;             ///< of the formats that leave it open
  bool strict = false;                    ///< warnings are failures
  std::optional<FrameRange> frame_range;  ///< of the animation; none: all
  bool watch = false;                     ///< the viewer follows its scene file
  Backend renderer = Backend::Any;
  int threads = 0;                   ///< 0: all
  std::optional<double> max_memory;  ///< bytes; none: half of the machine's
  std::optional<double> max_time;    ///< seconds; none: no limit
  bool quiet = false;
  bool verbose = false;
  bool shader = false;  ///< show prints shaders in place of the scene
  bool help = false;
  bool version = false;
};

}  // namespace saddle
