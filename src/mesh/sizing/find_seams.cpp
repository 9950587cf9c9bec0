#include "mesh/sizing/find_seams.h"

#include <array>
#include <vector>

#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// The places at which edges are compared, in parts of their lengths.
constexpr std::array kComparedAt = {0.07, 0.19, 0.41, 0.83};

bool is_near(const dvec3& a, const dvec3& b, double diagonal) {
  return glm::distance(a, b) <= kSamePosition * diagonal;  // false for NaN
}

Seam find_seam(const Surface& surface, double diagonal, bool along_v) {
  std::vector<dvec2> uv;
  const auto add = [&](double end, double along) {
    uv.push_back(surface.domain.at(along_v ? dvec2(end, along) : dvec2(along, end)));
  };
  for (const double along : kComparedAt) {
    add(0, along);
    for (const Seam& seam : kSeams) add(1, seam.partner(along, 1.0));
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
  for (std::size_t kind = 0; kind < kSeams.size(); ++kind) {
    const auto meets = [&](std::size_t place) {
      const std::size_t first = place * (1 + kSeams.size());
      return is_near(points[first].position, points[first + 1 + kind].position, diagonal);
    };
    if (meets(0) && meets(1) && meets(2) && meets(3)) return kSeams[kind];
  }
  return {};
}

/// Whether each half of an edge lies on the other. An edge that is a point is not folded.
bool is_folded(const Surface& surface, double diagonal, bool along_v, double end) {
  std::vector<dvec2> uv;
  for (const double along : kComparedAt) {
    for (const double at : {along, kFold.partner(along, 1.0)}) {
      uv.push_back(surface.domain.at(along_v ? dvec2(end, at) : dvec2(at, end)));
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
  bool is_point = true;
  for (std::size_t k = 0; k < points.size(); k += 2) {
    if (!is_near(points[k].position, points[k + 1].position, diagonal)) return false;
    is_point = is_point && is_near(points[k].position, points[0].position, diagonal);
  }
  return !is_point;
}

}  // namespace

Seams find_seams(const Surface& surface, double diagonal) {
  Seams seams;
  seams.u = find_seam(surface, diagonal, true);
  seams.v = find_seam(surface, diagonal, false);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto end = static_cast<double>(k);
    seams.folded_u[k] = !seams.u.closed && is_folded(surface, diagonal, true, end);
    seams.folded_v[k] = !seams.v.closed && is_folded(surface, diagonal, false, end);
  }
  return seams;
}

}  // namespace saddle
