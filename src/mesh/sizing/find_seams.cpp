#include "mesh/sizing/find_seams.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "mesh/features/removable.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {
namespace {

/// The places at which edges are compared, in parts of their lengths.
constexpr std::array kComparedAt = {0.07, 0.19, 0.41, 0.83};

/// Places, and the surface there.
class ComparedPlaces {
 public:
  ComparedPlaces(const Surface& surface, double diagonal, std::vector<dvec2> uv)
      : domain_(surface.domain),
        diagonal_(diagonal),
        uv_(std::move(uv)),
        points_(evaluate(surface, uv_, 1)) {}

  /// Whether two places are one point, within rounding of the parameters.
  bool meet(std::size_t a, std::size_t b) const {
    const dvec3 gap = glm::abs(points_[a].position - points_[b].position);
    if (glm::length(gap) <= kSame * diagonal_) return true;  // false for NaN
    return glm::length(gap) <= kMostRounding * diagonal_ &&
           glm::all(glm::lessThanEqual(gap, rounding(a) + rounding(b)));
  }
  /// Whether the surface has no crease between two places on either side of a seam, if both have a
  /// normal.
  bool share_tangents(std::size_t a, std::size_t b) const {
    const auto first = normal_direction(points_[a]);
    const auto second = normal_direction(points_[b]);
    return !first || !second || glm::length(glm::cross(*first, *second)) <= kClose;
  }
  std::size_t size() const { return uv_.size(); }

 private:
  dvec3 rounding(std::size_t k) const {
    return kSame * diagonal_ + rounding_by_parameters(points_[k], uv_[k], domain_);
  }

  const Domain& domain_;
  double diagonal_;
  std::vector<dvec2> uv_;
  std::vector<SurfacePoint> points_;
};

Seam find_seam(const Surface& surface, double diagonal, bool along_v) {
  std::vector<dvec2> uv;
  const auto add = [&](double end, double along) {
    uv.push_back(surface.domain.at(along_v ? dvec2(end, along) : dvec2(along, end)));
  };
  for (const double along : kComparedAt) {
    add(0, along);
    for (const Seam& seam : kSeams) add(1, seam.partner(along, 1.0));
  }
  const ComparedPlaces places(surface, diagonal, std::move(uv));
  const auto holds_everywhere = [&](std::size_t kind, const auto& holds) {
    return std::ranges::all_of(std::array{0, 1, 2, 3}, [&](std::size_t place) {
      const std::size_t first = place * (1 + kSeams.size());
      return holds(first, first + 1 + kind);
    });
  };
  const auto meet = [&](std::size_t a, std::size_t b) { return places.meet(a, b); };
  const auto are_smooth = [&](std::size_t a, std::size_t b) { return places.share_tangents(a, b); };
  // An edge that lies on itself joins another both ways: the surface goes on along one of them.
  Seam found;
  for (std::size_t kind = 0; kind < kSeams.size(); ++kind) {
    if (!holds_everywhere(kind, meet)) continue;
    if (holds_everywhere(kind, are_smooth)) return kSeams[kind];
    if (!found.closed) found = kSeams[kind];
  }
  return found;
}

/// Whether each half of an edge lies on the other. An edge that is a point is not folded.
bool is_folded(const Surface& surface, double diagonal, bool along_v, double end) {
  std::vector<dvec2> uv;
  for (const double along : kComparedAt) {
    for (const double at : {along, kFold.partner(along, 1.0)}) {
      uv.push_back(surface.domain.at(along_v ? dvec2(end, at) : dvec2(at, end)));
    }
  }
  const ComparedPlaces places(surface, diagonal, std::move(uv));
  bool is_point = true;
  for (std::size_t k = 0; k < places.size(); k += 2) {
    if (!places.meet(k, k + 1)) return false;
    is_point = is_point && places.meet(k, 0);
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
