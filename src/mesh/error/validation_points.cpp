#include "mesh/error/validation_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/common.hpp>

#include "base/numbers.h"
#include "base/random.h"
#include "mesh/distance/crease_distance.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/segment.h"
#include "mesh/model/sides.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// Points on a chord. An arc with a turning point is not highest above its middle. In leaves
/// without edge features one point is enough, since mesh/error/distance_maximizer climbs from it.
constexpr std::array kChordSamples = {0.36, 0.5, 0.64};

/// Whether a place, in sides of a leaf from its low corner, is inside of the leaf.
bool is_inside(const dvec2& part) {
  return part.x > 0 && part.x < 1 && part.y > 0 && part.y < 1;
}

/// The line through a place, across a direction, from border to border of a leaf; in its sides.
Line line_across(const dvec2& part, const dvec2& along) {
  const auto to_border = [&part](const dvec2& way) {
    double length = kInfinity;
    for (int k = 0; k < 2; ++k) {
      const double ahead = way[k] > 0 ? 1 - part[k] : part[k];
      if (way[k] != 0) length = std::min(length, ahead / std::fabs(way[k]));
    }
    return part + length * way;
  };
  const dvec2 way(-along.y, along.x);
  return {to_border(-way), to_border(way)};
}

/// A short side on the border of a leaf: the corners between which it lies, and the places straight
/// across from it, half-way and on the opposite border, in sides of the leaf.
struct ShortSide {
  std::array<std::size_t, 2> corners;
  std::array<dvec2, 2> places;
};

/// The side between two places on the border, if it is short.
std::optional<ShortSide> short_side(const dvec2& a, const dvec2& b) {
  const dvec2 way = glm::abs(b - a);
  const int along = way.x > way.y ? 0 : 1;
  if (!(way[along] <= kClose)) return std::nullopt;
  const int across = 1 - along;
  const bool is_high = a[across] > 0.5;
  ShortSide side;
  if (along == 0) {
    side.corners = is_high ? std::array<std::size_t, 2>{3, 2} : std::array<std::size_t, 2>{0, 1};
  } else {
    side.corners = is_high ? std::array<std::size_t, 2>{1, 2} : std::array<std::size_t, 2>{0, 3};
  }
  side.places.fill(0.5 * (a + b));
  side.places[0][across] = 0.5;
  side.places[1][across] = is_high ? 0 : 1;
  return side;
}

/// Whether another triangle lists a chord in a leaf. A diagonal is a side of two triangles. So is a
/// crease's chord, of one triangle in each sub-polygon, with corners of its own.
bool is_other_side(const Grid& grid, std::span<const Triangle> triangles, std::uint32_t a,
                   std::uint32_t b, bool on_crease) {
  if (!on_crease) return a > b;
  const auto& point = grid.mesh.point;
  return point[a] > point[b] && std::ranges::any_of(triangles, [&](const Triangle& t) {
           for (std::size_t k = 0; k < 3; ++k) {
             if (point[t[k]] == point[b] && point[t[(k + 1) % 3]] == point[a]) return true;
           }
           return false;
         });
}

/// Appends a sample at each point of a chord between two places in a leaf; a crease's with the line
/// across on which it is looked for.
void append_on_chord(ValidationPoint sample, const dvec2& a, const dvec2& b, const dvec2& low,
                     const dvec2& size, std::vector<ValidationPoint>& samples) {
  const auto shares = sample.crease ? std::span<const double>(kChordSamples)
                                    : std::span<const double>(kMiddleOfLine);
  for (const double share : shares) {
    sample.uv = glm::mix(a, b, share);
    if (sample.crease) {
      const auto& [first, last] = line_across((sample.uv - low) / size, (b - a) / size);
      sample.across = Line{low + size * first, low + size * last};
    }
    samples.push_back(sample);
  }
}

}  // namespace

/// One point in each quarter of a leaf, beside the quarter's middle. The error of an arc with a
/// turning point is largest there, and 0 in the arc's middle.
PlacesInLeaf validation_places(const Leaf& leaf) {
  std::uint64_t seed = 0;
  for (const std::uint32_t part : {leaf.low.u, leaf.low.v, leaf.size_u(), leaf.size_v()}) {
    seed = (seed ^ part) * 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio: spreads the bits
    seed ^= seed >> 32U;
  }
  const auto jitter = [&](std::uint64_t key) {
    return kSampleJitter * (2 * random_unit(seed + key) - 1);
  };
  return {dvec2(0.25 + jitter(0), 0.25 + jitter(1)), dvec2(0.75 + jitter(2), 0.25 + jitter(3)),
          dvec2(0.25 + jitter(4), 0.75 + jitter(5)), dvec2(0.75 + jitter(6), 0.75 + jitter(7))};
}

