// Breadth-first subdivision of boxes of parameters: a level is tested, then each box that is still
// open is halved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "surface/parameter_box.h"

namespace saddle {

/// The result of a test of one part.
enum class ProofOutcome : std::uint8_t { Proved, Refuted, Open };

/// How a box is halved whose sides are neighbours in double precision.
enum class AtLastDigit : std::uint8_t {
  Halve,  ///< one of its halves is a line
  Keep,   ///< it stays whole
};

/// Open parts of one level, in order. A Part is a box, has a member `box`, or is any other value
/// for which the caller has a function that halves it.
template <class Part>
class BoxSubdivision {
 public:
  explicit BoxSubdivision(std::vector<Part> parts) : open_(std::move(parts)) {}

  const std::vector<Part>& open() const { return open_; }
  std::vector<Part>& open() { return open_; }
  int depth() const { return depth_; }  ///< halvings so far

  /// Calls test(part) of each open part, in order, and keeps those that stay open.
  template <class Test>
  void test(Test test) {
    std::size_t kept = 0;
    for (Part& part : open_) {
      if (test(part) == ProofOutcome::Open) open_[kept++] = part;
    }
    open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(kept), open_.end());
  }

  /// Calls halve(part, next) of each open part; it appends what is left of the part to `next`.
  template <class Halve>
  void halve_each(Halve halve) {
    next_.clear();
    for (const Part& part : open_) halve(part, next_);
    open_.swap(next_);
    ++depth_;
  }

  /// Halves all boxes along u (axis 0) or v (axis 1).
  void halve(int axis, AtLastDigit at_last_digit = AtLastDigit::Halve) {
    halve_each([=](const Part& part, std::vector<Part>& next) {
      const ParameterBox& box = box_of_part(part);
      const double middle = box.middle()[axis];
      const bool has_middle = middle != box.low[axis] && middle != box.high[axis];
      if (!has_middle && at_last_digit == AtLastDigit::Keep) {
        next.push_back(part);
        return;
      }
      for (const ParameterBox& half : halves_of(box, axis)) {
        next.push_back(part);
        box_of_part(next.back()) = half;
      }
    });
  }

  /// Along u at depths 0, 2, 4 ..., along v at the others.
  void halve_in_turn(AtLastDigit at_last_digit = AtLastDigit::Halve) {
    halve(depth_ % 2, at_last_digit);
  }

 private:
  template <class Any>
  static auto& box_of_part(Any& part) {
    if constexpr (requires { part.box; }) {
      return part.box;
    } else {
      return part;
    }
  }

  std::vector<Part> open_;
  std::vector<Part> next_;
  int depth_ = 0;
};

/// Where a subdivision ends.
struct SubdivisionLimits {
  std::size_t boxes;                                                ///< tests, in all
  int halvings = std::numeric_limits<int>::max();                   ///< both ways taken together
  std::size_t most_open = std::numeric_limits<std::size_t>::max();  ///< boxes of a level
};

/// Tests a box and its halves, along u and v in turn, until none is open or a limit is reached.
/// The open boxes that are left have been halved `halvings` times, or else another limit came
/// first: then they include boxes that were not tested.
template <class Test>
BoxSubdivision<ParameterBox> subdivide(const ParameterBox& whole, const SubdivisionLimits& limits,
                                       Test test) {
  BoxSubdivision<ParameterBox> search({whole});
  std::size_t budget = limits.boxes;
  while (!search.open().empty() && budget > 0 && search.depth() < limits.halvings) {
    search.test([&](const ParameterBox& box) {
      if (budget == 0) return ProofOutcome::Open;
      --budget;
      return test(box);
    });
    if (search.open().size() > limits.most_open) break;
    search.halve_in_turn(AtLastDigit::Keep);
  }
  return search;
}

}  // namespace saddle
