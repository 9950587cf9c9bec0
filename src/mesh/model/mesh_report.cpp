#include "mesh/model/mesh_report.h"
#include "mesh/model/tolerances.h"

namespace saddle {

void add_singular_point(const dvec2& uv, MeshReport& report) {
  ++report.singular_point_count;
  if (report.singular_points.size() < kMaxListed) report.singular_points.push_back({uv});
}

void mark_without_limit(MeshReport& report) {
  const bool listed = report.singular_points.size() == report.singular_point_count;
  if (listed) report.singular_points.back().has_limit = false;
}

}  // namespace saddle
