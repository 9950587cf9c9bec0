// The report of a run as JSON.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "mesh/curve/curve_mesher.h"
#include "mesh/model/mesh.h"
#include "mesh/model/mesh_report.h"
#include "meshing/findings.h"
#include "meshing/thickness.h"
#include "render/picture/light_findings.h"
#include "render/picture/picture.h"
#include "study/facts.h"

namespace saddle {

struct SurfaceReport {
  std::string name;
  std::size_t triangles = 0;
  std::size_t vertices = 0;  ///< corners
  Bounds bounds;
  MeshReport mesh;
  std::vector<Finding> findings;
  int meshes = 1;                    ///< that an animation has made of it: several if t moves it
  std::optional<Facts> facts;        ///< of `saddle check`
  std::optional<SolidReport> solid;  ///< of a surface with a thickness
  std::optional<bool> culls_backs;   ///< of a picture: its back faces are left out
  std::optional<CurveMesh> curve;    ///< of a curve, without its chains
  std::optional<dvec3> place;        ///< of a point
};

/// Whether the mesh has an inside.
bool encloses_volume(const Facts& facts);

/// Milliseconds.
struct RunTimes {
  double parse = 0;
  double compile = 0;
  double tessellate = 0;
  std::optional<RenderTimes> render;  ///< with a picture
  double encode = 0;                  ///< writing the outputs, beside what else goes on
  double frame = 0;                   ///< from one frame to the next, the mean; of an animation
  double total = 0;                   ///< from the start of main
};

struct ImageReport {
  int width = 0;
  int height = 0;
  std::string renderer;
  std::size_t meshes = 0;     ///< on the graphics card, each uploaded once unless it changes
  std::size_t instances = 0;  ///< drawn: a mesh once for each of its nodes
};

struct RunReport {
  std::vector<SurfaceReport> surfaces;
  std::optional<ImageReport> image;
  int frames = 0;  ///< of an animation
  RunTimes times;
  std::vector<std::string> warnings;
  std::vector<SceneFinding> findings;  ///< of a picture's lights
};

/// One JSON object. A key is there if its feature is: what was not computed is left out; what has
/// no finite value is null. `bounds` is [[x, y, z], [x, y, z]], the low and the high corner.
void write_report(std::ostream& out, const RunReport& report);

/// Lines for --verbose.
std::vector<std::string> summary(const RunReport& report);

}  // namespace saddle
