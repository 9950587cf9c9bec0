#include "mesh/verify.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include <glm/common.hpp>

#include "base/random.h"
#include "mesh/crease_distance.h"
#include "mesh/measure_many.h"
#include "mesh/rim_distance.h"
#include "mesh/sharp_bends.h"

namespace saddle {

namespace {

/// One fresh sample in each quarter of a leaf, up to this part of its sides from the quarter's
/// middle: there the error of an arc with a turning point is largest, which its middle does not
/// show.
constexpr double kJitter = 0.1;

/// Samples on a chord. An arc with a turning point is not highest above its middle; but mesh/peaks
/// goes from there to where more is foreseen, in leaves that nothing cuts.
constexpr std::array kOnChord = {0.36, 0.5, 0.64};
constexpr std::span<const double> kInMiddle = std::span(kOnChord).subspan(1, 1);

/// Leaves of several triangles that are measured together, on some ten samples each: what is known
/// of these (170 bytes) stays in the second-level cache.
constexpr std::size_t kAtATime = 400;
/// Samples of most of them.
constexpr std::size_t kSamples = 8;

/// How far from its chord a crease is looked for, in chords.
constexpr double kBesideCrease = 0.3;

/// Samples on the sides of triangles at a rim: an arc with a vertical tangent at its end, as sqrt
/// has, is highest above the first quarter of its chord.
constexpr std::array kBesideRim = {0.25, 0.75};

/// Where a leaf is measured: always the same for the same leaf.
PlacesInLeaf sample_places(const Leaf& leaf) {
  std::uint64_t seed = 0;
  for (const std::uint32_t part : {leaf.low.u, leaf.low.v, leaf.size_u(), leaf.size_v()}) {
    seed = (seed ^ part) * 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio: spreads the bits
    seed ^= seed >> 32U;
  }
  const auto jitter = [&](std::uint64_t key) {
    return kJitter * (2 * random_unit(seed + key) - 1);
  };
  return {dvec2(0.25 + jitter(0), 0.25 + jitter(1)), dvec2(0.75 + jitter(2), 0.25 + jitter(3)),
          dvec2(0.25 + jitter(4), 0.75 + jitter(5)), dvec2(0.75 + jitter(6), 0.75 + jitter(7))};
}

/// Whether a place, in sides of a leaf from its low corner, is in it and not on its border.
bool is_inside(const dvec2& part) {
  return part.x > 0 && part.x < 1 && part.y > 0 && part.y < 1;
}

bool share_corner(const Triangle& a, const Triangle& b) {
  return std::ranges::any_of(
      a, [&](std::uint32_t corner) { return std::ranges::find(b, corner) != b.end(); });
}

/// The third corner of the triangle that runs from corner a to corner b.
std::optional<std::uint32_t> apex_beyond(std::span<const Triangle> triangles, std::uint32_t a,
                                         std::uint32_t b) {
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == a && t[(k + 1) % 3] == b) return t[(k + 2) % 3];
    }
  }
  return std::nullopt;
}

/// Whether a chord in a leaf is told of by another triangle: a diagonal is a side of two, and so is
/// the chord of a crease, of one in each piece with corners of its own.
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

/// Triangles from the front that are connected; those of a leaf's pieces follow each other.
std::size_t count_connected(std::span<const Triangle> triangles) {
  std::size_t count = 1;
  const auto is_connected = [&](const Triangle& t) {
    return std::ranges::any_of(triangles.first(count),
                               [&](const Triangle& other) { return share_corner(t, other); });
  };
  while (count < triangles.size() && is_connected(triangles[count])) ++count;
  return count;
}

/// The triangle that a place is in, and the one beyond its nearest side, if that is one of them.
/// `known`: the triangle, or nullptr.
PlaceOnTriangle on_triangle(const Grid& grid, std::span<const Triangle> triangles,
                            const Triangle* known, const dvec2& uv) {
  const auto& [below, weights] =
      triangle_below(grid, known != nullptr ? std::span(known, 1) : triangles, uv);
  const Triangle& own = *below;
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (weights[static_cast<int>(k)] < weights[static_cast<int>(least)]) least = k;
  }
  // In the triangle's order, with the nearest side from the third to the first.
  const std::array<std::size_t, 3> order = {(least + 2) % 3, least, (least + 1) % 3};
  PlaceOnTriangle place{uv, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    place.corners[(k + 2) % 4] = own[order[k]];
    place.weights[static_cast<int>(k)] = weights[static_cast<int>(order[k])];
  }
  place.corners[1] =
      apex_beyond(triangles, place.corners[2], place.corners[0]).value_or(place.corners[3]);
  return place;
}

}  // namespace

