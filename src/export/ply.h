// Meshes as PLY, binary little endian.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "export/content.h"
#include "export/placed_meshes.h"
#include "mesh/model/mesh.h"

namespace saddle {

/// Writes the meshes as one PLY: vertex `x y z nx ny nz` as float (all six as double where a float
/// would round a position by more than kFloatRounding of the diagonal), `u v` as double; faces
/// `list uchar int vertex_indices`, triangles. A vertex is a corner of a mesh. Streamed: the file
/// is never in memory.
/// Where a mesh is coloured, vertices end with `red green blue` as uchar: colors[i] are those of
/// the corners of mesh i, white for a mesh that has none. Source: G. Turk, "The PLY polygon file
/// format", 1994. `names`: of the meshes; comments of the header tell which faces are whose. Empty:
/// none.
void write_ply(std::ostream& out, std::span<const Mesh> meshes,
               std::span<const std::vector<Rgb>> colors = {},
               std::span<const std::string> names = {});

/// write_ply() of the meshes where the scene's nodes have them, with their colours, and with their
/// names where there are several or one has a name of its own.
void write_scene_ply(std::ostream& out, const MeshContent& content);

/// Rounding of positions to float beyond this share of the bounding box's diagonal makes them
/// doubles: a tenth of the finest tolerance that meshes are asked for.
inline constexpr double kFloatRounding = 1e-7;

}  // namespace saddle
