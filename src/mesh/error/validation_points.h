// Where leaves are measured: places that nobody has looked at before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/validate_many.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

/// A place at which a leaf is measured.
struct ValidationPoint {
  std::size_t number;  ///< of the leaf, among those that are measured
  dvec2 uv;
  const Triangle* triangle = nullptr;  ///< it is in; unknown
  bool beside_cut = false;             ///< the normal may be that of the other side
  std::optional<Chord> crease = {};    ///< whose chord it is on
  dvec2 across{0};                     ///< from there across the chord, where the crease may be
};

/// Where a leaf is measured: always the same for the same leaf.
PlacesInLeaf validation_places(const Leaf& leaf);

class PointPlacer {
 public:
  PointPlacer(const Grid& grid, const CellTree& tree) : grid_(grid), tree_(tree) {}

  /// The samples of a leaf of any triangles, which must outlive them.
  void append(std::size_t number, const Leaf& leaf, std::span<const Triangle> triangles,
              std::vector<ValidationPoint>& samples) const;
  /// Those of the leaves of a mesh with these numbers that are on their singular sides.
  void append_singular_sides(const ValidatedMesh& mesh, std::span<const std::size_t> which,
                             std::vector<ValidationPoint>& samples) const;

 private:
  void append_sides(std::size_t number, std::span<const Triangle> triangles,
                    std::vector<ValidationPoint>& samples) const;
  void append_chords(std::size_t number, const Leaf& leaf, std::span<const Triangle> triangles,
                     std::vector<ValidationPoint>& samples) const;

  const Grid& grid_;
  const CellTree& tree_;
};

/// Samples on chords of cusps, and of creases at which the surface is upright, go to where those
/// are: they run beside their chords, and how far the surface is from them makes up for that in
/// part.
void move_onto_creases(const Surface& surface, std::span<ValidationPoint> samples,
                       unsigned threads);

}  // namespace saddle
