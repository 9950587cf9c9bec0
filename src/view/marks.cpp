#include "view/marks.h"

#include <algorithm>

namespace saddle {
namespace {

/// More lines than these hide the surface that they stand on.
constexpr std::size_t kMostLines = 1500;

}  // namespace

void append_normal_marks(const Mesh& mesh, double length, Mesh& marks) {
  const std::size_t step = std::max<std::size_t>(1, mesh.position.size() / kMostLines);
  for (std::size_t i = 0; i < mesh.position.size(); i += step) {
    const auto first = static_cast<std::uint32_t>(marks.position.size());
    for (const dvec3& p : {mesh.position[i], mesh.position[i] + length * mesh.normal[i]}) {
      marks.position.push_back(p);
      marks.normal.push_back(mesh.normal[i]);
      marks.bounds.add(p);
    }
    marks.lines.push_back({first, first + 1});
  }
}

}  // namespace saddle
