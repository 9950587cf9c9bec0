// What second derivatives ask of a tensor grid: how large a cell's error is, and how close lines
// must be for most cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace saddle {

/// Second derivatives along the normal, in tolerances; 0 where there is none.
struct SecondForm {
  double L, M, N;
};

/// The error of a cell of sides h and k that is cut along its shorter diagonal, beside its bound
/// (|L| h^2 + 2 |M| h k + |N| k^2) / 8. Where the surface curves to both sides errors do not add
/// up; where it curves to one side the error is largest at the centre of the circle through a
/// triangle's corners, in the metric of curvature, if that is inside.
struct FormError {
  double error, bound;
};
FormError form_error_of_cell(const SecondForm& bend, double h, double k);

/// Lines per unit of parameter for which arcs of this second derivative, in tolerances, stay within
/// half of the tolerance, the other half being the other direction's: h^2 bend / 8 <= 1 / 2.
double density_for(double bend);

/// Lines per unit of parameter, at the columns and rows of samples.
struct SizingField {
  std::vector<double> of_u, of_v;
};

/// Samples of a surface in columns and rows, and the densities that most of them ask for.
class SampledForms {
 public:
  /// Of samples with the columns inner, those that are `regular`: every so many of each column and
  /// row, next to those of its neighbours on a slant.
  SampledForms(std::span<const SecondForm> bends, std::span<const std::uint8_t> regular,
               std::size_t columns, std::size_t rows, std::size_t every);

  /// For cells whose sides, in v and in u, have the ratio `rho`, or are as these densities tell.
  SizingField sizing(double rho, const SizingField* shape);

 private:
  struct Sample {
    SecondForm bend;
    std::uint32_t column, row;
    std::uint32_t in_column, in_row;  ///< its places in what columns and rows ask for
  };
  std::vector<Sample> samples_;
  std::vector<std::size_t> first_of_column_, first_of_row_;  ///< and the end
  std::vector<double> asked_by_columns_, asked_by_rows_;
};

}  // namespace saddle
