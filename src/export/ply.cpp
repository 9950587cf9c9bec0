#include "export/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/printable.h"
#include "scene/model/instances.h"

namespace saddle {
namespace {

/// Gathers numbers, little endian, and hands them to a stream in large pieces.
class NumberWriter {
 public:
  explicit NumberWriter(std::ostream& out) : out_(out), buffer_(kBytes) {}

  template <typename Number>
  void put(Number number) {
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), &number, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big) {
      std::reverse(bytes.begin(), bytes.end());
    }
    if (used_ + sizeof(Number) > kBytes) flush();
    std::memcpy(buffer_.data() + used_, bytes.data(), sizeof(Number));
    used_ += sizeof(Number);
  }

  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
  }

 private:
  static constexpr std::size_t kBytes = std::size_t{1} << 16;
  std::ostream& out_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

/// The type of x y z nx ny nz: one for the file, as it has one header.
bool needs_doubles(std::span<const Mesh> meshes) {
  Bounds bounds;
  double worst = 0;
  for (const Mesh& mesh : meshes) {
    for (const dvec3& p : mesh.position) {
      bounds.add(p);
      for (int k = 0; k < 3; ++k) {
        worst = std::max(worst, std::abs(p[k] - static_cast<double>(static_cast<float>(p[k]))));
      }
    }
  }
  // Beyond the range of floats the rounding is infinite, and squares of the diagonal may be too.
  return std::isinf(worst) || worst > kFloatRounding * bounds.diagonal();
}

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

/// `colors`: of each corner; nullptr: the file has none.
template <typename Real>
void write_vertices(NumberWriter& writer, const Mesh& mesh, const std::vector<Rgb>* colors) {
  constexpr Rgb kWhite = {255, 255, 255};
  for (std::size_t i = 0; i < mesh.position.size(); ++i) {
    for (int k = 0; k < 3; ++k) writer.put(static_cast<Real>(mesh.position[i][k]));
    for (int k = 0; k < 3; ++k) writer.put(static_cast<Real>(mesh.normal[i][k]));
    writer.put(mesh.uv[i].x);
    writer.put(mesh.uv[i].y);
    if (colors == nullptr) continue;
    for (const std::uint8_t channel : colors->empty() ? kWhite : (*colors)[i]) writer.put(channel);
  }
}

/// `first` is the number of the mesh's first vertex in the file.
void write_faces(NumberWriter& writer, const Mesh& mesh, std::size_t first) {
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    writer.put(std::uint8_t{3});
    for (const std::uint32_t corner : triangle) {
      writer.put(static_cast<std::int32_t>(first + corner));
    }
  }
}

}  // namespace

void write_ply(std::ostream& out, std::span<const Mesh> meshes,
               std::span<const std::vector<Rgb>> colors, std::span<const std::string> names) {
  Layout layout;
  layout.doubles = needs_doubles(meshes);
  layout.colored = !colors.empty();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::size_t first = layout.faces;
    layout.vertices += meshes[i].position.size();
    layout.faces += meshes[i].triangles.size();
    if (names.empty() || layout.faces == first) continue;
    layout.comments += "comment object " + printable(names[i]) + ", faces " +
                       std::to_string(first) + " to " + std::to_string(layout.faces - 1) + "\n";
  }
  if (layout.vertices > std::numeric_limits<std::int32_t>::max()) {
    throw Error(Status::Input, "the mesh has more vertices than a PLY file can number", {},
                "a coarser tolerance gives fewer");
  }
  write_header(out, layout);
  NumberWriter writer(out);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::vector<Rgb>* const own = layout.colored ? &colors[i] : nullptr;
    layout.doubles ? write_vertices<double>(writer, meshes[i], own)
                   : write_vertices<float>(writer, meshes[i], own);
  }
  std::size_t first = 0;
  for (const Mesh& mesh : meshes) {
    write_faces(writer, mesh, first);
    first += mesh.position.size();
  }
  writer.flush();
}

void write_scene_ply(std::ostream& out, const MeshContent& content) {
  const Scene& scene = content.scene;
  std::vector<std::string> names;
  for (const Instance& instance : instances(scene)) {
    names.push_back(scene.surfaces[instance.surface].name);
  }
  if (names.size() == 1 && names[0] == SurfaceSpec{}.name) names.clear();
  write_ply(out, placed_meshes(scene, content.meshes), placed_colors(scene, content.meshes), names);
}

}  // namespace saddle
