// Meshes as OBJ, with the materials and the colormap in files beside it.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "export/content.h"

namespace saddle {

/// Writes each mesh as an object: `v` per point, `vt` and `vn` per corner, so that positions are
/// welded and normals split. `vt` is (u, v), or a place in the picture of colours where there are
/// some. Numbers are those of floats, or of doubles as in write_ply(); normals
/// have six digits. Grid lines, level lines and
/// curves are `l` of two vertices each, in objects of their own at the end; points are `p`.
/// Comments hold the scene. Without MeshContent::stem there are no materials. Streamed. Source:
/// Wavefront, "Object files", Advanced Visualizer manual, appendix B1.
void write_obj(std::ostream& out, const MeshContent& content);

/// The materials of write_obj(): STEM.mtl. Source: D. Ramey et al., "MTL material format", 1995.
void write_mtl(std::ostream& out, const MeshContent& content);

/// The picture of colours that the materials name, STEM-color.png.
void write_color_png(std::ostream& out, const MeshContent& content);

/// A mesh of the scene is coloured by an expression.
bool is_colored(const MeshContent& content);

/// The scene file in an OBJ of write_obj().
std::optional<std::string> scene_in_obj(const std::string& bytes, const std::string& name);

}  // namespace saddle
