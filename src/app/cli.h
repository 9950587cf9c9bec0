// The command line as plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

namespace saddle {

/// `MxN`: M in u, N in v.
struct GridSize {
  int u = 0;
  int v = 0;
};

/// A length: in pixels of the picture, or as a share of the bounding box's diagonal.
struct ToleranceValue {
  double value = 0;
  bool pixels = false;
};

inline constexpr int kDefaultWidth = 800;  ///< pixels
inline constexpr int kDefaultHeight = 600;
/// Largest --reference error that passes: pictures up to it are hard to tell apart.
inline constexpr double kDefaultThreshold = 0.04;

struct CommandLine {
  enum class Command { Graph, List, Show, Help, Functions, Version };

  Command command = Command::Graph;
  std::vector<std::string> arguments;  ///< assignments and names, without a verb
  std::vector<std::string> outputs;
  std::string format;  ///< of outputs without an extension of their own
  int width = kDefaultWidth;
  int height = kDefaultHeight;
  std::optional<dvec3> view;
  std::optional<dvec3> up;
  std::optional<dvec3> target;
  std::optional<double> distance;
  std::optional<double> fov;  ///< degrees
  bool ortho = false;
  std::optional<Color> background;
  std::optional<Color> front;
  std::optional<Color> back;
  std::optional<ToleranceValue> tolerance;  ///< default: of a picture or of a mesh
  double normal_tolerance = 3;              ///< degrees
  int max_triangles = 4'000'000;
  std::optional<Clip> clip;
  std::optional<GridSize> samples;
  std::optional<GridSize> grid;  ///< 0 x 0: off
  int antialias = 2;
  bool flip = false;
  std::optional<std::string> t;
  std::string reference;
  double threshold = kDefaultThreshold;
  unsigned threads = 0;  ///< 0: all
  std::string report;
  bool quiet = false;
  bool verbose = false;
};

/// Throws Error (Input): an unknown option, a value that is missing, malformed or out of range.
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace saddle
