#include "mesh/error/peaks.h"

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

bool is_worth_a_look(const Measured& mesh, std::size_t leaf, double foreseen) {
  const double known = mesh.leaves[leaf].known_error;
  const double share = std::clamp(kMoreThanKnown * known, kWorthALook, 1.0);
  return mesh.off(leaf) <= 1 && foreseen > share * mesh.allowed[leaf];
}

/// Goes on from where a leaf is farther off, and half of the way back from where it is not.
void Peaks::look(Measured& mesh) {
  std::vector<dvec2> uv;
  for (const Peak& peak : peaks_) uv.push_back(peak.foreseen.uv);
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += points.size();
  for (std::size_t k = 0; k < points.size(); ++k) {
    Peak& peak = peaks_[k];
    const dvec3& p = points[k].position;
    const auto& t = peak.triangles;
    const Seen seen = seen_at(clip_, grid_, t, uv[k], p);
    if (!seen.surface && !seen.triangles) continue;
    const double there = seen.triangles
                             ? deviation(grid_, t, uv[k], points[k], surface_.flip).distance
                             : distance_from(grid_, t, uv[k], p);
    mesh.add(peak.leaf, there);
    if (there > peak.distance) {
      peak.uv = uv[k];
      peak.distance = there;
      peak.foreseen = foresee(grid_, t, uv[k], points[k], surface_.flip);
    } else {
      peak.foreseen.uv = 0.5 * (peak.uv + uv[k]);
    }
  }
}

void Peaks::climb(Measured& mesh) {
  const auto is_done = [&](const Peak& peak) {
    return mesh.off(peak.leaf) > 1 ||
           (peak.distance >= 0 && !is_worth_a_look(mesh, peak.leaf, peak.foreseen.distance));
  };
  for (int step = 0; step < kLooks; ++step) {
    std::erase_if(peaks_, is_done);
    if (peaks_.empty()) return;
    look(mesh);
  }
}

}  // namespace saddle
