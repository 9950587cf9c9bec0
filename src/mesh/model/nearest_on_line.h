// The point of the surface over a line of parameters that is nearest to a point in space.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "base/vec.h"

namespace saddle {

/// A branch and bound over samples of the line: the part whose chord is nearest is halved. A chord
/// is no bound, but that of a steep wall is nearly the wall.
class NearestOnLine {
 public:
  /// The line `start` + t * `way`. `target`: the point in space.
  NearestOnLine(const dvec3& target, const dvec2& start, const dvec2& way)
      : target_(target), start_(start), way_(way) {}

  dvec2 uv(double t) const { return start_ + t * way_; }
  /// The least distance of a sample; infinite without any.
  double distance() const { return distance_; }
  /// Where that sample is.
  dvec2 nearest() const { return uv(nearest_); }

  /// Makes room for so many samples.
  void reserve(std::size_t count) { samples_.reserve(count); }
  /// Takes a sample. Skips one where the surface is undefined.
  void add(double t, const dvec3& position);

  /// The next t to sample: the middle of a part longer than `shortest`, in space, whose chord is
  /// nearer than all samples; else of the longer one beside the nearest sample, where a ridge may
  /// rise between samples. Nothing if there is none.
  std::optional<double> next(double shortest);

 private:
  struct Chord {
    double length;
    double distance;  ///< from the target
  };
  struct Sample {
    double t;
    dvec3 position;
    std::optional<Chord> chord = {};  ///< to the next sample; not known at first
  };
  dvec3 target_;
  dvec2 start_, way_;
  std::vector<Sample> samples_;  // ascending t
  double distance_ = std::numeric_limits<double>::infinity();
  double nearest_ = 0;
};

}  // namespace saddle
