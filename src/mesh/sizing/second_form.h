// Second forms (second derivatives along the normal): the error of a cell, and the sizing field
// that keeps most cells of a tensor grid within the tolerance.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace saddle {

/// In tolerances; 0 where there is none.
struct SecondForm {
  double L, M, N;
};

/// The error of a cell of sides h and k that is cut along its shorter diagonal, and its bound
/// (|L| h^2 + 2 |M| h k + |N| k^2) / 8. At a saddle the errors along both diagonals do not add up.
/// Elsewhere the error is largest at the centre of the circle through a triangle's corners, in the
/// metric of curvature, if that lies inside.
struct FormError {
  double error, bound;
};
FormError form_error_of_cell(const SecondForm& bend, double h, double k);

/// Lines per unit of parameter for which arcs of this second derivative, in tolerances, stay within
/// half of the tolerance: h^2 bend / 8 <= 1 / 2. The other half is left to the other direction.
double density_for(double bend);

/// The sizing field of a tensor grid: lines per unit of parameter, at columns and rows of samples.
struct SizingField {
  std::vector<double> of_u, of_v;
};

/// Second forms at samples in columns and rows, and the sizing field for most of them.
class SampledForms {
 public:
  /// Takes the `regular` samples, columns inner: each `every`th one of a column or row, on slanting
  /// lines.
  SampledForms(std::span<const SecondForm> bends, std::span<const std::uint8_t> regular,
               std::size_t columns, std::size_t rows, std::size_t every);

  /// For cells whose sides in v and in u have the ratio `rho`, or the shape that `shape` gives
  /// them.
  SizingField sizing(double rho, const SizingField* shape);

 private:
  struct Sample {
    SecondForm bend;
    std::uint32_t column, row;
    std::uint32_t in_column, in_row;  ///< indices in asked_by_columns_, asked_by_rows_
  };
  std::vector<Sample> samples_;
  std::vector<std::size_t> first_of_column_, first_of_row_;  ///< and the total
  std::vector<double> asked_by_columns_, asked_by_rows_;
};

}  // namespace saddle
