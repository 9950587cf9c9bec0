// From a surface to what is known of it before there is a mesh: 64 x 64 samples of positions,
// normals and second derivatives, and as many along its edges. The sizing field, the seams, where
// to look for singular points and a lower bound of triangles follow from them. Samples lie off the
// points of an even grid, so that a surface that oscillates with such a grid shows it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/features/singular.h"
#include "mesh/model/seam.h"
#include "mesh/model/tolerance.h"
#include "mesh/proof/landmarks.h"
#include "surface/surface.h"

namespace saddle {

/// Linearisation errors: distances of the surface from its tangent plane along the sides of cells
/// of some size, in tolerances, by the second derivatives of samples.
struct LinearizationErrors {
  std::vector<double> u, v;   ///< of the columns, of the rows, in the domain's direction
  std::vector<dvec2> values;  ///< along u and along v; v outer; NaN where not known
};

class Probe {
 public:
  struct Sample {
    dvec3 position;
    double L, M, N;  ///< second derivatives along the unit normal
    dvec2 bends;     ///< |r_uu| and |r_vv|
    double area;     ///< |r_u x r_v|; infinite where it is not known
    double sqrt_k;   ///< sqrt|K| |r_u x r_v|
    bool saddle;     ///< K < 0
    bool regular;    ///< all of it is finite
  };
  /// A sample on an edge of the domain.
  struct EdgeSample {
    std::size_t line;  ///< its column or row
    dvec3 position;
    double across;  ///< second derivative along the edge, across its tangent
  };

  /// For a surface of second order.
  Probe(const Surface& surface, unsigned threads);

  /// Forgets the samples outside of a box (its faces may be infinitely far), unless all are.
  void keep_within(const Bounds& box);

  const Domain& domain() const { return domain_; }
  std::span<const double> u() const { return u_; }              ///< of the columns
  std::span<const double> v() const { return v_; }              ///< of the rows
  std::span<const Sample> samples() const { return samples_; }  ///< v outer
  dvec2 uv(std::size_t sample) const { return {u_[sample % u_.size()], v_[sample / u_.size()]}; }
  /// The area of parameters for each sample.
  double stretch() const;
  std::span<const EdgeSample> edges_along_u() const { return edges_along_u_; }  ///< of constant v
  std::span<const EdgeSample> edges_along_v() const { return edges_along_v_; }

  /// A box around the finite positions. After keep_within() it ends at the faces of the given box
  /// beyond which samples were forgotten.
  const Bounds& bounds() const { return bounds_; }
  /// The finite positions of samples, without those of edges; and of these.
  std::span<const dvec3> positions() const { return positions_; }
  std::vector<dvec3> edge_positions() const;
  /// The lengths of the longest line of constant v and of the longest one of constant u, as far as
  /// samples are finite.
  dvec2 longest_lines() const;
  /// Small features between samples, and places beside jumps and boundaries.
  const Landmarks& landmarks() const { return landmarks_; }
  /// Where the surface is, if few samples or none met it.
  const std::optional<SmallComponent>& component() const { return component_; }
  /// For cells of this size in u and v. These errors count all of the second derivative, not just
  /// what is along the normal: a cell that holds many waves is steep wherever there is no crest.
  LinearizationErrors linearization_errors(const dvec2& size, const Tolerance& tolerance) const;

  /// Samples beside which |r_u x r_v| may be 0, but for those beside edges at which it is.
  Dips dips() const;

  /// How the domain's edges meet, by a few places on each.
  const Seams& seams() const { return seams_; }

  /// Number of triangles that a mesh with its vertices on the surface needs at least, for small
  /// tolerances: (0.3849 I+ + 0.2236 I-) / eps, I+ and I- the integrals of sqrt|K| dA where K > 0
  /// and K < 0. 0 where the surface is developable.
  /// Source: L. Fejes Toth, "Lagerungen in der Ebene, auf der Kugel und im Raum", 1953;
  /// P. M. Gruber, "Asymptotic estimates for best and stepwise approximation", 1993; for K < 0:
  /// H. Pottmann et al., "On piecewise linear approximation of quadratic functions", 2000.
  double least_triangles(const Tolerance& tolerance) const;

 private:
  void sample_inside(const Surface& surface, unsigned threads);
  void sample_edges(const Surface& surface, unsigned threads);
  void list_positions();
  void add_to_bounds(const Surface& surface, std::span<const SurfacePoint> edges,
                     std::span<const dvec2> uv);
  /// |r_u x r_v| of the k-th sample from an edge on, along a column (of constant u) or a row.
  double area(bool along_v, std::size_t line, std::size_t k) const {
    return samples_[along_v ? k * u_.size() + line : line * u_.size() + k].area;
  }
  /// The largest of these next to an edge along u or v.
  double area_beside(bool along_u, std::size_t end) const;
  bool is_dip(bool along_v, std::size_t line, std::size_t k) const;

  std::vector<double> u_, v_;
  Domain domain_;
  std::vector<Sample> samples_;
  std::vector<dvec3> positions_;
  std::vector<EdgeSample> edges_along_u_, edges_along_v_;
  std::array<bool, 2> singular_ends_u_ = {};  // whether |r_u x r_v| is 0 all along u0, and u1
  std::array<bool, 2> singular_ends_v_ = {};
  Seams seams_;
  Bounds bounds_;
  Landmarks landmarks_;
  std::optional<SmallComponent> component_;
};

}  // namespace saddle
