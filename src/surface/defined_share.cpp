#include "surface/defined_share.h"

#include <span>
#include <vector>

#include <glm/common.hpp>

#include "surface/box_subdivision.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Places each way at which exceeds_doubles() looks: it finds only wide parts.
constexpr int kPlaces = 32;

/// Open boxes of a level at which a proof of continuity gives up: those along a jump double.
constexpr std::size_t kMostDiscontinuous = 1024;

/// Halvings to the end of an undefined part: a millionth of it.
constexpr int kHalvingsToEnd = 20;

double area_of(const ParameterBox& box) {
  return box.size().x * box.size().y;
}

bool is_defined_at(const Surface& surface, const dvec2& place) {
  const dvec2 uv = surface.domain.at(place);
  return is_finite(evaluate_positions(surface, std::span(&uv, 1), 1)[0]);
}

/// How far from a place its part of the domain is undefined along an axis. Steps of `first`, then
/// of twice as much each, lead out of the part, and halvings back to its end.
double undefined_until(const Surface& surface, dvec2 place, int axis, double first) {
  const auto is_undefined_at = [&](double at) {
    place[axis] = at;
    return !is_defined_at(surface, place);
  };
  double inside = place[axis];
  double outside = inside;
  for (double step = first;; step *= 2) {
    outside = glm::clamp(inside + step, 0.0, 1.0);
    if (!is_undefined_at(outside)) break;
    inside = outside;
    if (outside == 0 || outside == 1) return outside;
  }
  for (int k = 0; k < kHalvingsToEnd; ++k) {
    const double middle = 0.5 * (inside + outside);
    (is_undefined_at(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// The middle of the undefined part around a box that is proved undefined: of its chords along u
/// and v, each through the middle of the one before.
dvec2 middle_of_undefined(const Surface& surface, const ParameterBox& box) {
  dvec2 place = box.middle();
  for (const int axis : {0, 1, 0, 1}) {
    const double size = box.size()[axis];
    dvec2 middle = place;
    middle[axis] = 0.5 * (undefined_until(surface, place, axis, -size) +
                          undefined_until(surface, place, axis, size));
    if (is_defined_at(surface, middle)) break;
    place = middle;
  }
  return surface.domain.at(place);
}

/// Whether boxes prove that a surface has neither a jump nor a pole.
bool prove_continuous(const Surface& surface, std::size_t boxes) {
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  const auto search = subdivide(
      box_of(surface.domain), {.boxes = boxes, .most_open = kMostDiscontinuous},
      [&](const ParameterBox& box) {
        return are_continuous(enclosure.enclose(box)) ? ProofOutcome::Proved : ProofOutcome::Open;
      });
  return search.open().empty();
}

}  // namespace

DefinedShare prove_defined(const Surface& surface, std::size_t boxes) {
  const Domain& d = surface.domain;
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  DefinedShare share;
  bool may_jump = false;
  const ParameterBox whole = {dvec2(0), dvec2(1)};  // in parts of the domain
  const auto search = subdivide(whole, {.boxes = boxes}, [&](const ParameterBox& part) {
    const auto bounds = enclosure.enclose({d.at(part.low), d.at(part.high)});
    switch (least_defined(bounds)) {
      case Defined::Yes:
        share.yes += area_of(part);
        may_jump = may_jump || !are_continuous(bounds);
        return ProofOutcome::Proved;
      case Defined::No:
        share.no += area_of(part);
        // The first is the largest: a level is tested before its boxes' halves.
        if (!share.undefined_at) share.undefined_at = middle_of_undefined(surface, part);
        return ProofOutcome::Refuted;
      case Defined::Maybe:
        return ProofOutcome::Open;
    }
    return ProofOutcome::Open;
  });
  share.everywhere = search.open().empty() && share.no == 0;
  if (!search.open().empty()) share.undecided_at = d.at(search.open().front().middle());
  share.continuous = share.everywhere && (!may_jump || prove_continuous(surface, boxes));
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
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  bool exceeds = false;
  for (std::size_t k = 0; k < uv.size(); ++k) {
    if (is_finite(points[k].position)) continue;
    if (least_defined(enclosure.enclose({uv[k], uv[k]})) != Defined::Yes) return false;
    exceeds = true;
  }
  return exceeds;
}

}  // namespace saddle
