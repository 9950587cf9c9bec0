// What a run did, as JSON.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "render/picture.h"
#include "study/facts.h"

namespace saddle {

struct SurfaceReport {
  std::string name;
  std::size_t triangles = 0;
  std::size_t vertices = 0;  ///< corners
  Bounds bounds;
  MeshReport mesh;
  std::optional<Facts> facts;  ///< of `saddle check`
};

/// Whether the mesh has an inside.
bool encloses_volume(const Facts& facts);

/// Milliseconds.
struct RunTimes {
  double parse = 0;
  double compile = 0;
  double tessellate = 0;
  std::optional<RenderTimes> render;  ///< with a picture
  double encode = 0;                  ///< writing the outputs
  double total = 0;                   ///< from the start of main
};

struct ImageReport {
  int width = 0;
  int height = 0;
  std::string renderer;
  std::string shaders;  ///< the surfaces' programs, for --verbose
};

struct RunReport {
  std::vector<SurfaceReport> surfaces;
  std::optional<ImageReport> image;
  RunTimes times;
  std::vector<std::string> warnings;
};

/// One JSON object. A key is there if its feature is: what was not computed is left out; what has
/// no finite value is null. `bounds` is [[x, y, z], [x, y, z]], the low and the high corner.
void write_report(std::ostream& out, const RunReport& report);

/// Lines for --verbose.
std::string summary(const RunReport& report);

}  // namespace saddle
