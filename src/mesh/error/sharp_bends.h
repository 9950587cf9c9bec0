// More validation points for leaves in which the surface turns as sharply as at an edge. A few
// points tell little about the others there, and the surface's nearest point is not the one at the
// same parameters. The same holds where parameters are so skew that the middles of a leaf and of
// its diagonal are apart.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/distance/whole_mesh_error.h"
#include "mesh/error/leaf_centres.h"
#include "mesh/error/validated_mesh.h"

namespace saddle {

class SharpBends {
 public:
  /// A compass search starts at the farthest place of a leaf, if its distance is at least 0.85
  /// tolerances; in a strip, 0.5. For sides whose middles are nearer to the surface at their
  /// parameters, the nearest point is not searched; nor are diagonals of leaves that are estimated
  /// to be nearer.
  static constexpr double kLeastEstimate = 0.85;

  /// The surface outside of `clip`, which must outlive this, is at no distance.
  SharpBends(const Surface& surface, const Grid& grid, const CellTree& tree,
             const std::optional<Bounds>& clip, unsigned threads)
      : surface_(surface), grid_(grid), tree_(tree), clip_(clip), threads_(threads) {}

  /// Adds a validated leaf with its triangles, which must outlive this. Leaves are added in the
  /// order of their triangles. Skips leaves with edge features other than creases, strips and faces
  /// of the clip box, leaves that are above their tolerance, and leaves whose points are enough.
  /// `centre`: of a leaf whose estimate exceeds kLeastEstimate tolerances.
  void add(const ValidatedMesh& mesh, std::size_t number, std::span<const Triangle> triangles,
           const std::optional<LeafCentre>& centre);

  /// Adds to the mesh the distances of the leaves at more places, and of their triangles' sides
  /// from the surface.
  void measure(ValidatedMesh& mesh);

  std::size_t evaluations() const { return evaluations_; }

 private:
  /// The parts of a leaf to sample.
  struct Targets {
    bool places, sides;
    bool everywhere = false;      ///< at a lattice of places
    bool from_triangles = false;  ///< the surface from the triangles, too
    bool in_strip = false;        ///< places are in the box of the triangles, not of the leaf
  };
  struct SharpLeaf {
    std::size_t number;
    dvec2 low, high;
    std::span<const Triangle> triangles;
    Targets targets;
    dvec2 farthest{0};    ///< the place with the largest distance so far
    double distance = 0;  ///< there
  };
  /// A place to sample, and the triangle's side whose middle it is.
  struct Place {
    std::size_t leaf;
    dvec2 uv;
    std::optional<std::array<std::uint32_t, 2>> side = {};
  };
  std::optional<Targets> targets_of(const ValidatedMesh& mesh, std::size_t number,
                                    std::span<const Triangle> triangles,
                                    const std::optional<LeafCentre>& centre) const;
  bool has_far_middle(const Leaf& leaf, double allowed) const;
  void append_places(std::size_t number, std::vector<Place>& places) const;
  void append_between_edges(std::size_t number, std::vector<Place>& places) const;
  void append_middles(std::size_t number, std::vector<Place>& places) const;
  void sample(ValidatedMesh& mesh);
  void search(ValidatedMesh& mesh);
  void measure_triangles(ValidatedMesh& mesh);
  void append_below_corners(const Triangle& t, double allowed,
                            std::vector<MeshPlace>& places) const;
  void validate_at(const dvec2& uv, const dvec3& position, SharpLeaf& leaf,
                   ValidatedMesh& mesh) const;

  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  std::vector<SharpLeaf> leaves_;
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
