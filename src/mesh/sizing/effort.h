// The effort of meshing, counted in evaluations where they are made. It does not depend on time, so
// that a mesh is the same on any machine.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "surface/surface.h"

namespace saddle {

/// Budget for each triangle that a mesh may have, in places. A smooth surface needs 8.
inline constexpr std::size_t kPlacesPerTriangle = 8;
/// The least budget: a quarter of a second.
inline constexpr std::size_t kLeastEffort = 1'000'000;
/// Places for a vertex or a sample of a leaf: validation takes about as many points again.
inline constexpr std::size_t kPlacesPerSample = 2;
/// Places for keeping an edge feature of a side.
inline constexpr std::size_t kPlacesPerDiscontinuity = 15;

/// The budget of a mesh with a limit of triangles, in places.
inline constexpr std::size_t most_effort(std::size_t max_triangles,
                                         std::size_t least = kLeastEffort) {
  return std::max(least, kPlacesPerTriangle * max_triangles);
}
/// The share of searches and proofs that a surface may have whatever its mesh takes: all of them,
/// unless it is one of so many surfaces that they share the least budget.
inline constexpr double share_of_searches(std::size_t least_effort) {
  return std::min(1.0, static_cast<double>(least_effort) / static_cast<double>(kLeastEffort));
}
/// A surface may be computed at so many times its mesh's budget of places: with all checks,
/// searches and meshes that are made anew.
inline constexpr std::size_t kPlacesWithChecks = 5;

/// The unit is a place: an evaluation of the surface, with its share of error estimation,
/// validation and triangulation. For a short formula it takes a quarter of a microsecond.
class Effort {
 public:
  explicit Effort(const Surface& surface);

  /// The cost of a place of this surface, in places of a short formula.
  double place() const { return place_; }
  /// Whether all points are used up that the surface may be computed at.
  bool is_used_up() const { return count_ && count_->is_used_up(); }

  void add_places(std::size_t count) { places_ += count; }
  void add_samples(std::size_t count) { places_ += kPlacesPerSample * count; }
  void add_discontinuities(std::size_t count) { places_ += kPlacesPerDiscontinuity * count; }
  /// Points and boxes in searches for edge features. Their cost grows with the formula.
  std::size_t& looks() { return looks_; }
  std::size_t looks() const { return looks_; }

  /// Places spent on searches, and on everything.
  std::size_t search() const {
    return static_cast<std::size_t>(look_ * static_cast<double>(looks_));
  }
  std::size_t total() const {
    return static_cast<std::size_t>(place_ * static_cast<double>(places_)) + search();
  }

 private:
  double place_, look_;  ///< cost of one, in places
  std::shared_ptr<const PointCount> count_;
  std::size_t places_ = 0;
  std::size_t looks_ = 0;
};

}  // namespace saddle
