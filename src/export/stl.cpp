#include "export/stl.h"

#include <array>
#include <cstdint>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "base/error.h"
#include "export/writers.h"

namespace saddle {
namespace {

using Facet = std::array<glm::vec3, 3>;

Facet facet_of(const ExportedMesh& placed, std::size_t t, bool turned) {
  Triangle triangle = placed.triangle(t);
  if (turned) std::swap(triangle[1], triangle[2]);
  return {glm::vec3(placed.point(triangle[0])), glm::vec3(placed.point(triangle[1])),
          glm::vec3(placed.point(triangle[2]))};
}

bool is_flat(const Facet& f) {
  return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
}

/// Unit; zero for corners on a line.
glm::vec3 normal_of(const Facet& f) {
  const dvec3 a(f[0]);
  const dvec3 normal = glm::cross(dvec3(f[1]) - a, dvec3(f[2]) - a);
  const double length = glm::length(normal);
  return length > 0 ? glm::vec3(normal / length) : glm::vec3(0);
}

void put_vector(ByteWriter& writer, const glm::vec3& v) {
  for (int k = 0; k < 3; ++k) writer.put(v[k]);
}

void write_facets(ByteWriter& writer, const ExportedMesh& placed, const Shells& shells) {
  for (std::size_t t = 0; t < placed.mesh->triangles.size(); ++t) {
    const Facet facet = facet_of(placed, t, shells.is_turned(t));
    if (is_flat(facet)) continue;
    put_vector(writer, normal_of(facet));
    for (const glm::vec3& corner : facet) put_vector(writer, corner);
    writer.put(std::uint16_t{0});
  }
}

}  // namespace

std::size_t flattened_triangles(std::span<const ExportedMesh> placed) {
  std::size_t count = 0;
  for (const ExportedMesh& one : placed) {
    for (std::size_t t = 0; t < one.mesh->triangles.size(); ++t) {
      if (is_flat(facet_of(one, t, false))) ++count;
    }
  }
  return count;
}

void write_stl(std::ostream& out, const MeshContent& content) {
  const std::vector<ExportedMesh> meshes = placed_meshes(content);
  check_floats(meshes, "STL");
  std::vector<Shells> own;
  if (content.shells.empty()) own = shells_of(content.meshes);
  const std::span<const Shells> shells = own.empty() ? content.shells : own;
  std::size_t count = 0;
  for (const ExportedMesh& placed : meshes) count += placed.mesh->triangles.size();
  count -= flattened_triangles(meshes);
  if (count > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(Status::Input, "the mesh has more triangles than an STL file can count", {},
                "a coarser tolerance gives fewer");
  }
  ByteWriter writer(out);
  // A header that began with "solid" would be that of a text.
  std::string header = "saddle, binary STL";
  header.resize(80);
  writer.put_text(header);
  writer.put(static_cast<std::uint32_t>(count));
  for (const ExportedMesh& placed : meshes) {
    write_facets(writer, placed, shells[placed.surface]);
  }
  writer.flush();
}

}  // namespace saddle
