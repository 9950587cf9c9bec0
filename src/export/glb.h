// Scenes as GLB, binary glTF 2.0.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "export/content.h"

namespace saddle {

/// Writes each surface as one mesh, in its own coordinates, and a node for each node of the scene.
/// The root node turns the scene's z axis up to glTF's y, and has MeshContent::factor. Positions
/// are floats about the centre of the surface's box, which a node adds as a double.
/// A surface whose sides differ is two sheets that are seen from one side each, kSheetGap of the
/// box's diagonal apart; one sheet where no back can be seen. Colours are linear. Grid lines, level
/// lines and curves are lines without lighting. The camera is the picture's. Streamed.
/// Throws Error (Input) for a file past 4 GiB, and for a surface beyond floats.
void write_glb(std::ostream& out, const MeshContent& content);

/// The scene file in a GLB of write_glb(). Throws Error (Input) for a file that is no GLB.
std::optional<std::string> scene_in_glb(const std::string& bytes, const std::string& name);

}  // namespace saddle
