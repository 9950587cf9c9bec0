// How close the lines of a tensor grid must be for a mesh within a tolerance, from the second
// derivatives of the surface.
// Source: D. Filip, R. Magedson, R. Markot, "Surface algorithms using bounds on derivatives", 1986.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/features/singular.h"
#include "mesh/model/counterexample.h"
#include "mesh/model/seam.h"
#include "mesh/model/tolerance.h"
#include "mesh/proof/small_components.h"
#include "mesh/sizing/second_form.h"
#include "surface/surface.h"

namespace saddle {

/// Parameters that a grid's lines must include: those of the lines that are drawn and the ends.
struct FixedLines {
  std::vector<double> u, v;  ///< at least two each, from the range's first end to its last
};

/// How far the surface departs from its linear approximation along the sides of cells of some size,
/// in tolerances, by second derivatives at places in columns and rows.
struct LinearizationErrors {
  std::vector<double> u, v;   ///< of the columns, of the rows, in the domain's direction
  std::vector<dvec2> values;  ///< along u and along v; v outer; NaN where not known
};

/// What becomes of a grid's cells, by the probe's samples.
struct GridForecast {
  double worst = 0;        ///< the largest error of a cell, in tolerances
  double cells = 0;        ///< once those that are too large are cut up
  bool is_regular = true;  ///< there is a second derivative along a normal at every sample
};

/// Second derivatives, normals and curvatures on a coarse grid that keeps step with nothing.
class Probe {
 public:
  /// For a surface of second order.
  Probe(const Surface& surface, unsigned threads);

  /// Forgets the samples outside of a box (its faces may be infinitely far), unless all are.
  void keep_within(const Bounds& box);

  /// A box around the finite positions: where samples are forgotten, as far as the box they were
  /// to be in.
  const Bounds& bounds() const { return bounds_; }
  /// The finite positions that are spread over the surface, not those of its edges.
  std::vector<dvec3> positions() const;
  /// Where the surface is, if no sample met it, or but one.
  const std::optional<SmallComponent>& component() const { return component_; }
  /// The largest distance of a finite position from `centre`.
  double radius(const dvec3& centre) const;

  /// The lines that a tensor grid must have: those that are drawn, those at which the surface is
  /// singular, if they are few, and those that these meet across a seam.
  FixedLines fixed_lines(const FixedLines& drawn, const SingularSet& singular) const;

  /// How close the lines of a tensor grid with the fixed ones are to be at each column and row of
  /// samples, so that most of its cells are within the tolerance: local peaks are left to local
  /// refinement. The cells have the shape for which there are the fewest.
  SizingField sizing(const FixedLines& fixed, const Tolerance& tolerance) const;
  /// Where lines of so many times these densities go. Errors fall with the square of that: for a
  /// tolerance four times as large, half the densities.
  FixedLines place_lines(const FixedLines& fixed, const SizingField& sizing,
                         double times = 1) const;

  /// The samples beside which a cell of these lines is far too large; `cell` counts with u inner.
  std::vector<Counterexample> counterexamples(const FixedLines& lines,
                                              const Tolerance& tolerance) const;

  /// Of cells of this size in u and v. Not along the normal, as errors are: waves that a cell holds
  /// many of are steep wherever they are not at a crest.
  LinearizationErrors linearization_errors(const dvec2& size, const Tolerance& tolerance) const;

  /// Samples beside which |r_u x r_v| may be 0, but for those beside edges at which it is.
  Dips dips() const;

  /// What to expect of a mesh that starts from these lines.
  GridForecast grid_forecast(const FixedLines& lines, const Tolerance& tolerance) const;

  /// How the domain's edges meet, by a few places on each.
  const Seams& seams() const { return seams_; }

  /// The number of triangles that no mesh with its corners on the surface can do without, for small
  /// tolerances: (0.3849 I+ + 0.2236 I-) / eps, I+ and I- the integrals of sqrt|K| dA where K > 0
  /// and K < 0. 0 where the surface is developable.
  /// Source: L. Fejes Toth, "Lagerungen in der Ebene, auf der Kugel und im Raum", 1953;
  /// P. M. Gruber, "Asymptotic estimates for best and stepwise approximation", 1993; for K < 0:
  /// H. Pottmann et al., "On piecewise linear approximation of quadratic functions", 2000.
  double least_triangles(const Tolerance& tolerance) const;

 private:
  struct Sample {
    dvec3 position;
    double L, M, N;  // second derivatives along the unit normal
    dvec2 bends;     // |r_uu| and |r_vv|
    double area;     // |r_u x r_v|; infinite where it is not known
    double sqrt_k;   // sqrt|K| |r_u x r_v|
    bool saddle;     // K < 0
    bool regular;    // all of it is finite
  };
  /// Second derivatives of the domain's edges across their tangents.
  struct EdgeSample {
    std::size_t line;  // the column or row
    dvec3 position;
    double across;
  };
  void sample_inside(const Surface& surface, unsigned threads);
  void sample_edges(const Surface& surface, unsigned threads);
  /// |r_u x r_v| of the k-th sample from an edge on, along a column (of constant u) or a row.
  double area(bool along_v, std::size_t line, std::size_t k) const {
    return samples_[along_v ? k * u_.size() + line : line * u_.size() + k].area;
  }
  /// The largest of them next to an edge along u or v.
  double area_beside(bool along_u, std::size_t end) const;
  bool is_dip(bool along_v, std::size_t line, std::size_t k) const;
  std::vector<SecondForm> bends(const Tolerance& tolerance) const;
  /// The ratio of cells' sides, in v and in u, for which there are the fewest.
  double best_ratio(const FixedLines& fixed, const SizingField& along_edges,
                    SampledForms bent) const;
  /// The error of the cell of these lines around a sample, in tolerances.
  struct SampledCell {
    std::size_t i, j;  // of the cell
    double area;       // of parameters
    double error;
  };
  /// Calls f(sample, cell) for all samples.
  template <class F>
  void for_sampled_cells(const FixedLines& lines, std::span<const SecondForm> bends, F f) const;
  /// What the edges ask for: along them the mesh must follow the edge itself, with all of the
  /// tolerance.
  SizingField along_edges(const Tolerance& tolerance) const;
  /// From what most samples ask for, that which all of the surface needs.
  void complete(const SizingField& along_edges, SizingField& sizing) const;

  std::vector<double> u_, v_;
  Domain domain_;
  std::vector<Sample> samples_;            // v outer
  std::vector<EdgeSample> edges_along_u_;  // of constant v
  std::vector<EdgeSample> edges_along_v_;
  std::array<bool, 2> singular_ends_u_ = {};  // whether |r_u x r_v| is 0 all along u0, and u1
  std::array<bool, 2> singular_ends_v_ = {};
  Seams seams_;
  Bounds bounds_;
  std::optional<SmallComponent> component_;
};

}  // namespace saddle
