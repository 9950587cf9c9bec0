// Evaluates a tape over a box of parameters: bounds of all outputs, and whether they are proved to
// be defined and continuous there.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "eval/interval.h"
#include "eval/tape.h"

namespace saddle {

/// A range of a parameter, in either direction.
inline Interval range_between(double a, double b) {
  return {std::min(a, b), std::max(a, b)};
}

/// One operation on boxes: the function column of the table of operations. Arguments past its arity
/// are ignored.
Interval enclose(Op op, const Interval& a, const Interval& b, const Interval& c);

/// A tape made ready for many boxes. Values of u alone, or of v alone, are computed once for each
/// range of it, as long as those are few: boxes are often cells of grids. Each thread needs its
/// own.
class Enclosure {
 public:
  explicit Enclosure(const Tape& tape) : Enclosure(tape, tape.outputs.size()) {}
  /// Encloses the tape's first outputs alone; the others are not computed.
  Enclosure(const Tape& tape, std::size_t outputs);

  /// outputs[k] encloses output k over u x v. The ends of u and v may be infinite. A product of a
  /// value with itself is a square. Tapes compiled with Powers::Whole give narrower bounds.
  void operator()(const Interval& u, const Interval& v, std::span<Interval> outputs);

  /// The number of operations that break u x v: they are not proved to be continuous and defined
  /// there, but their arguments are. Where two features cross there are more than along either.
  std::size_t count_breaks(const Interval& u, const Interval& v);
  /// The breaks among the operations that depend on both u and v. Others break along lines of
  /// constant u or v. An operation with an argument that one of these breaks does not count.
  std::size_t count_breaks_of_both(const Interval& u, const Interval& v);
  /// The breaks among the operations on u alone (axis 0), or on v alone (axis 1).
  std::size_t count_breaks_of_one(int axis, const Interval& range);

  /// The cost of a box in additions.
  std::size_t steps() const;

 private:
  struct Step {
    Op op;
    bool square;  // a product of a slot with itself, or a power 2
    bool joins;   // in[0] is the sign of a value, and in[1] is 0 where that is: no jump
    std::uint32_t out;
    std::array<std::uint32_t, 3> in;
  };
  /// Values that depend on one parameter alone. A range replaces the one in the same place.
  struct Bank {
    std::vector<Step> steps;
    std::uint32_t first = 0;  ///< slot: the parameter's own
    std::uint32_t count = 0;
    Interval now = kUndefined;     ///< the range that the slots are of
    std::vector<Interval> known;   ///< ranges whose values are kept, by their hashes
    std::vector<Interval> values;  ///< `count` of each
    std::size_t misses = 0;        ///< since there were as many places as now
  };
  void append(std::span<const Instruction> instructions, std::vector<Step>& steps) const;
  Interval apply(const Step& step) const;
  void run(std::span<const Step> steps);
  std::size_t run_counting_breaks(std::span<const Step> steps);
  void load(const Interval& range, Bank& bank);
  void keep_needed_steps();
  void find_joined_signs();
  std::uint32_t place(Slot slot) const;

  std::array<std::uint32_t, 4> banks_ = {};  ///< where the slots of each rate begin
  Bank of_u_, of_v_;
  std::vector<Step> of_both_;
  std::vector<std::uint32_t> outputs_;
  std::vector<Interval> slots_;
};

/// A tape over one box.
void enclose(const Tape& tape, const Interval& u, const Interval& v, std::span<Interval> outputs);

/// A function over a box from its value at the middle and its slopes over the whole box (mean value
/// theorem), and never wider than `natural`, its own enclosure, which this returns where it has no
/// proof that the function is continuous and has slopes. offset_u: the box less its middle.
Interval mean_value(const Interval& natural, const Interval& at_middle, const Interval& slope_u,
                    const Interval& offset_u, const Interval& slope_v, const Interval& offset_v);

}  // namespace saddle
