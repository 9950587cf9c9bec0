// How far leaves are off in which the surface turns as sharply as at an edge: a few places tell
// little of the others there, and what is nearest to a point is not what is at its parameters. That
// is so, too, where parameters are so skew that the middle of a leaf is not near its diagonal's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/validated_mesh.h"

namespace saddle {

class SharpBends {
 public:
  SharpBends(const Surface& surface, const Grid& grid, const CellTree& tree, unsigned threads)
      : surface_(surface), grid_(grid), tree_(tree), threads_(threads) {}

  /// A leaf that was measured, and that nothing cuts, with its triangles, which must outlive this.
  /// Nothing is done if it is known to be too far off, or if its samples tell enough.
  void add(const ValidatedMesh& mesh, std::size_t number, std::span<const Triangle> triangles);

  /// Measures them in more places, and how far triangles are from the surface. Adds the distances
  /// that are found to the mesh.
  void measure(ValidatedMesh& mesh);

  std::size_t evaluations() const { return evaluations_; }

 private:
  /// What is to be looked at.
  struct Targets {
    bool places, sides;
    bool everywhere = false;  ///< corners do not tell where it turns
  };
  struct SharpLeaf {
    std::size_t number;
    dvec2 low, high;
    std::span<const Triangle> triangles;
    Targets targets;
    dvec2 farthest{0};    ///< the place that was found to be farthest off
    double distance = 0;  ///< there
  };
  /// A place to sample at, and the triangle's side whose middle is there.
  struct Place {
    std::size_t leaf;
    dvec2 uv;
    std::optional<std::array<std::uint32_t, 2>> side = {};
  };
  std::optional<Targets> targets_of(const ValidatedMesh& mesh, std::size_t number,
                                    std::span<const Triangle> triangles) const;
  void append_places(std::size_t number, std::vector<Place>& places) const;
  void append_middles(std::size_t number, std::vector<Place>& places) const;
  void sample(ValidatedMesh& mesh);
  void search(ValidatedMesh& mesh);
  void validate_at(const dvec2& uv, const dvec3& position, SharpLeaf& leaf,
                   ValidatedMesh& mesh) const;

  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  unsigned threads_;
  std::vector<SharpLeaf> leaves_;
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
