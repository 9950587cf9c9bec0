// What making a mesh takes, counted where it is done: in one currency, and never in time, so that a
// mesh is the same on any machine.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "surface/surface.h"

namespace saddle {

/// Places that a mesh may take for each triangle that it may have. A smooth surface takes eight.
inline constexpr std::size_t kPlacesPerTriangle = 8;
/// Any mesh may take so many, which is a quarter of a second.
inline constexpr std::size_t kLeastEffort = 1'000'000;
/// A vertex or a sample of a leaf is paid for twice: leaves are measured after they are halved, on
/// about as many places.
inline constexpr std::size_t kPlacesPerSample = 2;
/// What keeping a cut of a side takes, in places.
inline constexpr std::size_t kPlacesPerDiscontinuity = 15;

/// Places that a mesh of so many triangles may take; one that is not refined at all has as many
/// sides as it has.
inline constexpr std::size_t most_effort(std::size_t max_triangles) {
  if (max_triangles == 0) return SIZE_MAX;
  return std::max(kLeastEffort, kPlacesPerTriangle * max_triangles);
}

/// The unit is a place: a point at which the surface was computed, with all that a mesh does with
/// it, of leaves that are judged, measured and triangulated. For a short formula that is a quarter
/// of a microsecond.
class Effort {
 public:
  explicit Effort(const Surface& surface);

  void add_places(std::size_t count) { places_ += count; }
  void add_samples(std::size_t count) { places_ += kPlacesPerSample * count; }
  void add_discontinuities(std::size_t count) { places_ += kPlacesPerDiscontinuity * count; }
  /// Points and boxes that are looked at in search of what cuts sides. Those of long formulas and
  /// special functions are dear.
  std::size_t& looks() { return looks_; }
  std::size_t looks() const { return looks_; }

  /// Of looks alone, and all.
  std::size_t search() const {
    return static_cast<std::size_t>(look_ * static_cast<double>(looks_));
  }
  std::size_t total() const {
    return static_cast<std::size_t>(place_ * static_cast<double>(places_)) + search();
  }

 private:
  double place_, look_;  ///< what one takes
  std::size_t places_ = 0;
  std::size_t looks_ = 0;
};

}  // namespace saddle