void PointPlacer::append(std::size_t number, const Leaf& leaf, std::span<const Triangle> triangles,
                         double allowed, std::vector<ValidationPoint>& samples) const {
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 high = tree_.vertices().parameters(leaf.high());
  // The largest error of a leaf that is aliased does not matter.
  const bool has_chords = !leaf.state.oscillates();
  const bool is_whole = leaf.state.is_whole();
  // With more than two triangles, their middles and those of their chords are enough.
  if (!(has_chords && is_whole && triangles.size() > 2)) {
    for (const dvec2& part : validation_places(leaf)) {
      samples.push_back({number, low * (1.0 - part) + high * part});
    }
  }
  // The error indicator has no sample of the narrowest leaves' middles, as at the tip of a needle,
  // and takes heights above triangles for distances: beside narrow ones it may be farther.
  if (has_chords && is_whole && (triangles.size() <= 2 || !leaf.has_middle()))
    samples.push_back({number, 0.5 * (low + high)});
  if (!is_whole) append_sides(number, leaf, triangles, samples);
  if (has_chords && is_whole) append_across(number, leaf, triangles, allowed, samples);
  if (has_chords) append_chords(number, leaf, triangles, samples);
}

/// Points at the middles of the leaf's sides and of itself: beside cliffs that cut off its corners,
/// a ridge may go through there.
void PointPlacer::append_middles(std::size_t number, const Leaf& leaf,
                                 std::vector<ValidationPoint>& samples) const {
  leaf.samples.for_middles([&](std::uint32_t vertex) {
    samples.push_back({number, grid_.mesh.uv[vertex]});
  });
}

/// Points on the sides of triangles, a quarter from their corners: an arc with a vertical tangent
/// at its end, like a square root's, is highest above the first quarter of its chord. The surface
/// ends at the edge of the domain: there its edge is compared with the side alone, beside creases,
/// too.
void PointPlacer::append_sides(std::size_t number, const Leaf& leaf,
                               std::span<const Triangle> triangles,
                               std::vector<ValidationPoint>& samples) const {
  const auto& uv = grid_.mesh.uv;
  const bool is_on_boundary = leaf.state.cut() == LeafCut::Boundary;
  const auto is_at_end = [](double a, double b, std::span<const double> lines) {
    return a == b && (a == lines.front() || a == lines.back());
  };
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Chord side = {t[k], t[(k + 1) % 3]};
      const dvec2& a = uv[side[0]];
      const dvec2& b = uv[side[1]];
      const bool is_edge = is_at_end(a.x, b.x, grid_.u) || is_at_end(a.y, b.y, grid_.v);
      if (!is_edge && !is_on_boundary) continue;
      for (const double share : kBesideMiddle) {
        samples.push_back({number, glm::mix(a, b, share), &t, true});
        if (is_edge) samples.back().crease = side;
      }
    }
  }
}

/// Points straight across a leaf from short sides on its border that stick out of it: half-way, and
/// on the opposite border. Neighbours that are much smaller have followed a ridge or groove up to
/// the leaf. The middles of triangles that fan out from there to another corner are beside it.
/// Beside edge features, neighbours are small because of those: such leaves are left out.
void PointPlacer::append_across(std::size_t number, const Leaf& leaf,
                                std::span<const Triangle> triangles, double allowed,
                                std::vector<ValidationPoint>& samples) const {
  if (triangles.size() <= 2 || tree_.edges().may_be_crossed(leaf)) return;
  const auto& position = grid_.mesh.position;
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  for_sides(leaf, tree_, [&](std::uint32_t from, std::uint32_t to) {
    const dvec2 a = (grid_.mesh.uv[from] - low) / size;
    const dvec2 b = (grid_.mesh.uv[to] - low) / size;
    const std::optional<ShortSide> side = short_side(a, b);
    if (!side) return;
    const std::uint32_t first = leaf.samples.corner[side->corners[0]];
    const std::uint32_t second = leaf.samples.corner[side->corners[1]];
    const dvec3 middle = 0.5 * (position[from] + position[to]);
    const double out = distance_from_segment(position[first], position[second], middle);
    if (!(out > allowed)) return;
    for (const dvec2& part : side->places) samples.push_back({number, low + part * size});
  });
}

