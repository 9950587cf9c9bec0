// Leaves measured on points that nobody has looked at before.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/fresh_samples.h"
#include "mesh/error/measured.h"
#include "mesh/error/peaks.h"
#include "mesh/mesher/refine.h"
#include "mesh/tree/leaf_mesh.h"

namespace saddle {

class Verifier {
 public:
  /// What is outside of the options' box does not count.
  Verifier(const Surface& surface, const Grid& grid, const Lattice& lattice,
           const RefineOptions& options)
      : surface_(surface),
        grid_(grid),
        lattice_(lattice),
        sampler_(grid, lattice),
        clip_(options.clip),
        normal_tolerance_(options.normal_tolerance),
        threads_(options.threads) {}

  /// Measures some leaves of a mesh from their triangles, of which there are as many: the largest
  /// deviation of each on a few points at random, which are the same whenever it is measured.
  void measure(Measured& mesh, std::span<const std::size_t> which, const LeafTriangles& triangles);

  std::size_t evaluations() const { return evaluations_; }

 private:
  /// Measures the leaves that are as most are. Returns the numbers in `which` of the others.
  std::vector<std::size_t> measure_plain(Measured& mesh, std::span<const std::size_t> which,
                                         const LeafTriangles& triangles, Peaks& peaks);
  /// The same with leaves of any triangles, of `others`. Returns those of their samples that are
  /// still to be measured.
  std::vector<FreshSample> measure_several(Measured& mesh, std::span<const std::size_t> which,
                                           std::span<const std::size_t> others,
                                           const LeafTriangles& triangles, Peaks& peaks);
  bool is_good(const Deviation& deviation, double allowed) const {
    return deviation.distance <= allowed && deviation.degrees <= normal_tolerance_;
  }
  void measure_one_by_one(Measured& mesh, std::span<const std::size_t> which,
                          const LeafTriangles& triangles, std::span<const FreshSample> samples);
  void measure_bends(Measured& mesh, std::span<const std::size_t> which,
                     const LeafTriangles& triangles);
  void measure_beside_creases(Measured& mesh, std::span<const std::size_t> which,
                              const LeafTriangles& triangles, std::span<const std::size_t> others);
  void add_left_out(Measured& mesh, std::size_t number, std::span<const Triangle> triangles) const;
  bool crosses_box(std::span<const Triangle> triangles) const;
  double distance_from_chord(const Chord& chord, const SurfacePoint& point) const;
  Deviation deviation_of(const Leaf& leaf, std::span<const Triangle> triangles, const dvec2& uv,
                         const SurfacePoint& point, double known) const;

  const Surface& surface_;
  const Grid& grid_;
  const Lattice& lattice_;
  Sampler sampler_;
  const std::optional<Bounds>& clip_;
  double normal_tolerance_;
  unsigned threads_;
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
