// Meshes as 3MF, for printers: a ZIP of XML, with units and colours.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "export/content.h"

namespace saddle {

/// Writes each mesh as an object, in millimetres; a vertex is a point of the mesh. A closed
/// two-sided mesh is a "model" that faces outward; others are "surface", which programs for
/// printers may refuse. Triangles have the colour of their side, or of the numbers at their
/// corners; those that show the back are also painted for the second extruder, which is what
/// slicers read. Numbers as in write_obj(). Streamed. Throws Error (Input) past 4 GiB of XML.
/// Source: 3MF Consortium, "3MF core specification" 1.3, "Materials and properties" 1.2.1.
void write_3mf(std::ostream& out, const MeshContent& content);

/// The scene file in a 3MF of write_3mf(). Throws Error (Input) for a file that is no 3MF.
std::optional<std::string> scene_in_3mf(const std::string& bytes, const std::string& name);

}  // namespace saddle
