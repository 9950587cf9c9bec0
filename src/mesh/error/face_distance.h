// Distances between the lines along which a clip box cuts the surface and its mesh.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/validated_mesh.h"
#include "mesh/model/segment.h"
#include "mesh/proof/continuity.h"

namespace saddle {

class FaceDistance {
 public:
  FaceDistance(const Surface& surface, const Grid& grid, const Bounds& clip, unsigned threads)
      : surface_(surface), grid_(grid), clip_(clip), threads_(threads) {}

  /// Adds the triangles of a leaf, in which sheets may end. Skips those that no face of the box
  /// cuts.
  void add(std::size_t leaf, bool is_at_edge, std::span<const Triangle> triangles);

  /// Adds to the mesh the distances of the surface's lines from the cuts of the leaves' triangles:
  /// on the sides of the triangles and between them. `triangles`: of the leaves `which`, in place
  /// of those that the mesh has of them.
  void measure(ValidatedMesh& mesh, std::span<const std::size_t> which,
               const LeafTriangles& triangles);

  std::size_t evaluations() const { return evaluations_; }

 private:
  struct Face {
    int axis;
    double limit;

    bool operator==(const Face&) const = default;
  };
  /// A line of parameters from below a face to above it, and where it crosses the face.
  struct Crossing {
    Face face;
    Line line;
    std::array<double, 2> heights;  ///< of its ends above the face
    dvec2 uv = dvec2(0);
    dvec3 position = dvec3(std::numeric_limits<double>::quiet_NaN());
    std::size_t last_end = 2;  ///< the end that moved last: 0 or 1
  };
  /// A triangle's cut by a face, and the numbers of the sides that it crosses.
  struct Cut {
    std::size_t leaf;
    Face face;
    dvec2 size;  ///< of the triangle in parameters
    std::array<dvec3, 2> ends;
    std::array<std::size_t, 2> sides;
  };
  /// The numbers of the sides of a triangle that a face cuts, and where.
  struct CutSides {
    std::array<std::size_t, 2> sides;
    std::array<dvec3, 2> ends;
  };
  /// A place of the surface on a face and one of the mesh, with their distances from the mesh's
  /// cuts and from the surface's lines. These lead from leaf to leaf.
  struct FarPlace {
    std::size_t leaf;
    const Crossing* crossing;
    dvec3 on_cut;
    double distance = std::numeric_limits<double>::infinity();
    double distance_of_cut = std::numeric_limits<double>::infinity();

    double error() const { return std::max(distance, distance_of_cut); }
    void move_to_cut(const std::array<dvec3, 2>& cut) {
      distance = std::min(distance, distance_from_segment(cut[0], cut[1], crossing->position));
    }
    void move_to_line(const std::array<dvec3, 2>& line) {
      distance_of_cut = std::min(distance_of_cut, distance_from_segment(line[0], line[1], on_cut));
    }
  };
  void for_faces(const auto& act) const;
  void for_cuts(const Triangle& t, const auto& act) const;
  std::optional<CutSides> sides_of_cut(const Triangle& t, const Face& face) const;
  /// A leaf, and whether sheets may end in it.
  struct CutLeaf {
    std::size_t number;
    bool is_at_edge;
  };
  void add_cut(const CutLeaf& leaf, const Triangle& t, const Face& face, const CutSides& found);
  static Crossing crossing_of(Line line, std::array<double, 2> heights, const Face& face);
  std::size_t number_of(const Crossing& crossing, std::size_t leaf);
  void find(std::vector<Crossing>& crossings);
  std::vector<Crossing> middles() const;
  std::vector<FarPlace> far_from_own_cuts(const ValidatedMesh& mesh,
                                          const std::vector<Crossing>& across) const;
  using TrianglesOf = std::function<std::span<const Triangle>(std::size_t)>;
  void move_to_cuts(std::size_t leaves, const TrianglesOf& triangles_of,
                    std::span<FarPlace> places) const;
  void move_to_lines(std::size_t first, std::size_t last, const std::vector<Crossing>& across,
                     std::span<FarPlace> places) const;

  const Surface& surface_;
  const Grid& grid_;
  const Bounds& clip_;
  unsigned threads_;
  std::vector<Cut> cuts_;  ///< those of a leaf are together
  std::vector<Crossing> sides_;
  double enough_ = std::numeric_limits<double>::infinity();  ///< a step that ends a search
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
