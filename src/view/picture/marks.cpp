#include "view/picture/marks.h"

#include <algorithm>

#include "scene/model/instances.h"

namespace saddle {
namespace {

/// More lines than these hide the surface that they stand on.
constexpr std::size_t kMostLines = 1500;

}  // namespace

void append_normal_marks(const Mesh& mesh, const glm::dmat4& to_world, double length, Mesh& marks) {
  const glm::dmat3 to_normal = normal_matrix(glm::dmat3(to_world));
  const std::size_t step = std::max<std::size_t>(1, mesh.position.size() / kMostLines);
  for (std::size_t i = 0; i < mesh.position.size(); i += step) {
    const dvec3 turned = to_normal * mesh.normal[i];
    const double size = glm::length(turned);
    if (!(size > 0)) continue;  // no normal, or drawn as nothing
    const auto first = static_cast<std::uint32_t>(marks.position.size());
    const dvec3 foot(to_world * glm::dvec4(mesh.position[i], 1));
    for (const dvec3& p : {foot, foot + length / size * turned}) {
      marks.position.push_back(p);
      marks.normal.push_back(turned / size);
      marks.bounds.add(p);
    }
    marks.lines.push_back({first, first + 1});
  }
}

}  // namespace saddle
