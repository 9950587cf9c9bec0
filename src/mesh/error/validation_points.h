// Validation points: where the errors of leaves are measured, away from the samples of the error
// indicator.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/validate_many.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/proof/continuity.h"

namespace saddle {

class CellTree;

/// A point at which the error of a leaf is measured.
struct ValidationPoint {
  std::size_t number;  ///< of the leaf, among those validated
  dvec2 uv;
  const Triangle* triangle = nullptr;  ///< around it; nullptr: unknown
  bool beside_cut = false;             ///< on an edge feature: the normal may be the other side's
  std::optional<Chord> crease = {};    ///< the chord that it is on
  std::optional<Line> across = {};     ///< where the crease is looked for
};

/// The jittered quarters of a leaf; always the same for the same leaf.
PlacesInLeaf validation_places(const Leaf& leaf);

class PointPlacer {
 public:
  PointPlacer(const Grid& grid, const CellTree& tree) : grid_(grid), tree_(tree) {}

  /// The points of a leaf of any triangles, which must outlive them. `allowed`: its tolerance.
  void append(std::size_t number, const Leaf& leaf, std::span<const Triangle> triangles,
              double allowed, std::vector<ValidationPoint>& samples) const;
  /// Points on cusps that are sides of the leaves of a mesh with these numbers.
  void append_singular_sides(const ValidatedMesh& mesh, std::span<const std::size_t> which,
                             std::vector<ValidationPoint>& samples) const;

 private:
  void append_middles(std::size_t number, const Leaf& leaf,
                      std::vector<ValidationPoint>& samples) const;
  void append_sides(std::size_t number, const Leaf& leaf, std::span<const Triangle> triangles,
                    std::vector<ValidationPoint>& samples) const;
  void append_across(std::size_t number, const Leaf& leaf, std::span<const Triangle> triangles,
                     double allowed, std::vector<ValidationPoint>& samples) const;
  void append_border(std::size_t number, const Leaf& leaf, std::span<const Triangle> triangles,
                     std::vector<ValidationPoint>& samples) const;
  void append_chords(std::size_t number, const Leaf& leaf, std::span<const Triangle> triangles,
                     std::vector<ValidationPoint>& samples) const;

  const Grid& grid_;
  const CellTree& tree_;
};

/// Samples on chords of cusps, and of creases at which the surface is upright, go to where those
/// are: they run beside their chords, and how far the surface is from them makes up for that in
/// part. Samples on chords of other creases get another one there, to be compared with triangles.
void move_onto_creases(const Surface& surface, std::vector<ValidationPoint>& samples,
                       unsigned threads);

}  // namespace saddle
