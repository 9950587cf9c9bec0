// Interval bounds of a surface and its derivatives over boxes of parameters.
// Source: J. Tupper, "Reliable two-dimensional graphing methods for mathematical formulae with two
// free variables", 2001.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/bounds.h"
#include "eval/enclose.h"
#include "surface/parameter_box.h"
#include "surface/surface.h"

namespace saddle {

/// Number of leading outputs of Surface::bounds.
enum class Bounded : std::uint8_t {
  Position = 3,            ///< r
  Tangents = 9,            ///< r, r_u, r_v
  SecondDerivatives = 18,  ///< r, r_u, r_v, r_uu, r_uv, r_vv
};

/// Bounds of a surface of second order. One for each thread.
class SurfaceEnclosure {
 public:
  SurfaceEnclosure(const Surface& surface, Bounded outputs)
      : enclosure_(surface.bounds, static_cast<std::size_t>(outputs)),
        outputs_(static_cast<std::size_t>(outputs)) {}

  /// Three bounds (x, y, z) for each vector. They are valid until the next call.
  std::span<const Interval> enclose(const ParameterBox& box) {
    enclosure_(range_between(box.low.x, box.high.x), range_between(box.low.y, box.high.y),
               outputs_);
    return outputs_;
  }
  /// Enclosure::count_breaks()
  std::size_t count_breaks(const ParameterBox& box) {
    return enclosure_.count_breaks(range_between(box.low.x, box.high.x),
                                   range_between(box.low.y, box.high.y));
  }
  /// Enclosure::count_breaks_of_both()
  std::size_t count_breaks_of_both(const ParameterBox& box) {
    return enclosure_.count_breaks_of_both(range_between(box.low.x, box.high.x),
                                           range_between(box.low.y, box.high.y));
  }
  /// Enclosure::count_breaks_of_one()
  std::size_t count_breaks_of_one(int axis, double from, double to) {
    return enclosure_.count_breaks_of_one(axis, range_between(from, to));
  }
  /// The cost of a box, in additions.
  std::size_t steps() const { return enclosure_.steps(); }
  /// The bounds of the last box.
  std::span<const Interval> last() const { return outputs_; }

 private:
  Enclosure enclosure_;
  std::vector<Interval> outputs_;
};

/// Enclosures for loops on several threads: one for each, as to make one is dear.
class SurfaceEnclosures {
 public:
  /// The surface must outlive this.
  SurfaceEnclosures(const Surface& surface, Bounded outputs)
      : surface_(surface), outputs_(outputs) {}

  /// Calls body(enclosure, begin, end) for chunks as parallel_chunks() does.
  void in_chunks(std::size_t count, std::size_t chunk, unsigned threads,
                 const std::function<void(SurfaceEnclosure& enclosure, std::size_t begin,
                                          std::size_t end)>& body);
  /// One that is not in use.
  std::unique_ptr<SurfaceEnclosure> take();
  void give_back(std::unique_ptr<SurfaceEnclosure> enclosure);

 private:
  const Surface& surface_;
  Bounded outputs_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<SurfaceEnclosure>> free_;
};

/// Proved: all are defined in the whole box, without a jump or a pole.
bool are_continuous(std::span<const Interval> bounds);

/// The least that is proved of any: `No` if one is defined nowhere in the box.
Defined least_defined(std::span<const Interval> bounds);

/// The box in space around the bounds of x, y and z, the first three.
Bounds hull_of(std::span<const Interval> bounds);

/// The boxes in space around a surface over boxes of parameters. Several searches look at the same
/// leaves: for a long formula each box is enclosed once, but for those of a fine mesh. The surface
/// must outlive this.
class KnownHulls {
 public:
  explicit KnownHulls(const Surface& surface) : enclosures_(surface, Bounded::Position) {}

  std::vector<Bounds> over(std::span<const ParameterBox> boxes, unsigned threads);

 private:
  /// They take 7 MB.
  static constexpr std::size_t kMostKnown = std::size_t{1} << 16;
  /// A formula of fewer steps is computed in the time that it takes to keep a result: memory is
  /// far.
  static constexpr std::size_t kStepsToKeep = 100;

  SurfaceEnclosures enclosures_;
  std::optional<bool> keeps_;  // known from the first boxes on
  struct HashOfBox {
    std::size_t operator()(const std::array<double, 4>& box) const;
  };
  std::unordered_map<std::array<double, 4>, Bounds, HashOfBox> known_;
};

/// By how much bounds of a surface exceed a box around points of it; infinite without bounds.
double room_beyond(const Bounds& points, const Bounds& bounds);

}  // namespace saddle
