#include "mesh/error/distance_maximizer.h"

#include <algorithm>

#include <glm/common.hpp>

#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// A predicted distance is evaluated above the tolerance, or above 0.95 of it where it matters
/// beside the error estimate. On a smooth surface, prediction and estimate are right to a few per
/// cent.
constexpr double kLeastShare = 0.95;
/// Evaluations of a place at most; the first is where the climb starts.
constexpr int kMostSteps = 5;

}  // namespace

bool may_be_missed(const ValidatedMesh& mesh, std::size_t leaf, double predicted) {
  const double known = mesh.leaves[leaf].known_error;
  const double share = std::clamp(kMatters * known, kLeastShare, 1.0);
  return mesh.error_ratio(leaf) <= 1 && predicted > share * mesh.allowed[leaf];
}

bool is_missed_from_centre(const ValidatedMesh& mesh, std::size_t leaf, const LeafCentre& centre,
                           std::span<const Triangle> triangles, const Grid& grid) {
  return std::ranges::any_of(triangles, [&](const Triangle& t) {
    const Predicted predicted =
        predict(grid, std::span(&t, 1), centre.uv, centre.position, centre.normal);
    return may_be_missed(mesh, leaf, predicted.distance);
  });
}

void DistanceMaximizer::add_places(std::size_t leaf, std::span<const Triangle> triangles,
                                   const TwoTriangles& measured) {
  for (const dvec2& part : measured.places)
    add(leaf, triangles, glm::mix(measured.low, measured.high, part));
}

/// Moves on to a predicted place that is farther from the surface; half of the way back else.
void DistanceMaximizer::evaluate_predicted(ValidatedMesh& mesh) {
  std::vector<dvec2> uv;
  for (const Ascent& ascent : ascents_) uv.push_back(ascent.predicted.uv);
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += points.size();
  for (std::size_t k = 0; k < points.size(); ++k) {
    Ascent& ascent = ascents_[k];
    const dvec3& p = points[k].position;
    const auto& t = ascent.triangles;
    const Seen seen = seen_at(clip_, grid_, t, uv[k], p);
    if (!seen.surface && !seen.triangles) continue;
    const double there = seen.triangles
                             ? sampled_error(grid_, t, uv[k], points[k], surface_.flip).distance
                             : distance_from(grid_, t, uv[k], p);
    mesh.add(ascent.leaf, there, uv[k]);
    if (there > ascent.distance) {
      ascent.uv = uv[k];
      ascent.distance = there;
      ascent.predicted = predict(grid_, t, uv[k], points[k], surface_.flip);
    } else {
      ascent.predicted.uv = 0.5 * (ascent.uv + uv[k]);
    }
  }
}

void DistanceMaximizer::climb(ValidatedMesh& mesh) {
  const auto is_done = [&](const Ascent& ascent) {
    return mesh.error_ratio(ascent.leaf) > 1 ||
           (ascent.distance >= 0 && !may_be_missed(mesh, ascent.leaf, ascent.predicted.distance));
  };
  for (int step = 0; step < kMostSteps; ++step) {
    std::erase_if(ascents_, is_done);
    if (ascents_.empty()) break;
    evaluate_predicted(mesh);
  }
  ascents_.clear();
}

}  // namespace saddle
