#include "mesh/model/mesh_report.h"

#include <bit>
#include <cstddef>

#include "mesh/model/tolerances.h"

namespace saddle {

void add_singular_point(const dvec2& uv, MeshReport& report) {
  auto& listed = report.singular_points;
  // Every second, fourth ... of many points is listed: the first alone could all be of one line.
  const auto stride = [](std::size_t count) { return std::bit_ceil(count / kMaxListed + 1); };
  const std::size_t step = stride(report.singular_point_count);
  const bool is_chosen = report.singular_point_count++ % step == 0;
  if (is_chosen && listed.size() < kMaxListed) listed.push_back({uv});
  if (stride(report.singular_point_count) == step) return;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < listed.size(); ++k) {
    if (k % 2 == 0 || !listed[k].has_limit) listed[kept++] = listed[k];
  }
  listed.resize(kept);
}

void mark_without_limit(MeshReport& report) {
  const bool listed = report.singular_points.size() == report.singular_point_count;
  if (listed) report.singular_points.back().has_limit = false;
}

}  // namespace saddle
