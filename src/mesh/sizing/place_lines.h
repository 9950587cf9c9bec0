// Places the lines of a grid between fixed ones, by a density that is given on even stretches.
#pragma once

#include <span>
#include <vector>

#include "mesh/model/seam.h"

namespace saddle {

/// Parameters that a grid's lines must include: drawn lines and the ends of the ranges.
struct FixedLines {
  std::vector<double> u, v;  ///< at least two each, from the range's first end to its last
};

/// Lines per unit of parameter, constant on even stretches of a range, integrated.
class Cumulative {
 public:
  Cumulative(std::span<const double> density, double first, double last);

  /// Lines from the range's first end to a parameter.
  double at(double parameter) const;
  /// The parameter with this number of lines before it.
  double where(double lines) const;

 private:
  std::size_t count() const { return sums_.size() - 1; }

  double first_, last_;
  std::vector<double> sums_;
};

/// The number of cells between the fixed lines, a whole number between neighbours.
double total_cells(const Cumulative& cumulative, std::span<const double> fixed);

/// The fixed lines and those between them.
std::vector<double> place_between(const Cumulative& cumulative, std::span<const double> fixed);
/// The same across a shifted seam, where lines of all parts meet. The lines of the first part are
/// copied to the others; the density must be the same there, and fixed lines copies.
std::vector<double> place_between(const Cumulative& cumulative, std::span<const double> fixed,
                                  const Seam& seam);

/// Even lines, with those that they meet across a seam. Even lines are their own mirror image.
std::vector<double> shared_lines(const Seam& seam, const std::vector<double>& fixed);

/// Fixed lines, and more lines with those that they meet across a seam or a fold. A line within
/// 1e-6 ranges of another is left out.
std::vector<double> with_lines(std::vector<double> fixed, const std::vector<double>& more,
                               const Seam& seam, const std::array<bool, 2>& folded);

}  // namespace saddle
