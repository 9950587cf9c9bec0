#include "export/nearest_corner.h"

#include <algorithm>
#include <array>
#include <limits>

namespace saddle {
namespace {

/// Cells along each axis: a surface of a million corners then has about a hundred in each.
constexpr int kCells = 64;

}  // namespace

NearestCorner::NearestCorner(const Mesh& mesh)
    : mesh_(mesh), scale_(axis_scale(mesh.bounds) * static_cast<double>(kCells)) {
  entries_.reserve(mesh.position.size());
  for (std::size_t i = 0; i < mesh.position.size(); ++i) {
    entries_.push_back({cell_of(mesh.position[i]), static_cast<std::uint32_t>(i)});
  }
  std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.corner < b.corner;
  });
}

NearestCorner::Cell NearestCorner::cell_of(const dvec3& p, const std::array<int, 3>& steps) const {
  Cell cell = 0;
  for (int k = 0; k < 3; ++k) {
    const double place = (p[k] - mesh_.bounds.low[k]) * scale_[k];
    const double inside = std::clamp(place, 0.0, kCells - 1.0);
    const int number = static_cast<int>(inside) + steps[static_cast<std::size_t>(k)];
    cell = cell * kCells + static_cast<Cell>(std::clamp(number, 0, kCells - 1));
  }
  return cell;
}

std::size_t NearestCorner::to(const dvec3& p) const {
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  const auto look_in = [&](Cell cell) {
    auto entry = std::ranges::lower_bound(entries_, cell, {}, &Entry::cell);
    for (; entry != entries_.end() && entry->cell == cell; ++entry) {
      const dvec3 d = mesh_.position[entry->corner] - p;
      if (!(glm::dot(d, d) < least)) continue;
      least = glm::dot(d, d);
      nearest = entry->corner;
    }
  };
  // Triangles may be longer than cells.
  for (int reach = 1; reach < kCells && std::isinf(least); reach *= 2) {
    for (int x = -reach; x <= reach; ++x) {
      for (int y = -reach; y <= reach; ++y) {
        for (int z = -reach; z <= reach; ++z) look_in(cell_of(p, {x, y, z}));
      }
    }
  }
  return nearest;
}

}  // namespace saddle