/// Where a leaf is cut, its pieces meet along a chord of the true line: what lies between the two
/// is no farther from the surface than the other piece, and faces as that one does.
Deviation Verifier::deviation_of(const Leaf& leaf, std::span<const Triangle> triangles,
                                 const dvec2& uv, const SurfacePoint& point, double known) const {
  if (!leaf.is_split || triangles.empty())
    return deviation(grid_, triangles, uv, point, surface_.flip, known);
  Deviation best{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  while (!triangles.empty()) {
    const std::size_t count = count_connected(triangles);
    const Deviation d = deviation(grid_, triangles.first(count), uv, point, surface_.flip, known);
    best.distance = std::min(best.distance, d.distance);
    best.degrees = std::min(best.degrees, d.degrees);
    triangles = triangles.subspan(count);
  }
  return best;
}

void Verifier::append_samples(std::size_t number, const Leaf& leaf,
                              std::span<const Triangle> triangles,
                              std::vector<Sample>& samples) const {
  const dvec2 low = lattice_.parameters(leaf.low);
  const dvec2 high = lattice_.parameters(leaf.high);
  // Of a leaf that is off by whole waves nobody needs to know where most.
  const bool has_chords = !leaf.oscillates;
  const bool is_whole = !leaf.is_split && !leaf.on_rim;
  // The middles of more triangles, and of the chords between them, are fresh enough.
  if (!(has_chords && is_whole && triangles.size() > 2)) {
    for (const dvec2& part : sample_places(leaf)) {
      samples.push_back({number, low * (1.0 - part) + high * part});
    }
  }
  if (leaf.on_rim && !leaf.is_split) append_sides(number, triangles, samples);
  if (has_chords) append_chords(number, leaf, triangles, samples);
}

/// On the sides of triangles, beside their corners.
void Verifier::append_sides(std::size_t number, std::span<const Triangle> triangles,
                            std::vector<Sample>& samples) const {
  const auto& uv = grid_.mesh.uv;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double share : kBesideRim) {
        samples.push_back({number, glm::mix(uv[t[k]], uv[t[(k + 1) % 3]], share), &t, true});
      }
    }
  }
}

void Verifier::append_chords(std::size_t number, const Leaf& leaf,
                             std::span<const Triangle> triangles,
                             std::vector<Sample>& samples) const {
  const bool is_creased = leaf.is_split && count_cuts(leaf, lattice_).only_creases;
  if (triangles.size() <= 2 && !is_creased) return;
  // The diagonals of a leaf with more corners were not tested, nor the chords of a crease. Beside
  // chords of jumps the surface may be on either level.
  const auto& at = grid_.mesh.uv;
  const dvec2 low = lattice_.parameters(leaf.low);
  const dvec2 size = lattice_.parameters(leaf.high) - low;
  const auto append_chord = [&](const Triangle& t, std::size_t k) {
    const std::uint32_t a = t[k];
    const std::uint32_t b = t[(k + 1) % 3];
    const bool inside = is_inside((0.5 * (at[a] + at[b]) - low) / size);
    if (!inside && !is_creased) return;
    const bool on_crease = inside && is_creased && !apex_beyond(triangles, b, a);
    if (inside && is_other_side(grid_, triangles, a, b, on_crease)) return;
    Sample sample{number, {}, &t, leaf.is_split};
    if (on_crease) {
      const dvec2 along = (at[b] - at[a]) / size;
      sample.crease = Chord{a, b};
      sample.across = kBesideCrease * size * dvec2(-along.y, along.x);
    }
    for (const double share : on_crease ? kOnChord : kInMiddle) {
      sample.uv = glm::mix(at[a], at[b], share);
      samples.push_back(sample);
    }
  };
  for (const Triangle& t : triangles) {
    if (triangles.size() > 2) {
      samples.push_back({number, (at[t[0]] + at[t[1]] + at[t[2]]) / 3.0, &t});
    }
    if (leaf.is_split && !is_creased) continue;
    for (std::size_t k = 0; k < 3; ++k) append_chord(t, k);
  }
}

