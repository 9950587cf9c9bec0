// Level lines through the triangles of a mesh whose corners have numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/color/level_roots.h"
#include "mesh/model/mesh.h"
#include "mesh/model/pair_table.h"
#include "surface/surface.h"

namespace saddle {

/// Levels in order, and what is equal to them but for rounding.
struct Levels {
  std::vector<double> levels;
  double rounding = 0;

  /// How many levels a number reaches.
  std::size_t reached_by(double number) const;
  /// The number above a level: 0 if they differ by rounding.
  double above(double number, std::size_t level) const;
};

/// In each triangle a level crosses two sides, beside the corner that is alone on its side of it.
/// Each straight way from this corner to the side across meets the line once: that is where its
/// vertices are found, so that a line leaves no triangle and meets no other one.
class ContourTracer {
 public:
  /// All stay where they are. `mesh` has numbers; no side of it has a level twice.
  /// `mesh_error`: the distance of mesh and surface.
  ContourTracer(const Surface& surface, const Mesh& mesh, const Levels& levels, double tolerance,
                double mesh_error, unsigned threads)
      : surface_(surface),
        mesh_(mesh),
        levels_(levels),
        tolerance_(tolerance),
        mesh_error_(mesh_error),
        threads_(threads) {}

  /// Finds where the levels cross sides. Returns the triangles in which a line ends because the
  /// number jumps over the level.
  std::vector<std::size_t> cross_sides();

  /// The lines between, as far from the true ones as the tolerance.
  void trace(MeshContours& contours);

 private:
  /// A line's way through a triangle.
  struct Piece {
    std::uint32_t alone, second, third;  // corners; the line leaves alone-second for alone-third
    std::size_t level;
    std::size_t from, to;  // crossings
  };
  /// A part of a piece: the shares of the way from the second corner to the third that its ends are
  /// in the direction of, and its vertices.
  struct Part {
    std::size_t piece;
    double from, to;
    std::uint32_t first, last;
  };

  std::size_t crossing(std::uint32_t a, std::uint32_t b, std::size_t level);
  std::uint32_t add_vertex(const dvec2& uv, const dvec3& on_mesh, const dvec3& normal,
                           double reach);
  void place_vertices(std::size_t first, MeshContours& contours);
  void halve_parts(std::vector<Part>& parts, bool always, MeshContours& contours);

  const Surface& surface_;
  const Mesh& mesh_;
  const Levels& levels_;
  double tolerance_;
  double mesh_error_;
  unsigned threads_;
  std::vector<PairTable> known_;  // crossings of the sides, for each level
  std::vector<LevelBracket> crossings_;
  std::vector<std::array<std::uint32_t, 2>> sides_;  // of the crossings
  std::vector<Piece> pieces_;
  std::vector<std::vector<std::pair<double, std::uint32_t>>> inner_;  // vertices of the pieces
  // Vertices that have no true place yet.
  std::vector<dvec2> uv_;
  std::vector<dvec3> on_mesh_;
  std::vector<dvec3> normal_;
  std::vector<double> reach_;  // a place farther from the mesh's is beyond a cut
};

}  // namespace saddle
