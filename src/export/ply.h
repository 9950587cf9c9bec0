// Meshes as PLY, binary little endian.
#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>

#include "export/content.h"
#include "export/placed_meshes.h"

namespace saddle {

/// Writes the meshes as one PLY: vertex `x y z nx ny nz` as float (all six as double where a float
/// would round a position by more than kFloatRounding of the diagonal), `u v` as double; faces
/// `list uchar int vertex_indices`, triangles. A vertex is a corner of a mesh. Streamed: the file
/// is never in memory.
/// Where a mesh is coloured, vertices end with `red green blue` as uchar, white for a mesh that has
/// no numbers to colour by. `comments`: more lines of the header. Source: G. Turk, "The PLY polygon
/// file format", 1994.
void write_ply(std::ostream& out, std::span<const ExportedMesh> meshes,
               const std::string& comments = {});

/// write_ply() of the meshes where the scene's nodes have them. Comments of the header hold the
/// scene, and tell which faces are whose where there are several or one has a name of its own.
void write_scene_ply(std::ostream& out, const MeshContent& content);

/// The scene file in a PLY of write_scene_ply().
std::optional<std::string> scene_in_ply(const std::string& bytes, const std::string& name);

}  // namespace saddle
