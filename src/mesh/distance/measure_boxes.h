// Measures the corners of boxes whose surface is bounded around them: whether the triangles of
// their patch are within proof.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mesh/distance/nearest_triangles.h"
#include "mesh/grid/grid.h"
#include "mesh/model/counterexample.h"
#include "mesh/proof/certify.h"

namespace saddle {

class BoxMeasure {
 public:
  /// The triangles of each patch, and of the whole mesh.
  struct Triangles {
    std::function<std::span<const Triangle>(std::size_t patch)> of;
    std::function<NearestTriangles()> all;
  };

  /// `patches`: of the boxes. Points outside of `clip` refute nothing. Where `budget` allows no
  /// visits, boxes that the triangles of their patch leave open stay open.
  BoxMeasure(const Surface& surface, const Grid& grid, const Patches& patches, Triangles triangles,
             const std::optional<Bounds>& clip, ProofBudget& budget, unsigned threads);

  /// MeasureBoxes
  std::vector<ProofOutcome> operator()(std::span<const BoundedBox> boxes);

  /// The distance of a position from all triangles of the mesh, or `known` if none is nearer.
  double distance_from_mesh(const dvec3& position, double known);

  /// A point of each refuted box that is farther away than its patch allows, and its distance.
  struct Found {
    Counterexample counterexample;
    double distance;
  };
  const std::vector<Found>& found() const { return found_; }

 private:
  /// Points of a box.
  struct Points {
    std::span<const dvec2> uv;
    std::span<const dvec3> positions;
  };
  /// The numbers of the corners of a rectangle among the points of a box.
  using Corners = std::array<std::size_t, 4>;

  const NearestTriangles& tree();
  NearestTriangle search(const dvec3& position, double enough, const NearestTriangle& known);
  NearestTriangle nearest_of_patch(std::size_t patch, const dvec3& position, double enough,
                                   std::span<const NearestTriangle> before) const;
  std::optional<NearestTriangle> nearest(std::size_t patch, const dvec3& position, double enough,
                                         std::span<const NearestTriangle> before);
  std::optional<ProofOutcome> measure_from_patch(const BoundedBox& box, const Points& points,
                                                 std::vector<NearestTriangle>& nearest) const;
  ProofOutcome measure_from_mesh(const BoundedBox& box, const Points& points);
  bool are_rectangles_near(const BoundedBox& box, std::span<const dvec3> points,
                           std::span<const NearestTriangle> nearest) const;
  bool is_over_patch(const BoundedBox& box, const Corners& corners, std::span<const dvec3> points,
                     double most) const;
  double fold_between(const Triangle& a, const Triangle& b, const Corners& corners,
                      std::span<const NearestTriangle> nearest) const;
  bool is_near(const Corners& corners, std::span<const NearestTriangle> nearest, double most) const;

  const Surface& surface_;
  const Grid& grid_;
  const Patches& patches_;
  Triangles triangles_;
  std::optional<NearestTriangles> tree_;  // made for the first point that its patch misses
  std::optional<Bounds> clip_;
  ProofBudget& budget_;
  unsigned threads_;
  std::vector<Found> found_;
};

}  // namespace saddle
