#include "mesh/model/nearest_on_line.h"

#include <algorithm>
#include <iterator>

#include "mesh/model/segment.h"

namespace saddle {

void NearestOnLine::add(double t, const dvec3& position) {
  if (!is_finite(position)) return;
  if (const double distance = glm::distance(target_, position); distance < distance_) {
    distance_ = distance;
    nearest_ = t;
  }
  const auto place =
      samples_.insert(std::ranges::lower_bound(samples_, t, {}, &Sample::t), Sample{t, position});
  if (place != samples_.begin()) std::prev(place)->chord.reset();
}

std::optional<double> NearestOnLine::next(double shortest) {
  double nearest = distance_;
  std::optional<double> middle;
  double longest = shortest;
  std::optional<double> beside;  // the nearest sample
  for (std::size_t k = 0; k + 1 < samples_.size(); ++k) {
    Sample& a = samples_[k];
    const Sample& b = samples_[k + 1];
    if (!a.chord) {
      a.chord = {glm::distance(a.position, b.position),
                 distance_from_segment(a.position, b.position, target_)};
    }
    const auto [length, distance] = *a.chord;
    const double t = 0.5 * (a.t + b.t);
    if (!(a.t < t && t < b.t) || length <= shortest) continue;
    if ((a.t == nearest_ || b.t == nearest_) && length > longest) {
      longest = length;
      beside = t;
    }
    if (distance >= nearest) continue;
    nearest = distance;
    middle = t;
  }
  return middle ? middle : beside;
}

}  // namespace saddle
