#include "mesh/features/way_out.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/common.hpp>

#include "base/parallel.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// Where a line is halved: where a parameter is 0, while one has both signs. Doubles are so close
/// there that no number of halvings ends at 0, where many formulas end.
dvec2 middle_or_zero(const Line& line) {
  for (int k = 0; k < 2; ++k) {
    if (!(line[0][k] * line[1][k] < 0)) continue;
    dvec2 place = line[0] + line[0][k] / (line[0][k] - line[1][k]) * (line[1] - line[0]);
    place[k] = 0;
    return place;
  }
  return middle_of(line);
}

/// How far a position is beyond the faces of a box: less than 0 within it, and a NaN without a box
/// or where that is not finite.
double beyond_faces(const std::optional<Bounds>& box, const dvec3& p) {
  if (!box || !is_finite(p)) return kNan;
  double beyond = -kInfinity;
  for (int k = 0; k < 3; ++k) beyond = std::max({beyond, box->low[k] - p[k], p[k] - box->high[k]});
  return std::isfinite(beyond) ? beyond : kNan;
}

}  // namespace

WayOut::WayOut(const Line& line, int halvings, const std::optional<Bounds>& box)
    : line_(line), box_(box), looks_left_(halvings), part_(std::ldexp(1.0, -halvings)) {
  const dvec2 way = glm::abs(line[1] - line[0]);
  axis_ = way.x > way.y ? 0 : 1;
}

dvec2 WayOut::next() const {
  // A line may begin at the face.
  if (!is_first_known_ && !std::isnan(beyond_[1])) return line_[0];
  const dvec2 middle = middle_or_zero(line_);
  if (std::isnan(beyond_[0] + beyond_[1]) || !(width_ > 0)) return middle;
  const double least = least_share(line_);
  if (!(least < 0.5)) return middle;
  const double share = share_of_zero(beyond_[0], beyond_[1], width_, widest_);
  const dvec2 place = line_[0] + std::clamp(share, least, 1 - least) * (line_[1] - line_[0]);
  return place == line_[0] || place == line_[1] ? middle : place;
}

bool WayOut::narrow(const dvec2& place, const dvec3& position) {
  const std::size_t end = is_seen(box_, position) ? 0 : 1;
  const bool is_first = !is_first_known_ && place == line_[0] && end == 0;
  const bool is_last = !is_first && (place == line_[0] || place == line_[1]);
  const double whole = line_[end][axis_] - line_[1 - end][axis_];
  width_ *= (place[axis_] - line_[1 - end][axis_]) / whole;
  if (!is_first) widest_ *= 0.5;
  line_[end] = place;
  beyond_[end] = beyond_faces(box_, position);
  is_first_known_ = is_first_known_ || end == 0;
  return is_last || width_ < part_ || --looks_left_ == 0;
}

std::vector<dvec2> leave(const Surface& surface, std::span<const WayOut> ways, unsigned threads) {
  std::vector<dvec2> last(ways.size());
  parallel_chunks(ways.size(), kInBatch / 2, threads, [&](std::size_t begin, std::size_t end) {
    const auto some = ways.subspan(begin, end - begin);
    std::vector<WayOut> searches(some.begin(), some.end());
    std::vector<std::size_t> open = all_open(searches.size());
    bisect_together(surface, searches, open, {kHalvingsToLeast}, std::mem_fn(&WayOut::next),
                    std::mem_fn(&WayOut::narrow));
    std::ranges::transform(searches, last.begin() + static_cast<std::ptrdiff_t>(begin),
                           &WayOut::last_seen);
  });
  return last;
}

}  // namespace saddle
