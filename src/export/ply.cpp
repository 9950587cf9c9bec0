#include "export/ply.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <vector>

#include "base/error.h"
#include "base/printable.h"
#include "export/scene_lines.h"
#include "export/writers.h"

namespace saddle {
namespace {

constexpr std::string_view kComment = "comment ";

/// The layout that the header declares.
struct Layout {
  bool doubles = false;
  bool colored = false;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::string comments = {};  ///< lines
};

void write_header(std::ostream& out, const Layout& layout) {
  const std::string real = layout.doubles ? "double" : "float";
  std::string header = "ply\nformat binary_little_endian 1.0\n" + layout.comments;
  header += "element vertex " + std::to_string(layout.vertices) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) {
    header += "property " + real + " " + name + "\n";
  }
  header += "property double u\nproperty double v\n";
  if (layout.colored) {
    for (const char* name : {"red", "green", "blue"}) {
      header += std::string("property uchar ") + name + "\n";
    }
  }
  header += "element face " + std::to_string(layout.faces) + "\n";
  header += "property list uchar int vertex_indices\nend_header\n";
  out << header;
}

template <typename Real>
void write_vertices(ByteWriter& writer, const ExportedMesh& placed, bool colored) {
  constexpr Rgb kWhite = {255, 255, 255};
  const Mesh& mesh = *placed.mesh;
  for (std::size_t i = 0; i < mesh.position.size(); ++i) {
    const dvec3 point = placed.point(i);
    const dvec3 normal = placed.normal(i);
    for (int k = 0; k < 3; ++k) writer.put(static_cast<Real>(point[k]));
    for (int k = 0; k < 3; ++k) writer.put(static_cast<Real>(normal[k]));
    writer.put(mesh.uv[i].x);
    writer.put(mesh.uv[i].y);
    if (!colored) continue;
    const Rgb color = placed.scale ? bytes_of(color_of(*placed.scale, mesh.color[i])) : kWhite;
    for (const std::uint8_t channel : color) writer.put(channel);
  }
}

/// `first` is the number of the mesh's first vertex in the file.
void write_faces(ByteWriter& writer, const ExportedMesh& placed, std::size_t first) {
  for (std::size_t t = 0; t < placed.mesh->triangles.size(); ++t) {
    writer.put(std::uint8_t{3});
    for (const std::uint32_t corner : placed.triangle(t)) {
      writer.put(static_cast<std::int32_t>(first + corner));
    }
  }
}

}  // namespace

void write_ply(std::ostream& out, std::span<const ExportedMesh> meshes,
               const std::string& comments) {
  Layout layout;
  layout.comments = comments;
  layout.doubles = float_rounding(meshes) > kFloatRounding;
  for (const ExportedMesh& placed : meshes) {
    layout.colored = layout.colored || placed.scale;
    layout.vertices += placed.mesh->position.size();
    layout.faces += placed.mesh->triangles.size();
  }
  if (layout.vertices > std::numeric_limits<std::int32_t>::max()) {
    throw Error(Status::Input, "the mesh has more vertices than a PLY file can number", {},
                "a coarser tolerance gives fewer");
  }
  write_header(out, layout);
  ByteWriter writer(out);
  for (const ExportedMesh& placed : meshes) {
    layout.doubles ? write_vertices<double>(writer, placed, layout.colored)
                   : write_vertices<float>(writer, placed, layout.colored);
  }
  std::size_t first = 0;
  for (const ExportedMesh& placed : meshes) {
    write_faces(writer, placed, first);
    first += placed.mesh->position.size();
  }
  writer.flush();
}

void write_scene_ply(std::ostream& out, const MeshContent& content) {
  std::vector<ExportedMesh> meshes = placed_meshes(content);
  std::erase_if(meshes, [](const ExportedMesh& placed) { return placed.is_line; });
  std::string comments = scene_lines(content.scene, kComment);
  const bool named = meshes.size() > 1 || (meshes.size() == 1 && meshes[0].name != "surface");
  std::size_t faces = 0;
  for (const ExportedMesh& placed : meshes) {
    const std::size_t first = faces;
    faces += placed.mesh->triangles.size();
    if (!named) continue;
    comments += std::string(kComment) + "object " + printable(placed.spec->name) + ", faces " +
                std::to_string(first) + " to " + std::to_string(faces - 1) + "\n";
  }
  write_ply(out, meshes, comments);
}

std::optional<std::string> scene_in_ply(const std::string& bytes, const std::string& /*name*/) {
  constexpr int kFirstLines = 2;  // "ply" and the format
  return scene_in_lines(bytes, kComment, kFirstLines);
}

}  // namespace saddle