/// On sides between singular vertices: a cusp that is a line of constant u or v has no normals from
/// which an arc above its chord would follow.
void Verifier::append_singular_sides(const Measured& mesh, std::span<const std::size_t> which,
                                     std::vector<Sample>& samples) const {
  if (!lattice_.has_singular()) return;
  const CellMarks& cells = lattice_.singular_cells();
  const auto& at = grid_.mesh.uv;
  for (std::size_t k = 0; k < which.size(); ++k) {
    const Leaf& leaf = mesh.leaves[which[k]];
    if (leaf.is_split || leaf.on_rim || !cells.contains(leaf)) continue;
    for_sides(leaf, lattice_, [&](std::uint32_t a, std::uint32_t b) {
      if (!is_cusp(a, b, lattice_)) return;
      for (const double share : kOnChord) {
        samples.push_back({k, glm::mix(at[a], at[b], share), nullptr, true, Chord{a, b}, {}});
      }
    });
  }
}

/// Samples on chords of cusps, and of creases at which the surface is upright, go to where those
/// are: they run beside their chords, and how far the surface is from them makes up for that in
/// part.
void Verifier::move_onto_creases(std::vector<Sample>& samples) const {
  std::vector<Line> lines;
  for (const Sample& sample : samples) {
    if (sample.crease) lines.push_back({sample.uv - sample.across, sample.uv + sample.across});
  }
  if (lines.empty()) return;
  const std::vector<dvec2> places = crease_places(surface_, lines, threads_);
  std::size_t next = 0;
  for (Sample& sample : samples) {
    if (sample.crease) sample.uv = places[next++];
  }
}

/// Whether a corner of triangles is beyond a face of the box, where a rim may go anywhere.
bool Verifier::crosses_box(std::span<const Triangle> triangles) const {
  return clip_ && std::ranges::any_of(triangles, [this](const Triangle& t) {
           return std::ranges::any_of(t, [this](std::uint32_t corner) {
             return !clip_->contains(grid_.mesh.position[corner]);
           });
         });
}

/// Of a point that is as good as on a crease, from the crease's chord: along the chord is none.
double Verifier::distance_from_chord(const Chord& chord, const SurfacePoint& point) const {
  const dvec3 first = grid_.local(chord[0]);
  const dvec3 edge = grid_.local(chord[1]) - first;
  const dvec3 off = grid_.local_scale * point.position - first;
  const double square = glm::dot(edge, edge);
  if (!(square > 0) || !is_finite(off)) return 0;
  return glm::length(off - glm::dot(off, edge) / square * edge) / grid_.local_scale;
}

std::vector<std::size_t> Verifier::measure_plain(Measured& mesh, std::span<const std::size_t> which,
                                                 const LeafTriangles& triangles, Peaks& peaks) {
  std::vector<TwoTriangles> plain;
  std::vector<std::size_t> numbers;  // of those, in `which`
  std::vector<std::size_t> others;
  plain.reserve(which.size());
  numbers.reserve(which.size());
  for (std::size_t k = 0; k < which.size(); ++k) {
    if (!triangles.ranges[k].is_plain) {
      others.push_back(k);
      continue;
    }
    const Leaf& leaf = mesh.leaves[which[k]];
    const auto two = triangles.of(k);
    numbers.push_back(k);
    plain.push_back({lattice_.parameters(leaf.low),
                     lattice_.parameters(leaf.high),
                     {two[0], two[1]},
                     sample_places(leaf)});
  }
  const auto deviations = measure_many(surface_, grid_, plain, threads_);
  evaluations_ += kPlacesInLeaf * plain.size();
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const std::size_t number = numbers[i];
    const std::size_t leaf = which[number];
    // Of what is off there may be nothing in the box.
    if (!deviations[i] || (clip_ && deviations[i]->worst.distance > mesh.allowed[leaf])) {
      others.push_back(number);
      continue;
    }
    mesh.deviations[leaf] = deviations[i]->worst;
    if (!is_worth_a_look(mesh, leaf, deviations[i]->foreseen)) continue;
    for (const dvec2& part : plain[i].places) {
      peaks.add(leaf, triangles.of(number), glm::mix(plain[i].low, plain[i].high, part));
    }
  }
  return others;
}

