// The volume of a part is the sum of the tetrahedra that its triangles span with the centre of the
// mesh's box: its sign says which way they face.
#include "export/shells.h"

#include <algorithm>

namespace saddle {

Shells shells_of(const Mesh& mesh) {
  Shells result;
  if (mesh.solid) {
    // Its triangles face outward as they are: those of a cavity toward its inside.
    result.topology = topology(mesh);
    return result;
  }
  Parts parts;
  result.topology = topology(mesh, &parts);
  const std::size_t count = mesh.triangles.size();
  std::vector<double> volume(count);
  const dvec3 centre = mesh.bounds.centre();
  for (std::size_t t = 0; t < count; ++t) {
    const auto corner = [&](std::size_t k) { return mesh.position[mesh.triangles[t][k]] - centre; };
    const double sixfold = glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    volume[parts.first[t]] += parts.turned[t] != 0 ? -sixfold : sixfold;
  }
  result.turned = std::move(parts.turned);
  for (std::size_t t = 0; t < count; ++t) {
    const std::uint32_t first = parts.first[t];
    if (parts.is_open[first] == 0 && volume[first] < 0) result.turned[t] ^= 1;
    if (parts.is_one_sided[first] != 0) result.turned[t] = 0;
  }
  if (std::ranges::count(result.turned, 1) == 0) result.turned.clear();
  return result;
}

std::vector<Shells> shells_of(std::span<const Mesh> meshes) {
  std::vector<Shells> result;
  for (const Mesh& mesh : meshes) result.push_back(shells_of(mesh));
  return result;
}

}  // namespace saddle
