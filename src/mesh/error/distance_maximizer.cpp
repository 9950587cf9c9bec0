#include "mesh/error/distance_maximizer.h"

#include <algorithm>

namespace saddle {

namespace {

/// What is foreseen is worth a look if it is more than is allowed: of a smooth surface it is right
/// to a few hundredths, and tests know as much; or if it is this much of that and more than so many
/// times what tests know.
constexpr double kWorthALook = 0.95;
constexpr double kMoreThanKnown = 1.02;
/// Looks at most, the first one where the climb begins.
constexpr int kLooks = 5;

}  // namespace

bool is_worth_a_look(const ValidatedMesh& mesh, std::size_t leaf, double predicted) {
  const double known = mesh.leaves[leaf].known_error;
  const double share = std::clamp(kMoreThanKnown * known, kWorthALook, 1.0);
  return mesh.off(leaf) <= 1 && predicted > share * mesh.allowed[leaf];
}

/// Goes on from where a leaf is farther off, and half of the way back from where it is not.
void DistanceMaximizer::look(ValidatedMesh& mesh) {
  std::vector<dvec2> uv;
  for (const DistanceMaximum& maximum : maximizer_) uv.push_back(maximum.predicted.uv);
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += points.size();
  for (std::size_t k = 0; k < points.size(); ++k) {
    DistanceMaximum& maximum = maximizer_[k];
    const dvec3& p = points[k].position;
    const auto& t = maximum.triangles;
    const Seen seen = seen_at(clip_, grid_, t, uv[k], p);
    if (!seen.surface && !seen.triangles) continue;
    const double there = seen.triangles
                             ? sampled_error(grid_, t, uv[k], points[k], surface_.flip).distance
                             : distance_from(grid_, t, uv[k], p);
    mesh.add(maximum.leaf, there);
    if (there > maximum.distance) {
      maximum.uv = uv[k];
      maximum.distance = there;
      maximum.predicted = predict(grid_, t, uv[k], points[k], surface_.flip);
    } else {
      maximum.predicted.uv = 0.5 * (maximum.uv + uv[k]);
    }
  }
}

void DistanceMaximizer::climb(ValidatedMesh& mesh) {
  const auto is_done = [&](const DistanceMaximum& maximum) {
    return mesh.off(maximum.leaf) > 1 ||
           (maximum.distance >= 0 &&
            !is_worth_a_look(mesh, maximum.leaf, maximum.predicted.distance));
  };
  for (int step = 0; step < kLooks; ++step) {
    std::erase_if(maximizer_, is_done);
    if (maximizer_.empty()) return;
    look(mesh);
  }
}

}  // namespace saddle
