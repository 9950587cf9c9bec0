// Errors of a finished mesh, measured against all of its triangles. Validation measures a leaf
// against its own triangles: beside a steep wall a neighbour's triangles may be nearer.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/grid/grid.h"
#include "mesh/model/placed_error.h"
#include "mesh/model/triangle_tree.h"
#include "surface/parameter_box.h"

namespace saddle {

/// A place of the mesh: a point of a triangle.
struct MeshPlace {
  const Triangle* triangle;
  dvec3 weights;  ///< of its corners
};

/// The middles of a triangle and of its sides, as weights of corners.
inline constexpr std::array kMiddlesOfTriangle = {dvec3(1.0 / 3), dvec3(0.5, 0.5, 0),
                                                  dvec3(0, 0.5, 0.5), dvec3(0.5, 0, 0.5)};

/// Searches climb from places that are farther than half of the largest distance known: the middle
/// of a side may have half of the side's error.
inline constexpr double kClimbedShare = 0.5;

/// Twice the area of a triangle over its longest side.
double thickness_of(const Mesh& mesh, const Triangle& t);

class WholeMeshError {
 public:
  /// `all`: the triangles of the mesh. Places outside of `clip` have no error. With
  /// `has_cliffs`, more of the surface beside places is searched. The surface, the grid and the
  /// triangles must outlive this.
  WholeMeshError(const Surface& surface, const Grid& grid, std::span<const Triangle> all,
                 const std::optional<Bounds>& clip, unsigned threads, bool has_cliffs = false)
      : surface_(surface),
        grid_(grid),
        all_(all),
        clip_(clip),
        threads_(threads),
        has_cliffs_(has_cliffs),
        tree_(grid.mesh.position, all, threads, surface.tangents.count) {}

  /// A place over triangles, of a leaf.
  struct Place {
    dvec2 uv;
    std::span<const Triangle> triangles;
    double known = 0;
  };
  /// The distance of a position from the triangles of a place; above `known`, from the whole mesh.
  double distance(const Place& place, const dvec3& position) const;
  /// The distances of the surface at some places from the triangles there; 0 where it is undefined
  /// or clipped. Above `known`, distances are from the whole mesh.
  std::vector<double> distances(std::span<const Place> places) const;

  /// A compass search for a larger distance of the surface from the mesh, within a box.
  struct Climb {
    PlacedError best;
    ParameterBox within;
    std::span<const Triangle> triangles;
  };
  void climb(std::span<Climb> climbs) const;

  /// The largest distance of some triangles from the surface near them or near vertices, or `known`
  /// if none is larger: from their middles and those of their sides. At most 192 places are
  /// searched, in the order of their expected distances.
  PlacedError from_mesh(std::span<const Triangle* const> triangles, double known,
                        double tolerance) const;

  /// A triangle, and the distance of a place of it from the surface.
  struct FarTriangle {
    const Triangle* triangle;
    double distance;
  };
  /// The triangles with a place that is farther than `least` from the surface nearby, in the order
  /// of their addresses. A search climbs from the places given, up to the distance `enough`;
  /// smaller distances may be too large.
  std::vector<FarTriangle> farther_than(double least, double enough,
                                        std::span<const MeshPlace> places) const;

 private:
  /// A place of the mesh, and the distance that it is expected to have from the surface.
  struct Expected {
    MeshPlace place;
    double distance;
    double near;  ///< its distance from the nearest known point of the surface
  };
  std::vector<Expected> expect_of_each(std::span<const MeshPlace> places, unsigned threads) const;
  /// The farthest first.
  std::vector<Expected> expect(std::span<const MeshPlace> places) const;
  std::vector<Expected> expect_above(std::span<const Triangle* const> triangles, double thin,
                                     double least) const;
  std::vector<Expected> expect_farthest(std::span<const Triangle* const> triangles,
                                        double known) const;
  dvec2 within_domain(const dvec2& uv) const;
  dvec2 uv_of(const MeshPlace& place) const;
  dvec3 position_of(const MeshPlace& place) const;
  /// A place of the mesh, and the nearest place of the surface that is known.
  struct Nearest {
    MeshPlace place;
    PlacedError error;
    dvec2 reach;  ///< first step of a search for a nearer one
  };
  /// Stops at places that are within `least`.
  std::vector<Nearest> search(std::span<const Expected> places, double least,
                              double tolerance) const;
  std::vector<Expected> descend_to_least(std::span<const Expected> places, double least) const;
  void begin_at_vertices(std::span<Nearest> nearest) const;
  void search_around(std::span<Nearest> nearest) const;
  /// The places farther than `least`, by a search from each. search_above() descends from them
  /// first.
  std::vector<Nearest> search_all(std::span<const Expected> places, double least,
                                  double tolerance) const;
  std::vector<Nearest> search_above(std::span<const Expected> places, double least,
                                    double tolerance) const;
  /// The places that are or seem to be farther than `least`. Places that a descent leaves within
  /// `enough` are not searched: they only show where to climb.
  std::vector<Nearest> all_above(std::span<const MeshPlace> places, double least,
                                 double enough) const;
  void climb_on_mesh(std::span<Nearest> places, double tolerance) const;

  const Surface& surface_;
  const Grid& grid_;
  std::span<const Triangle> all_;
  std::optional<Bounds> clip_;
  unsigned threads_;
  bool has_cliffs_;
  TriangleTree tree_;
};

}  // namespace saddle
