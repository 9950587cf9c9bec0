// The leaves of a mesh, their triangles and their measured errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/distance/sampled_error.h"
#include "mesh/tree/leaf_mesh.h"

namespace saddle {

/// A mark on the triangles that a leaf has now.
class TriangleMark {
 public:
  bool is_on(std::uint32_t revision) const { return revision_ == revision; }
  void put_on(std::uint32_t revision) { revision_ = revision; }

 private:
  /// That of no triangles: ~0 stands for leaves without any.
  static constexpr std::uint32_t kNever = ~std::uint32_t{0} - 1;
  std::uint32_t revision_ = kNever;
};

/// The leaves of a mesh, their tolerances, and the triangles and errors that they had when they
/// were last validated.
struct ValidatedMesh {
  std::vector<Leaf> leaves;
  /// As many as leaves, or fewer: the others are not validated yet.
  std::vector<SampledError> sampled_errors;
  std::vector<double> allowed;
  /// As many ranges as errors. Replaced triangles stay, in no range.
  LeafTriangles triangles;
  std::vector<std::uint32_t> made;     ///< revisions of the triangles: RevisionClock::next()
  std::vector<TriangleMark> proved;    ///< leaves with a proof, whole or measured
  std::vector<TriangleMark> rough;     ///< proved leaves that may hold tips below the bounds
  std::vector<TriangleMark> searched;  ///< leaves that were searched for features

  /// The revision of a leaf's triangles. Without any there is nothing to revise.
  std::uint32_t revision_of(std::size_t leaf) const {
    return triangles.ranges[leaf].count == 0 ? ~std::uint32_t{0} : made[leaf];
  }
  /// The distance of a leaf divided by its tolerance.
  double error_ratio(std::size_t leaf) const {
    return sampled_errors[leaf].distance / allowed[leaf];
  }
  /// Whether the known distance is within the tolerance.
  bool is_near(std::size_t leaf) const { return sampled_errors[leaf].distance <= allowed[leaf]; }
  /// Takes a distance found at a leaf, if it is larger than the known one. `uv`: its place on the
  /// surface; nothing for a place of the mesh.
  void add(std::size_t leaf, double distance, const std::optional<dvec2>& uv = {}) {
    SampledError& worst = sampled_errors[leaf];
    if (!(distance > worst.distance)) return;
    worst.distance = distance;
    worst.uv = uv;
  }
  /// Stores the triangles of some leaves.
  void put(std::span<const std::size_t> which, LeafTriangles newer, std::uint32_t now);
  /// The triangles of all leaves, in their order, and no others.
  Array<Triangle> all_triangles() const;
  /// Removes replaced triangles, and sorts the others by their leaves.
  void tidy_triangles();
  /// Removes leaves; `which` is ascending. The others keep their order.
  void remove(std::span<const std::size_t> which);
};

}  // namespace saddle
