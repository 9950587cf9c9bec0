#include "export/page/page_description.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "mesh/model/topology.h"

namespace saddle {
namespace {

/// Longer lists are no help to listeners.
constexpr std::size_t kMostDescribed = 4;
/// Meshes end within their tolerance.
constexpr int kExtentDigits = 2;

std::string kind_of(const Mesh& mesh) {
  const Topology t = topology(mesh);
  std::string kind = t.orientable ? "" : "one-sided ";
  if (t.is_closed()) return "closed " + kind + "surface";
  kind += "surface";
  if (t.components > 1) return kind + " of " + std::to_string(t.components) + " parts";
  if (t.boundary_loops == 1) return kind + " with one boundary";
  if (t.boundary_loops > 1) {
    return kind + " with " + std::to_string(t.boundary_loops) + " boundaries";
  }
  return kind;
}

std::string extents(const Bounds& bounds) {
  std::string text;
  for (int k = 0; k < 3; ++k) {
    const auto number = [&](double x) {
      const double size = std::max(std::abs(bounds.low[k]), std::abs(bounds.high[k]));
      return rounded(std::abs(x) < 1e-9 * size ? 0 : x, kExtentDigits);
    };
    text += std::string(k == 0 ? "" : ", ") + "xyz"[k] + " from " + number(bounds.low[k]) + " to " +
            number(bounds.high[k]);
  }
  return text;
}

}  // namespace

std::string description_of(const PageContent& content) {
  std::string text;
  std::size_t count = 0;
  const bool is_one = content.meshes.size() == 1;
  for (std::size_t i = 0; i < content.meshes.size(); ++i) {
    const Mesh& mesh = content.meshes[i];
    const SurfaceSpec& spec = content.seen.surfaces[i];
    if (++count > kMostDescribed) continue;
    const std::string kind = spec.is_stroke() ? (spec.point ? "point" : "curve") : kind_of(mesh);
    text += (text.empty() ? "" : " ") +
            (is_one ? "A " + kind : spec.name + (spec.name == kind ? "" : ", a " + kind)) + ": " +
            extents(mesh.bounds) + ".";
  }
  if (count > kMostDescribed) {
    text += " " + std::to_string(count - kMostDescribed) + " more.";
  }
  return text;
}

}  // namespace saddle