std::vector<Verifier::Sample> Verifier::measure_several(Measured& mesh,
                                                        std::span<const std::size_t> which,
                                                        std::span<const std::size_t> others,
                                                        const LeafTriangles& triangles,
                                                        Peaks& peaks) {
  std::vector<Sample> rest;
  std::vector<Sample> samples;
  std::vector<PlaceOnTriangle> places;
  samples.reserve(kSamples * others.size());
  places.reserve(kSamples * others.size());
  for (const std::size_t k : others) {
    const Leaf& leaf = mesh.leaves[which[k]];
    const std::span<const Triangle> of_leaf = triangles.of(k);
    mesh.deviations[which[k]] = {};
    append_samples(k, leaf, of_leaf, samples);
    const bool is_special = clip_ || leaf.on_rim || of_leaf.empty();
    if (is_special || leaf.is_split) {
      const auto first = samples.begin() + static_cast<std::ptrdiff_t>(places.size());
      const auto one_by_one = std::stable_partition(
          first, samples.end(), [&](const Sample& s) { return !is_special && !s.crease; });
      rest.insert(rest.end(), one_by_one, samples.end());
      samples.erase(one_by_one, samples.end());
    }
    for (std::size_t s = places.size(); s < samples.size(); ++s) {
      places.push_back(on_triangle(grid_, of_leaf, samples[s].triangle, samples[s].uv));
    }
  }
  const auto found = measure_places(surface_, grid_, places, threads_);
  evaluations_ += places.size();
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const Sample& sample = samples[s];
    const std::size_t leaf = which[sample.number];
    // Of a leaf that is cut another piece may be nearer.
    const bool is_known =
        found[s] && (!mesh.leaves[leaf].is_split || is_good(found[s]->worst, mesh.allowed[leaf]));
    if (!is_known) {
      rest.push_back(sample);
      continue;
    }
    Deviation& worst = mesh.deviations[leaf];
    worst.distance = std::max(worst.distance, found[s]->worst.distance);
    if (!sample.beside_cut) worst.degrees = std::max(worst.degrees, found[s]->worst.degrees);
    if (!mesh.leaves[leaf].is_split && is_worth_a_look(mesh, leaf, found[s]->foreseen)) {
      peaks.add(leaf, triangles.of(sample.number), sample.uv);
    }
  }
  return rest;
}

void Verifier::measure_one_by_one(Measured& mesh, std::span<const std::size_t> which,
                                  const LeafTriangles& triangles, std::span<const Sample> samples) {
  std::vector<dvec2> uv(samples.size());
  std::ranges::transform(samples, uv.begin(), &Sample::uv);
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += points.size();
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const auto& [k, place, triangle, beside_cut, crease, across] = samples[s];
    const Leaf& leaf = mesh.leaves[which[k]];
    Deviation& worst = mesh.deviations[which[k]];
    const auto of_leaf = triangles.of(k);
    const Seen seen = seen_at(clip_, grid_, of_leaf, place, points[s].position);
    if (!seen.surface && !seen.triangles) continue;
    Deviation d = crease ? Deviation{distance_from_chord(*crease, points[s]), 0, true}
                         : deviation_of(leaf, of_leaf, place, points[s], worst.distance);
    // Triangles that are cut away there are beside the surface elsewhere.
    if (!seen.triangles && !crease) {
      d.distance = distance_from(grid_, of_leaf, place, points[s].position);
    }
    if (d.distance > worst.distance) worst = {d.distance, worst.degrees, d.on_crease};
    if (!beside_cut) worst.degrees = std::max(worst.degrees, d.degrees);
  }
}

/// Leaves that nothing cuts, once more where the surface turns sharply in them.
void Verifier::measure_bends(Measured& mesh, std::span<const std::size_t> which,
                             const LeafTriangles& triangles) {
  SharpBends bends(surface_, grid_, lattice_, threads_);
  for (std::size_t k = 0; k < which.size(); ++k) {
    const Leaf& leaf = mesh.leaves[which[k]];
    if (leaf.is_split || leaf.on_rim || clip_) continue;
    bends.add(mesh, which[k], triangles.of(k));
  }
  bends.measure(mesh);
  evaluations_ += bends.evaluations();
}

