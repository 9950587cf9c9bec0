// Distances of a mesh from the sheets of a surface that lie as strips between several jumps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/distance/strip_distance.h"
#include "mesh/grid/grid.h"
#include "mesh/proof/continuity.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;
class JumpLines;

class CloseJumpDistance {
 public:
  CloseJumpDistance(const Surface& surface, const Grid& grid, const CellTree& tree,
                    unsigned threads)
      : surface_(surface), grid_(grid), tree_(tree), threads_(threads) {}

  /// Adds lines across the strips that go through a leaf. Its triangles must outlive this.
  /// `allowed`: its tolerance. False where strips do not all go from one side to another.
  bool add(const Leaf& leaf, std::size_t number, std::span<const Triangle> triangles,
           double allowed);
  /// Distances at the leaves that were added; several for some. A gap of less than `delta` is no
  /// jump.
  std::vector<LeafDistance> measure(double delta);

  std::size_t evaluations() const { return evaluations_; }
  /// Points and boxes in searches for jumps.
  std::size_t looks() const { return looks_; }

 private:
  /// A line across a leaf, from one of the sheets that the strips part to the other.
  struct Across {
    std::size_t leaf;
    std::span<const Triangle> triangles;
    Line line;
    double share;  ///< where it crosses the segments
    /// The edges of the mesh's sheets, in the order of the line.
    std::vector<std::array<dvec3, 2>> edges;
    std::vector<dvec2> in_strips;  ///< where the mesh has its strips on the line
    double allowed;                ///< the leaf's tolerance
  };
  std::vector<std::vector<Line>> jumps_between_strips(double delta);
  void search(double delta, std::span<std::vector<Line>> jumps);
  std::vector<double> measure(const Across& across, std::span<const dvec2> uv,
                              std::span<const dvec3> edges, std::vector<LeafDistance>& found) const;
  static void measure_ends(const Across& across, std::span<const std::vector<double>> along,
                           std::vector<LeafDistance>& found);
  /// The sheets of a leaf, sheet by sheet.
  struct Sheets {
    std::vector<std::array<dvec3, 2>> segments;
    std::array<dvec2, 2> middles;                 ///< of the crossings, in sides of the leaf
    std::vector<std::array<dvec2, 2>> in_strips;  ///< of the strips there
  };
  Sheets sheets_of(const Leaf& leaf, const JumpLines& lines) const;

  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  unsigned threads_;
  std::vector<Across> across_;
  std::size_t evaluations_ = 0;
  std::size_t looks_ = 0;
};

}  // namespace saddle
