// Lines of parameters through places of a mesh, along which the surface is searched for what is
// nearest to each place.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "mesh/model/nearest_on_line.h"
#include "mesh/model/placed_error.h"

namespace saddle {

/// For each place there are both lines of parameters, the lines to its triangle's corners, and
/// others. Both lines of parameters start
/// from samples within the triangle's own extent, too: a triangle along a ridge is much longer than
/// the ridge is wide. A line is sampled only where the samples of those before it are too far off.
class LinesThroughPlaces {
 public:
  /// `least`: a place within that is near enough. `shortest`: a part of a line that is not halved.
  LinesThroughPlaces(double least, double shortest, bool has_cliffs)
      : least_(least), shortest_(shortest), has_cliffs_(has_cliffs) {}

  /// `corners`: of its triangle. `reach`: how far the lines of parameters go to both sides.
  void add_place(const dvec3& position, const dvec2& uv, const std::array<dvec2, 3>& corners,
                 const dvec2& reach);

  /// Chooses the first places at which the surface is asked for.
  void begin();
  /// The places that are chosen now, also outside of the domain.
  std::vector<dvec2> places() const;
  void add_samples(std::span<const dvec3> points);
  /// Chooses the places that follow those of a round, of which there are kRounds at most.
  void go_on(std::size_t round);
  bool is_done() const { return tries_.empty(); }
  static const std::size_t kRounds;

  /// Replaces the nearest place of the surface that is known of a place, if a line has a nearer
  /// one.
  void improve(std::size_t place, PlacedError& nearest) const;

 private:
  void begin(std::size_t k);
  void halve(std::size_t first, std::size_t end);

  double least_;
  double shortest_;
  bool has_cliffs_;
  std::vector<NearestOnLine> lines_;  // as many of each place
  std::vector<double> own_;           // the triangle's own extent, as a share of each line
  std::vector<std::pair<std::size_t, double>> tries_;  // a line, and a place on it
};

}  // namespace saddle
