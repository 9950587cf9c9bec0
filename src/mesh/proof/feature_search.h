// Searches parts of a mesh for features of the surface that samples miss, as thin ridges and
// needles: a branch and bound that follows interval bounds of the position to the largest distance.
// Source: E. Hansen, G. Walster, "Global optimization using interval analysis", 2004, chapter 12.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/bounds.h"
#include "mesh/model/mesh.h"
#include "mesh/model/placed_error.h"
#include "surface/parameter_box.h"
#include "surface/surface_enclosure.h"

namespace saddle {

/// A box of parameters and its triangles.
struct SearchedPart {
  ParameterBox box;
  std::span<const Triangle> triangles;
  Bounds around;           ///< of the triangles
  double scale = 1;        ///< of distances
  bool sticks_out = true;  ///< only features that leave `around` are looked for
  std::size_t number = 0;  ///< of the leaf or cell
};

class FeatureSearch {
 public:
  /// The distance of a position over a part from the mesh. If it is above `known`, it is exact.
  /// Called from several threads.
  using Distance = std::function<double(const SearchedPart& part, const dvec2& uv,
                                        const dvec3& position, double known)>;
  /// Scaled distances of up to `least` do not count, nor does the surface outside of `clip`, which
  /// must outlive this. `hulls`: of the surface.
  FeatureSearch(const Surface& surface, KnownHulls& hulls, Distance distance, double least,
                const std::optional<Bounds>& clip, unsigned threads)
      : surface_(surface),
        hulls_(hulls),
        distance_(std::move(distance)),
        least_(least),
        clip_(clip),
        threads_(threads),
        enclosures_(surface, Bounded::Position) {}

  /// At most `most` of `count` parts over which bounds exceed the triangles by more than `least`,
  /// those with most room first; then the other parts with the longest bounds, `others` at most, in
  /// which features need not stick out. `part`: makes a part, by its number.
  std::vector<SearchedPart> widest(std::size_t most, std::size_t others, std::size_t count,
                                   const std::function<SearchedPart(std::size_t)>& part);

  /// The largest distance found in each part, scaled. Halves the part toward the larger bounds
  /// until these tell no larger distance. Keeps the other halves for search(). The parts must
  /// outlive this.
  std::vector<PlacedError> dive(std::span<const SearchedPart> parts);

  /// Climbs from the parts in which the largest distances were found, on lines across them: from
  /// up to `most`, 8 at a time, as long as it may go on. A ridge that crosses a part aslant is too
  /// narrow for single places to follow it. `found`: what dive() found in the first of the parts.
  /// Returns the largest scaled distance of all, and drops what search() would test.
  PlacedError climb_on_lines(std::span<const SearchedPart> parts,
                             std::span<const PlacedError> found, std::size_t most,
                             const std::function<bool()>& may_go_on);

  /// Tests the other halves of all dives, the largest bounds first, up to a number of boxes.
  /// Returns the largest scaled distance of all.
  PlacedError search(std::size_t boxes);

 private:
  struct Node {
    const SearchedPart* part;
    ParameterBox box;
    int depth;
    double bound;  ///< of the scaled distance
  };
  struct Sample {
    const SearchedPart* part;
    dvec2 uv;
    double known;
  };
  /// A climb along an axis, on lines along the other one.
  struct Climb {
    const SearchedPart* part;
    int axis;
    PlacedError best;
    double step;
  };
  void climb(std::span<Climb> climbs, const std::function<bool()>& may_go_on);
  double bound_over(const SearchedPart& part, const ParameterBox& box,
                    SurfaceEnclosure& enclosure) const;
  std::vector<std::array<Node, 2>> halves_of_each(std::span<const Node> nodes);
  void keep(const Node& node);
  void take_larger(std::span<const Sample> samples, std::span<const std::size_t> numbers,
                   std::span<PlacedError> found);
  std::vector<double> distances_of(std::span<const Sample> samples) const;
  std::vector<double> measure(std::span<const Sample> samples) const;
  double limit() const;

  const Surface& surface_;
  KnownHulls& hulls_;
  Distance distance_;
  double least_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  SurfaceEnclosures enclosures_;
  std::vector<Node> open_;  // a heap
  PlacedError worst_;
};

}  // namespace saddle
