#include "mesh/color/contour_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/numbers.h"

namespace saddle {
namespace {

/// A line is halved where it is farther from its chord than this part of the tolerance: between
/// the halves' ends it is nearer.
constexpr double kChordShare = 0.5;
/// A chord longer than this in tolerances gets one vertex more unasked, so that an arc that crosses
/// its chord in the middle is seen.
constexpr double kLongChord = 8;
/// In the mesh's errors, besides the length of a side: a place is no farther from where the mesh
/// has its parameters, unless it is beyond a cut. The error is that to the nearest place.
constexpr double kAside = 8;
/// Halvings of a line in a triangle: each makes the distance a quarter.
constexpr int kMostHalvings = 12;

double distance_to_chord(const dvec3& p, const dvec3& a, const dvec3& b) {
  const dvec3 way = b - a;
  const double square = glm::dot(way, way);
  const double share = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
  return glm::distance(p, a + share * way);
}

}  // namespace

std::size_t Levels::reached_by(double number) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(levels, number + rounding) -
                                  levels.begin());
}

double Levels::above(double number, std::size_t level) const {
  const double height = number - levels[level];
  return std::abs(height) <= rounding ? 0 : height;
}

std::size_t ContourTracer::crossing(std::uint32_t a, std::uint32_t b, std::size_t level) {
  if (a > b) std::swap(a, b);
  const auto fresh = static_cast<std::uint32_t>(crossings_.size());
  const auto [known, is_new] = known_[level].insert(pair_of(a, b), fresh);
  if (is_new) {
    crossings_.push_back({mesh_.uv[a], mesh_.uv[b], levels_.above(mesh_.color[a], level),
                          levels_.above(mesh_.color[b], level), levels_.levels[level]});
    sides_.push_back({a, b});
  }
  return known;
}

std::vector<std::size_t> ContourTracer::cross_sides() {
  known_.resize(levels_.levels.size());
  std::vector<std::size_t> triangle_of;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Triangle& triangle = mesh_.triangles[t];
    std::array<std::size_t, 3> reached{};
    bool has_number = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double number = mesh_.color[triangle[k]];
      has_number = has_number && !std::isnan(number);
      if (has_number) reached[k] = levels_.reached_by(number);
    }
    if (!has_number) continue;
    const auto [least, most] = std::ranges::minmax(reached);
    for (std::size_t level = least; level < most; ++level) {
      std::size_t alone = 0;
      const auto is_above = [&](std::size_t k) { return reached[k % 3] > level; };
      while (is_above(alone) == is_above(alone + 1) || is_above(alone) == is_above(alone + 2)) {
        ++alone;
      }
      const std::uint32_t a = triangle[alone];
      const std::uint32_t b = triangle[(alone + 1) % 3];
      const std::uint32_t c = triangle[(alone + 2) % 3];
      pieces_.push_back({a, b, c, level, crossing(a, b, level), crossing(a, c, level)});
      triangle_of.push_back(t);
    }
  }
  find_level_roots(surface_, crossings_, threads_);
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const bool from = crossings_[pieces_[i].from].is_jump;
    const bool to = crossings_[pieces_[i].to].is_jump;
    if (from != to) ends.push_back(triangle_of[i]);
  }
  std::erase_if(pieces_, [this](const Piece& piece) {
    return crossings_[piece.from].is_jump || crossings_[piece.to].is_jump;
  });
  return ends;
}

std::uint32_t ContourTracer::add_vertex(const dvec2& uv, const dvec3& on_mesh, const dvec3& normal,
                                        double reach) {
  uv_.push_back(uv);
  on_mesh_.push_back(on_mesh);
  const double length = glm::length(normal);
  normal_.push_back(length > 0 ? normal / length : dvec3(0));
  reach_.push_back(reach + kAside * mesh_error_);
  return static_cast<std::uint32_t>(uv_.size() - 1);
}

/// Vertices from `first` on get their true places.
void ContourTracer::place_vertices(std::size_t first, MeshContours& contours) {
  const std::span<const dvec2> uv = std::span<const dvec2>(uv_).subspan(first);
  const std::vector<dvec3> places = evaluate_positions(surface_, uv, threads_);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const dvec3& on_mesh = on_mesh_[first + i];
    const bool is_near = glm::distance(places[i], on_mesh) <= reach_[first + i];  // NaN is not
    contours.position.push_back(is_near ? places[i] : on_mesh);
    contours.on_mesh.push_back(on_mesh);
    contours.normal.push_back(normal_[first + i]);
  }
}

