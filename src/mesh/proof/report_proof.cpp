#include "mesh/proof/report_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "base/bounds.h"
#include "base/numbers.h"
#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// A feature of more than 3 tolerances is visible. Bounds of a smooth surface exceed its samples by
/// less over most boxes.
constexpr double kVisibleRoom = 3;

/// A gap's middle and corners.
std::array<dvec2, 5> places_in(const ProofGap& gap) {
  return {0.5 * gap.low + 0.5 * gap.high,
          gap.low,
          {gap.high.x, gap.low.y},
          gap.high,
          {gap.low.x, gap.high.y}};
}

/// The extent of a box along the parameter of which it is the smaller share.
double narrow_side(const dvec2& size, const dvec2& range) {
  const dvec2 share = size / range;
  return share.x <= share.y ? size.x : size.y;
}

}  // namespace

void measure_gaps(const Surface& surface, const dvec2& largest_cell, double tolerance,
                  unsigned threads, KnownHulls& hulls, std::span<ProofGap> gaps) {
  std::vector<dvec2> uv;
  std::vector<ParameterBox> boxes;
  for (const ProofGap& gap : gaps) {
    const auto places = places_in(gap);
    uv.insert(uv.end(), places.begin(), places.end());
    boxes.push_back({gap.low, gap.high});
  }
  const std::vector<dvec3> points = evaluate_positions(surface, uv, threads);
  const dvec2 range = box_of(surface.domain).size();
  const std::vector<Bounds> bounds = hulls.over(boxes, threads);
  auto next = points.begin();
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    ProofGap& gap = gaps[k];
    const ParameterBox& box = boxes[k];
    const dvec2 size = box.size();
    Bounds samples;
    const auto end = next + static_cast<std::ptrdiff_t>(places_in(gap).size());
    for (const dvec3& p : std::span(std::exchange(next, end), end)) {
      if (is_finite(p)) samples.add(p);
    }
    gap.share = size.x * size.y / (range.x * range.y);
    gap.room = samples.empty() ? kInfinity : room_beyond(samples, bounds[k]);
    if (gap.room > kVisibleRoom * tolerance) {
      gap.visible = gap.share;
      gap.width = narrow_side(glm::min(size, largest_cell), range);
    }
    gap.worst = box.middle();
  }
}

void ProvedCells::add(const dvec2& size, const dvec2& range) {
  covered += size.x * size.y / (range.x * range.y);
  largest = glm::max(largest, size);
}

void report_proof(const Surface& surface, const ProvedCells& cells, unsigned threads,
                  KnownHulls& hulls, const Certification& proof, MeshReport& report) {
  double open = 0;
  MergedGaps merged(surface.domain);
  for (std::span<const GapBox> rest = proof.proof_gaps; !rest.empty();) {
    std::vector<ProofGap> gaps;
    for (const GapBox& box : rest.first(std::min(kKeptAtATime, rest.size()))) gaps.push_back({box});
    rest = rest.subspan(gaps.size());
    measure_gaps(surface, cells.largest, report.tolerance.value_or(kInfinity), threads, hulls,
                 gaps);
    for (const ProofGap& gap : gaps) {
      open += gap.share;
      merged.add(gap);
    }
  }
  report.certified = proof.proof_gaps.empty();
  report.proved_fraction = std::clamp(cells.covered - open, 0.0, 1.0);
  if (report.proved_fraction > 1 - kSame && report.certified) report.proved_fraction = 1;
  report.proof_gaps = merged.take();
  if (report.certified && !report.is_clipped && report.tolerance &&
      proof.bound <= *report.tolerance) {
    report.max_error = std::max(report.max_error, proof.bound);
    report.error_is_bound = report.max_error <= *report.tolerance;
  }
}

}  // namespace saddle
