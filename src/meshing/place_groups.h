// Places of a domain, told together: lines of constant u or v, and boxes.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec.h"
#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Places that are told as one: a point, a part of a line of constant u or v, or a box.
struct PlaceGroup {
  dvec2 low;
  dvec2 high;
  std::vector<std::size_t> members;  ///< indices of the places

  PlaceGroup(std::span<const dvec2> places, std::vector<std::size_t> indices);

  bool is_point() const { return low == high; }
  /// "u = 1, v = 2:3", by the domain's names; a box that is no line begins with "within".
  std::string text(const Domain& domain, int digits) const;
};

/// 0, 1, ... count - 1.
std::vector<std::size_t> indices_of(std::size_t count);

/// "u = 1", "u = 1:2".
std::string range_text(const std::string& name, double low, double high, int digits);
/// The same with kToldDigits, or more where these do not tell the ends apart.
std::string full_range_text(const std::string& name, double low, double high);

/// A place with a parameter of 0 where it is below `rounding`, as a part of its range: a bisection
/// may end at 1e-20 where 0 is meant.
dvec2 without_rounding(dvec2 place, const Domain& domain, double rounding);

/// Places that bisections from many sides ended at, each once.
std::vector<dvec2> distinct_places(std::span<const dvec2> places, const Domain& domain);

/// Takes lines of many places out of `left`, the longest before the others.
std::vector<PlaceGroup> take_lines(std::span<const dvec2> places, const Domain& domain,
                                   std::vector<std::size_t>& left);

/// Each of some places, or all as one if they are many.
std::vector<PlaceGroup> one_by_one(std::span<const dvec2> places,
                                   const std::vector<std::size_t>& which);

/// Digits of numbers in sentences: enough to find a place, short enough to read.
inline constexpr int kToldDigits = 4;

/// Places or groups of places that are told one by one; more are "others".
inline constexpr std::size_t kToldGroups = 6;

/// Groups of the distinct places: lines first.
std::vector<PlaceGroup> grouped_places(std::span<const dvec2> places, const Domain& domain);

/// The groups' texts with "; " between them. `has_others`: there are places beside these.
std::string text_of(std::span<const PlaceGroup> groups, bool has_others, const Domain& domain,
                    int digits);

/// Where a surface is cut, as it is told: lines from end to end of the range are counted where
/// there are more than kToldGroups; places beside them are grouped.
class ToldCuts {
 public:
  ToldCuts(std::span<const dvec2> places, const ParameterLines& lines, const Domain& domain);

  /// The number of groups if they are all points, and no line is counted.
  std::optional<std::size_t> points() const;
  /// A box around all of them: its corners.
  std::array<dvec2, 2> box() const;
  /// "200 lines of constant u, u = -1, -0.9 and others; u = 0, v = 1:2".
  std::string text(bool has_others, int digits) const;

 private:
  const Domain& domain_;
  std::array<std::span<const double>, 2> lines_;  ///< that are counted, of constant u and of v
  std::vector<PlaceGroup> groups_;
};

}  // namespace saddle
