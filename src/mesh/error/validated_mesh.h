// The leaves of a mesh, their triangles and their measured errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "mesh/distance/sampled_error.h"
#include "mesh/tree/leaf_mesh.h"

namespace saddle {

/// Findings about the triangles that a leaf has now.
struct TriangleMarks {
  bool is_proved : 1 = false;    ///< whole or measured
  bool is_rough : 1 = false;     ///< proved, but may hold tips below the bounds
  bool is_searched : 1 = false;  ///< searched for features
};

/// The places of some sampled errors, by SampledError::place. Threads may set those of different
/// errors at the same time.
class ErrorPlaces {
 public:
  /// `uv`: nothing for an error that has none.
  void set(const std::optional<dvec2>& uv, SampledError& error);
  std::optional<dvec2> of(const SampledError& error) const {
    return error.place == kNoIndex ? std::nullopt : std::optional(places_[error.place]);
  }
  /// Forgets the places of other errors than these.
  void keep(std::span<SampledError> errors);

 private:
  std::vector<dvec2> places_;
  std::mutex mutex_;
};

/// The leaves of a mesh, their tolerances, and the triangles and errors that they had when they
/// were last validated.
struct ValidatedMesh {
  std::vector<Leaf> leaves;
  /// As many as leaves, or fewer: the others are not validated yet.
  std::vector<SampledError> sampled_errors;
  ErrorPlaces error_places;
  std::vector<double> allowed;
  /// As many ranges as errors. Replaced triangles stay, in no range.
  LeafTriangles triangles;
  std::vector<std::uint32_t> made;  ///< revisions of the triangles: RevisionClock::next()
  std::vector<TriangleMarks> marks;

  /// The distance of a leaf divided by its tolerance.
  double error_ratio(std::size_t leaf) const {
    return sampled_errors[leaf].distance / allowed[leaf];
  }
  /// Whether the known distance is within the tolerance.
  bool is_near(std::size_t leaf) const { return sampled_errors[leaf].distance <= allowed[leaf]; }
  /// The place of the distance on the surface; nothing at a validation place of a plain leaf, or of
  /// the mesh.
  std::optional<dvec2> error_place(std::size_t leaf) const {
    return error_places.of(sampled_errors[leaf]);
  }
  /// Takes a distance found at a leaf, if it is larger than the known one. `uv`: its place on the
  /// surface; nothing for a place of the mesh. Threads may add to different leaves at the same
  /// time.
  void add(std::size_t leaf, double distance, const std::optional<dvec2>& uv = {});
  /// Makes room for what is stored of the leaves, and of an eighth more: later rounds add few.
  /// Room that is not used costs no memory.
  void reserve();
  /// Stores the triangles of some leaves. A leaf keeps its marks if its triangles had the same
  /// revision, or if it had none and has none.
  void put(std::span<const std::size_t> which, LeafTriangles newer, std::uint32_t revision);
  /// Removes replaced triangles, and sorts the others by their leaves.
  void tidy_triangles();
  /// Removes leaves; `which` is ascending. The others keep their order.
  void remove(std::span<const std::size_t> which);
};

}  // namespace saddle