void ContourTracer::trace(MeshContours& contours) {
  const auto base = static_cast<std::uint32_t>(contours.position.size());
  uv_.assign(base, {});  // numbers are those of `contours`
  on_mesh_.assign(base, {});
  normal_.assign(base, {});
  reach_.assign(base, 0);
  std::vector<std::uint32_t> vertex(crossings_.size());
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    const auto& [from, to, at_from, at_to, level, part, is_jump] = crossings_[i];
    const auto& [first, second] = sides_[i];
    const dvec3& a = mesh_.position[first];
    const dvec3& b = mesh_.position[second];
    vertex[i] =
        add_vertex(glm::mix(from, to, part), glm::mix(a, b, part),
                   glm::mix(mesh_.normal[first], mesh_.normal[second], part), glm::distance(a, b));
  }
  place_vertices(base, contours);
  std::vector<Part> parts;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    parts.push_back({i, 0, 1, vertex[pieces_[i].from], vertex[pieces_[i].to]});
  }
  inner_.assign(pieces_.size(), {});
  for (int k = 0; k < kMostHalvings && !parts.empty(); ++k) halve_parts(parts, k == 0, contours);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    std::vector<std::uint32_t> line = {vertex[pieces_[i].from]};
    std::ranges::sort(inner_[i]);
    for (const auto& [share, inner] : inner_[i]) line.push_back(inner);
    line.push_back(vertex[pieces_[i].to]);
    if (line.size() > 2 || contours.position[line[0]] != contours.position[line[1]]) {
      contours.lines.push_back(std::move(line));
    }
  }
}

/// Replaces parts that are too far from their chords by their halves, and drops the others.
void ContourTracer::halve_parts(std::vector<Part>& parts, bool always, MeshContours& contours) {
  std::vector<dvec2> across;
  for (const Part& part : parts) {
    const Piece& piece = pieces_[part.piece];
    across.push_back(glm::mix(mesh_.uv[piece.second], mesh_.uv[piece.third],
                              part.from + (part.to - part.from) / 2));
  }
  const std::vector<double> numbers = evaluate_color(surface_, across, threads_);
  std::vector<LevelBracket> brackets;
  std::vector<Part> bracketed;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Piece& piece = pieces_[parts[i].piece];
    const double here = levels_.above(mesh_.color[piece.alone], piece.level);
    const double there = levels_.above(numbers[i], piece.level);
    if (std::isnan(there) || (here >= 0) == (there >= 0)) continue;
    brackets.push_back(
        {mesh_.uv[piece.alone], across[i], here, there, levels_.levels[piece.level]});
    bracketed.push_back(parts[i]);
  }
  find_level_roots(surface_, brackets, threads_);
  const std::size_t first = uv_.size();
  std::vector<Part> found;
  for (std::size_t i = 0; i < brackets.size(); ++i) {
    if (brackets[i].is_jump) continue;
    const Piece& piece = pieces_[bracketed[i].piece];
    const double share = bracketed[i].from + (bracketed[i].to - bracketed[i].from) / 2;
    const dvec3& a = mesh_.position[piece.alone];
    const dvec3 b = glm::mix(mesh_.position[piece.second], mesh_.position[piece.third], share);
    const dvec3 normal = glm::mix(mesh_.normal[piece.second], mesh_.normal[piece.third], share);
    const double part = brackets[i].part;
    add_vertex(glm::mix(brackets[i].from, brackets[i].to, part), glm::mix(a, b, part),
               glm::mix(mesh_.normal[piece.alone], normal, part), glm::distance(a, b));
    found.push_back(bracketed[i]);
  }
  place_vertices(first, contours);
  std::vector<Part> halves;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Part& part = found[i];
    const auto middle = static_cast<std::uint32_t>(first + i);
    const dvec3& a = contours.position[part.first];
    const dvec3& b = contours.position[part.last];
    const bool is_long = always && glm::distance(a, b) > kLongChord * tolerance_;
    const double height = distance_to_chord(contours.position[middle], a, b);
    if (!is_long && height <= kChordShare * tolerance_) continue;
    const double share = part.from + (part.to - part.from) / 2;
    inner_[part.piece].emplace_back(share, middle);
    halves.push_back({part.piece, part.from, share, part.first, middle});
    halves.push_back({part.piece, share, part.to, middle, part.last});
  }
  parts = std::move(halves);
}

}  // namespace saddle
