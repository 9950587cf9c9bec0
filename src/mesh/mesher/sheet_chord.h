// The chord of a sheet's edge between two points of its cell, and the geometry of its corner.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/vec.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/inner_vertices.h"

namespace saddle {

/// Rays per round. With the ends of its bracket, an edge has nine places.
inline constexpr std::size_t kRays = 7;
inline constexpr std::size_t kNodes = kRays + 2;

/// Where the rays of later rounds cut the chord: on either side of the foreseen corner, in parts of
/// the way from there to the end of the bracket.
inline constexpr std::array<double, kRays / 2> kBesideCorner = {0x1p-1, 0x1p-4, 0x1p-7};

/// The chord of a sheet's edge, in the unit square of its leaf.
struct SheetChord {
  std::size_t leaf;
  PolygonChord corners;
  std::array<dvec2, 2> ends;
  dvec2 from;  ///< the corner of the sub-polygon from which its edge is looked at
  /// Places of the edge, in order, and where their rays cut the chord.
  std::array<dvec2, kNodes> nodes = {};
  std::array<double, kNodes> shares = {};
  double turn = 0;  ///< at the corner, in radians
  dvec2 corner{0};
  /// The first and the last node, if any, whose rays leave the sheet through the point where it
  /// touches another one.
  std::optional<std::array<std::size_t, 2>> slipping = {};
  bool touches = false;    ///< its edge is a boundary, with such a corner
  bool is_near = false;    ///< the chord is within the tolerance; only a corner counts
  bool is_smooth = false;  ///< its edge turns too little for a corner
  bool is_open = true;     ///< its corner is looked for
  bool is_found = false;

  dvec2 at(double share) const { return glm::mix(ends[0], ends[1], share); }
};

/// The angle from one direction to another, in radians, 0 where one has no length.
inline double turn_between(const dvec2& a, const dvec2& b) {
  return std::atan2(cross(a, b), glm::dot(a, b));
}

inline double distance_from_chord_of(const SheetChord& chord, const dvec2& place) {
  const dvec2 way = chord.ends[1] - chord.ends[0];
  return std::fabs(cross(way, place - chord.ends[0])) / glm::length(way);
}

/// Calls f(chords) for each leaf; chords of a leaf follow one another.
template <class F>
void for_leaves_of(std::span<const SheetChord> chords, F f) {
  const auto is_of_other = [](const SheetChord& a, const SheetChord& b) {
    return a.leaf != b.leaf;
  };
  for (auto begin = chords.begin(); begin != chords.end();) {
    auto end = std::adjacent_find(begin, chords.end(), is_of_other);
    if (end != chords.end()) ++end;
    f(std::span(begin, end));
    begin = end;
  }
}

/// The chord of a leaf with the sharpest corner, or else the one whose edge is farthest from it;
/// nullptr if no place was found.
inline const SheetChord* main_chord(std::span<const SheetChord> chords) {
  const SheetChord* main = nullptr;
  for (const SheetChord& chord : chords) {
    if (!chord.is_found) continue;
    const auto rank = [](const SheetChord& c) {
      return std::pair(c.turn, distance_from_chord_of(c, c.corner));
    };
    if (main == nullptr || rank(chord) > rank(*main)) main = &chord;
  }
  return main;
}

/// Whether a place is clearly on the side of a chord where its sheet is.
inline bool is_on_sheet_side(const SheetChord& chord, const dvec2& place) {
  return cross(chord.ends[1] - chord.ends[0], place - chord.ends[0]) > kNearly;
}

/// Where lines through a and b, and through c and d, meet.
inline std::optional<dvec2> intersection(const dvec2& a, const dvec2& b, const dvec2& c,
                                         const dvec2& d) {
  const double area = cross(b - a, d - c);
  const dvec2 place = a + (b - a) * (cross(c - a, d - c) / area);
  return std::isfinite(place.x) && std::isfinite(place.y) ? std::optional(place) : std::nullopt;
}

/// Where the ray through a place cuts the chord, as a share of it.
inline double share_of(const SheetChord& chord, const dvec2& place) {
  const dvec2 way = chord.ends[1] - chord.ends[0];
  const dvec2 ray = place - chord.from;
  return cross(chord.from - chord.ends[0], ray) / cross(way, ray);
}

/// The bracket of a corner between two nodes, with rays of the next round on either side of where
/// it is foreseen on the chord.
inline void set_bracket(std::size_t first, std::size_t last, double corner, SheetChord& chord) {
  std::array<double, kNodes> shares;
  shares.front() = chord.shares[first];
  shares.back() = chord.shares[last];
  shares[kNodes / 2] = corner;
  for (std::size_t k = 0; k < kBesideCorner.size(); ++k) {
    shares[k + 1] = corner - (corner - shares.front()) * kBesideCorner[k];
    shares[kRays - k] = corner + (shares.back() - corner) * kBesideCorner[k];
  }
  const dvec2 back = chord.nodes[last];
  chord.nodes.front() = chord.nodes[first];
  chord.nodes.back() = back;
  chord.shares = shares;
}

}  // namespace saddle