/// How far triangles beside creases are off the surface, from the middles of diagonals: beside a
/// cusp the surface turns too much for heights along its normals.
void Verifier::measure_beside_creases(Measured& mesh, std::span<const std::size_t> which,
                                      const LeafTriangles& triangles,
                                      std::span<const std::size_t> others) {
  std::vector<MiddleOfChord> chords;
  std::vector<std::size_t> leaves;  // of each
  const Mesh& of = grid_.mesh;
  for (const std::size_t k : others) {
    const Leaf& leaf = mesh.leaves[which[k]];
    if (!leaf.is_split || !count_cuts(leaf, lattice_).only_creases) continue;
    if (crosses_box(triangles.of(k))) continue;
    const dvec2 size = lattice_.parameters(leaf.high) - lattice_.parameters(leaf.low);
    for (const Triangle& t : triangles.of(k)) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i];
        const std::uint32_t b = t[(i + 1) % 3];
        if (a > b || !apex_beyond(triangles.of(k), b, a)) continue;
        chords.push_back({{of.position[a], of.position[b]},
                          {of.uv[a], of.uv[b]},
                          glm::abs(size),
                          mesh.allowed[which[k]],
                          mesh.deviations[which[k]].distance});
        leaves.push_back(which[k]);
      }
    }
  }
  const std::vector<double> distances = distances_from_surface(surface_, chords, threads_);
  for (std::size_t k = 0; k < chords.size(); ++k) {
    mesh.add(leaves[k], distances[k]);
  }
}

/// Corners of triangles without area, which are left out: what they stood for has an end that may
/// stick out of the others.
void Verifier::add_left_out(Measured& mesh, std::size_t number,
                            std::span<const Triangle> triangles) const {
  const Leaf& leaf = mesh.leaves[number];
  if (leaf.on_rim || leaf.is_split || triangles.empty()) return;
  if (triangles.size() + 2 >= leaf.outline) return;
  const auto& point = grid_.mesh.point;
  for_sides(leaf, lattice_, [&](std::uint32_t vertex, std::uint32_t) {
    const auto has_it = [&](const Triangle& t) {
      return std::ranges::any_of(t, [&](auto corner) { return point[corner] == point[vertex]; });
    };
    const dvec3& position = grid_.mesh.position[vertex];
    if (std::ranges::any_of(triangles, has_it)) return;
    if (clip_ && !clip_->contains(position)) return;
    mesh.add(number, distance_from(grid_, triangles, grid_.mesh.uv[vertex], position));
  });
}

void Verifier::measure(Measured& mesh, std::span<const std::size_t> which,
                       const LeafTriangles& triangles) {
  mesh.deviations.resize(mesh.leaves.size());
  for (std::size_t k = 0; k < which.size(); ++k) {
    Leaf& leaf = mesh.leaves[which[k]];
    leaf.outline = triangles.ranges[k].is_plain ? 4 : count_outline(leaf, lattice_);
  }
  Peaks peaks(surface_, grid_, clip_, threads_);
  const std::vector<std::size_t> others = measure_plain(mesh, which, triangles, peaks);
  std::vector<Sample> rest;
  for (std::size_t begin = 0; begin < others.size(); begin += kAtATime) {
    const auto some = std::span(others).subspan(begin, std::min(kAtATime, others.size() - begin));
    const std::vector<Sample> more = measure_several(mesh, which, some, triangles, peaks);
    rest.insert(rest.end(), more.begin(), more.end());
  }
  move_onto_creases(rest);
  append_singular_sides(mesh, which, rest);
  measure_one_by_one(mesh, which, triangles, rest);
  peaks.climb(mesh);
  evaluations_ += peaks.evaluations();
  measure_bends(mesh, which, triangles);
  measure_beside_creases(mesh, which, triangles, others);
  for (const std::size_t k : others) add_left_out(mesh, which[k], triangles.of(k));
  RimDistance rims(surface_, grid_, lattice_, clip_, threads_);
  for (const std::size_t k : others) {
    if (!crosses_box(triangles.of(k))) rims.add(mesh.leaves[which[k]], which[k], triangles.of(k));
  }
  for (const auto& [leaf, distance] : rims.measure()) mesh.add(leaf, distance);
  evaluations_ += rims.evaluations();
}

}  // namespace saddle
