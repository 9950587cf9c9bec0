#include "surface/defined_share.h"

#include <algorithm>
#include <array>
#include <deque>
#include <span>
#include <vector>

#include <glm/common.hpp>

#include "eval/enclose.h"

namespace saddle {

namespace {

/// Places each way at which exceeds_doubles() looks: what is too large there is a wide part.
constexpr int kPlaces = 32;

struct Box {
  dvec2 low, high;  ///< in parts of the domain
  double area() const { return (high.x - low.x) * (high.y - low.y); }
};

Defined defined(std::span<const Interval> position) {
  Defined all = Defined::Yes;
  for (const Interval& coordinate : position) all = std::min(all, coordinate.defined);
  return all;
}

}  // namespace

DefinedShare prove_defined(const Surface& surface, std::size_t boxes) {
  const Domain& d = surface.domain;
  const auto range = [](double first, double last, double low, double high) {
    const double a = first * (1 - low) + last * low;
    const double b = first * (1 - high) + last * high;
    return range_between(a, b);
  };
  Enclosure enclosure(surface.bounds, 3);
  std::array<Interval, 3> position;
  DefinedShare share;
  std::deque<Box> undecided = {{dvec2(0), dvec2(1)}};
  for (std::size_t k = 0; k < boxes && !undecided.empty(); ++k) {
    const Box box = undecided.front();
    undecided.pop_front();
    enclosure(range(d.u0, d.u1, box.low.x, box.high.x), range(d.v0, d.v1, box.low.y, box.high.y),
              position);
    const Defined found = defined(position);
    if (found == Defined::Yes) share.yes += box.area();
    if (found == Defined::No) share.no += box.area();
    if (found != Defined::Maybe) continue;
    Box a = box;
    Box b = box;
    const int axis = box.high.x - box.low.x >= box.high.y - box.low.y ? 0 : 1;
    a.high[axis] = b.low[axis] = 0.5 * (box.low[axis] + box.high[axis]);
    undecided.push_back(a);
    undecided.push_back(b);
  }
  share.everywhere = undecided.empty() && share.no == 0;
  return share;
}

bool exceeds_doubles(const Surface& surface, unsigned threads) {
  const Domain& d = surface.domain;
  std::vector<dvec2> uv;
  for (int j = 0; j < kPlaces; ++j) {
    for (int i = 0; i < kPlaces; ++i) {
      const dvec2 share = (dvec2(i, j) + 0.5) / static_cast<double>(kPlaces);
      uv.push_back(glm::mix(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1), share));
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  Enclosure enclosure(surface.bounds, 3);
  std::array<Interval, 3> position;
  bool exceeds = false;
  for (std::size_t k = 0; k < uv.size(); ++k) {
    if (is_finite(points[k].position)) continue;
    enclosure(range_between(uv[k].x, uv[k].x), range_between(uv[k].y, uv[k].y), position);
    if (defined(position) != Defined::Yes) return false;
    exceeds = true;
  }
  return exceeds;
}

}  // namespace saddle
