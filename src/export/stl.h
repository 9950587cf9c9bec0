// Meshes as binary STL.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <span>

#include "export/content.h"
#include "export/placed_meshes.h"

namespace saddle {

/// Writes the triangles: positions as float, the normals of the triangles, no attributes. Closed
/// two-sided parts face outward. Triangles of which rounding to floats makes corners coincide are
/// left out; their neighbours then meet. Streamed. Throws Error (Input) for more than 2^32 - 1
/// triangles, and for positions beyond floats.
/// Source: 3D Systems, "StereoLithography interface specification", 1988.
void write_stl(std::ostream& out, const MeshContent& content);

/// Triangles that write_stl() leaves out.
std::size_t flattened_triangles(std::span<const ExportedMesh> placed);

}  // namespace saddle
