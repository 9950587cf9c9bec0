// Distances of triangles beside jumps and cliffs from the surface. The surface may be near the
// triangles of a narrow leaf where they are far from the surface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/distance/whole_mesh_error.h"
#include "mesh/error/validated_mesh.h"

namespace saddle {

class CellTree;

class SheetTriangles {
 public:
  SheetTriangles(const Surface& surface, const Grid& grid, const CellTree& tree, unsigned threads)
      : surface_(surface), grid_(grid), tree_(tree), threads_(threads) {}

  /// Adds a validated leaf with its triangles, which must outlive this. Skips leaves without jumps
  /// and cliffs, and those that are above their tolerance or may lead to a pole.
  void add(const ValidatedMesh& mesh, std::size_t number, std::span<const Triangle> triangles);

  /// Adds to the mesh the distances that exceed the tolerance.
  void measure(ValidatedMesh& mesh) const;

 private:
  struct TrianglesOfLeaf {
    const Triangle* first;
    std::size_t leaf;
  };

  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  unsigned threads_;
  std::vector<TrianglesOfLeaf> leaves_;
  std::vector<MeshPlace> places_;
};

}  // namespace saddle