/// Points at the middles of a leaf's sides, but for what is between two features. The indicator
/// covers the sides of leaves that nothing cuts: where both neighbours are cut, a side has no other
/// points.
void PointPlacer::append_border(std::size_t number, const Leaf& leaf,
                                std::span<const Triangle> triangles,
                                std::vector<ValidationPoint>& samples) const {
  const auto& uv = grid_.mesh.uv;
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Chord side = {t[k], t[(k + 1) % 3]};
      const dvec2 middle = glm::mix(uv[side[0]], uv[side[1]], kMiddleOfLine[0]);
      const dvec2 part = (middle - low) / size;
      if (!is_chord(part, side, tree_)) samples.push_back({number, middle, &t, true});
    }
  }
}

void PointPlacer::append_chords(std::size_t number, const Leaf& leaf,
                                std::span<const Triangle> triangles,
                                std::vector<ValidationPoint>& samples) const {
  const bool is_cut = leaf.state.is_cut_by_feature();
  const FeatureCount features = is_cut ? count_features(leaf, tree_) : FeatureCount();
  const bool is_creased = is_cut && features.only_creases;
  if (triangles.size() <= 2 && !is_cut) return;
  // The error indicator does not cover the diagonals of leaves with more corners, nor chords of
  // creases. Beside chords of jumps the surface may be on either level.
  const bool is_parted = is_cut && !is_creased;
  const auto& at = grid_.mesh.uv;
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  if (features.has_cliffs) append_middles(number, leaf, samples);
  if (is_parted && features.only_jumps) append_border(number, leaf, triangles, samples);
  const auto append_chord = [&](const Triangle& t, std::size_t k) {
    const std::uint32_t a = t[k];
    const std::uint32_t b = t[(k + 1) % 3];
    const dvec2 middle = (0.5 * (at[a] + at[b]) - low) / size;
    const bool inside = is_inside(middle);
    if (!inside && !is_creased) return;
    const bool is_diagonal = has_side(triangles, b, a);
    if (is_parted && !is_diagonal) return;
    // A crease along the leaf's side is beside it by rounding.
    const bool on_crease = is_creased && !is_diagonal && is_chord(middle, {a, b}, tree_);
    if (inside && is_other_side(grid_, triangles, a, b, on_crease)) return;
    ValidationPoint sample{number, {}, &t, is_cut};
    if (on_crease) sample.crease = Chord{a, b};
    append_on_chord(sample, at[a], at[b], low, size, samples);
  };
  for (const Triangle& t : triangles) {
    // Where a cliff turns from its segments, it is too near to them to be seen.
    const bool is_on_cliff =
        features.has_cliffs && std::ranges::all_of(t, [this](std::uint32_t corner) {
          return tree_.vertices().is_on_feature(corner);
        });
    samples.push_back({number, (at[t[0]] + at[t[1]] + at[t[2]]) / 3.0, &t, is_on_cliff});
    for (std::size_t k = 0; k < 3; ++k) append_chord(t, k);
  }
}

/// Points on sides between singular vertices. A cusp along a line of constant u or v has no
/// normals, from which the error indicator could take an arc above its chord.
void PointPlacer::append_singular_sides(const ValidatedMesh& mesh,
                                        std::span<const std::size_t> which,
                                        std::vector<ValidationPoint>& samples) const {
  const CellMarks& cells = tree_.geometry().singular_cells();
  const auto& at = grid_.mesh.uv;
  for (std::size_t k = 0; k < which.size(); ++k) {
    const Leaf& leaf = mesh.leaves[which[k]];
    if (!leaf.state.is_whole() || !cells.contains(leaf)) continue;
    for_sides(leaf, tree_, [&](std::uint32_t a, std::uint32_t b) {
      if (!is_cusp(a, b, tree_)) return;
      for (const double share : kChordSamples) {
        samples.push_back({k, glm::mix(at[a], at[b], share), nullptr, true, Chord{a, b}, {}});
      }
    });
  }
}

void move_onto_creases(const Surface& surface, std::vector<ValidationPoint>& samples,
                       unsigned threads) {
  std::vector<Line> lines;
  std::vector<std::size_t> numbers;  // of the samples
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!samples[k].across) continue;
    lines.push_back(*samples[k].across);
    numbers.push_back(k);
  }
  const std::vector<std::optional<CreasePlace>> places = crease_places(surface, lines, threads);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!places[k]) continue;
    ValidationPoint& sample = samples[numbers[k]];
    if (!places[k]->is_plain) {
      sample.uv = places[k]->uv;
    } else {
      const std::size_t leaf = sample.number;
      samples.push_back({leaf, places[k]->uv, nullptr, true});
    }
  }
}

}  // namespace saddle
