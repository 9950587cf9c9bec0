// Landmarks in the leaves of a mesh: leaves are halved toward those that the mesh misses, and
// their distances count as sampled errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/model/counterexample.h"
#include "mesh/model/mesh_report.h"
#include "mesh/proof/landmarks.h"

namespace saddle {

class CellTree;
struct Grid;

class LeafLandmarks {
 public:
  /// Landmarks outside of the clip box do not count.
  LeafLandmarks(const std::vector<Landmark>& all, const std::optional<Bounds>& clip,
                const Grid& grid, const CellTree& tree);

  bool any() const { return !places_.empty(); }
  /// Appends the landmarks in leaves that the mesh misses, as counterexamples. Before the first
  /// measure() the mesh misses every point.
  void append_missed(std::span<const Leaf> leaves,
                     std::vector<Counterexample>& counterexamples) const;

  /// Adds the distances of landmarks from the mesh to the sampled errors of the leaves `which`.
  void measure(std::span<const std::size_t> which, ValidatedMesh& mesh);

  /// Whether a leaf covers a landmark of a hole.
  bool misses_hole(const Leaf& leaf) const;

  /// Adds the largest distance of a missed landmark from all triangles to the report.
  void complete(std::span<const Triangle> triangles, double tolerance, MeshReport& report) const;

 private:
  std::vector<std::uint32_t> landmarks_in(const Leaf& leaf) const;
  double distance(const Landmark& landmark, std::span<const Triangle> triangles) const;
  /// A landmark that is far from the triangles of its leaf.
  struct Far {
    std::uint32_t landmark;
    std::size_t leaf;
    double distance;
  };
  void move_to_neighbours(std::vector<Far>& far, const ValidatedMesh& mesh) const;

  const Grid& grid_;
  const CellTree& tree_;
  std::vector<Landmark> places_;         // in the order of u
  std::vector<std::uint8_t> is_missed_;  // of each
};

}  // namespace saddle
