#include "surface/defined_share.h"

#include <vector>

#include <glm/common.hpp>

#include "surface/box_subdivision.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Places each way at which exceeds_doubles() looks: it finds only wide parts.
constexpr int kPlaces = 32;

double area_of(const ParameterBox& box) {
  return box.size().x * box.size().y;
}

}  // namespace

DefinedShare prove_defined(const Surface& surface, std::size_t boxes) {
  const Domain& d = surface.domain;
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  DefinedShare share;
  const ParameterBox whole = {dvec2(0), dvec2(1)};  // in parts of the domain
  const auto search = subdivide(whole, {.boxes = boxes}, [&](const ParameterBox& part) {
    switch (least_defined(enclosure.enclose({d.at(part.low), d.at(part.high)}))) {
      case Defined::Yes:
        share.yes += area_of(part);
        return ProofOutcome::Proved;
      case Defined::No:
        share.no += area_of(part);
        return ProofOutcome::Refuted;
      case Defined::Maybe:
        return ProofOutcome::Open;
    }
    return ProofOutcome::Open;
  });
  share.everywhere = search.open().empty() && share.no == 0;
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
