#include "export/page/page_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "export/page/page_triangles.h"
#include "render/shading/colormap_textures.h"
#include "scene/model/colormap.h"
#include "scene/model/prepare.h"

namespace saddle {
namespace {

constexpr double kMostWord = 65535;
/// The steps of a parameter's range: a power of two, as leaves are halves of halves.
constexpr double kSteps = 65536;
/// Normals of formulas that differ by less light a surface alike: a third of a degree.
constexpr double kSameNormal = 0.006;
/// A mesh of which the formulas know fewer corners than this share is on another surface.
constexpr double kKnownShare = 0.5;

class Bytes {
 public:
  void varint(std::uint64_t value) {
    for (; value > 127; value /= 128) text_ += static_cast<char>(value % 128 + 128);
    text_ += static_cast<char>(value);
  }
  void signed_varint(std::int64_t value) {
    varint(value < 0 ? 2 * static_cast<std::uint64_t>(-value) - 1
                     : 2 * static_cast<std::uint64_t>(value));
  }
  /// Differences, low bytes first, then high bytes: deflate finds more in them.
  void words(const std::vector<std::uint16_t>& words) {
    std::string high;
    std::uint16_t last = 0;
    for (const std::uint16_t word : words) {
      const auto difference = static_cast<std::uint16_t>(word - last);
      text_ += static_cast<char>(difference & 255);
      high += static_cast<char>(difference >> 8);
      last = word;
    }
    text_ += high;
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// How far a place is between two ends.
double share_of(double value, double from, double to) {
  return to != from ? std::clamp((value - from) / (to - from), 0.0, 1.0) : 0;
}

/// The 16 bits of a place between two ends; the ends are exact.
std::uint16_t word_of(double value, double from, double to) {
  return static_cast<std::uint16_t>(std::lround(kMostWord * share_of(value, from, to)));
}

std::int64_t step_of(double value, double from, double to) {
  return std::lround(kSteps * share_of(value, from, to));
}

/// Chains of vertices, each by its distance from the one before in the order of the page.
void write_lines(Bytes& bytes, const std::vector<std::vector<std::uint32_t>>& lines,
                 const PageTriangles& order) {
  bytes.varint(lines.size());
  std::uint32_t last = 0;
  for (const auto& line : lines) {
    bytes.varint(line.size());
    for (const std::uint32_t corner : line) {
      bytes.signed_varint(static_cast<std::int64_t>(order.place[corner]) - last);
      last = order.place[corner];
    }
  }
}

/// The differences from what the corners before let guess.
void write_steps(Bytes& bytes, const std::vector<std::int64_t>& steps,
                 const std::vector<PageTriangles::Guess>& guesses) {
  if (steps.empty()) return;
  bytes.signed_varint(steps[0]);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const auto [a, b, c] = guesses[i - 1];
    bytes.signed_varint(steps[i] - (steps[a] + steps[b] - steps[c]));
  }
}

void write_places(Bytes& bytes, const std::vector<dvec3>& places, const Bounds& box) {
  for (int k = 0; k < 3; ++k) {
    std::vector<std::uint16_t> words;
    words.reserve(places.size());
    for (const dvec3& p : places) words.push_back(word_of(p[k], box.low[k], box.high[k]));
    bytes.words(words);
  }
}

/// The sphere folded onto an octahedron, and that onto a square.
/// Source: Q. Meyer and others, "On floating-point normal vectors", 2010.
void write_normals(Bytes& bytes, const std::vector<dvec3>& normals) {
  std::array<std::vector<std::uint16_t>, 2> words;
  for (const dvec3& n : normals) {
    const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    dvec2 p = sum > 0 ? dvec2(n.x, n.y) / sum : dvec2(0);
    if (n.z < 0) {
      p = {(1 - std::abs(p.y)) * (p.x < 0 ? -1 : 1), (1 - std::abs(p.x)) * (p.y < 0 ? -1 : 1)};
    }
    words[0].push_back(word_of(p.x, -1, 1));
    words[1].push_back(word_of(p.y, -1, 1));
  }
  bytes.words(words[0]);
  bytes.words(words[1]);
}

dvec3 normal_of(const SurfacePoint& point, bool flip) {
  const dvec3 n = glm::cross(point.r_u, point.r_v) * (flip ? -1.0 : 1.0);
  return n / std::hypot(n.x, n.y, n.z);
}

bool is_near(const dvec3& a, const dvec3& b, double within) {
  const dvec3 way = a - b;
  return std::hypot(way.x, way.y, way.z) <= within;  // not where the formula is undefined
}

/// Writes numbers that rise, each by how far it is above the one before.
void write_rising(Bytes& bytes, std::span<const std::uint32_t> numbers) {
  bytes.varint(numbers.size());
  std::uint32_t last = 0;
  for (const std::uint32_t number : numbers) {
    bytes.varint(number - last);
    last = number;
  }
}

}  // namespace

PageMesh page_mesh(const Scene& scene, const SurfaceSpec& spec, const Mesh& mesh, double within) {
  const Surface surface = prepare_surface(scene, spec).surface;
  const Domain& d = surface.domain;
  const PageTriangles order = page_triangles(mesh);
  std::vector<dvec2> exact;
  for (const std::uint32_t corner : order.corners) exact.push_back(mesh.uv[corner]);
  take_own_parameters(surface, exact);
  std::array<std::vector<std::int64_t>, 2> steps;
  std::vector<dvec2> rounded;
  for (const dvec2& uv : exact) {
    steps[0].push_back(step_of(uv.x, d.u0, d.u1));
    steps[1].push_back(step_of(uv.y, d.v0, d.v1));
    rounded.push_back(d.at(dvec2(steps[0].back(), steps[1].back()) / kSteps));
  }
  const std::vector<SurfacePoint> points = evaluate(surface, rounded);
  const std::vector<dvec3> there = evaluate_positions(surface, exact);

  PageMesh result;
  result.box = mesh.bounds;
  for (const dvec3& p : mesh.contours.position) result.box.add(p);
  Bytes bytes;
  bytes.varint(order.corners.size());
  bytes.varint(mesh.triangles.size());
  for (const std::uint32_t code : order.codes) bytes.varint(code);
  for (const auto& all : steps) write_steps(bytes, all, order.guesses);

  std::vector<std::uint32_t> baked;
  std::vector<dvec3> positions;
  std::vector<dvec3> normals;
  std::size_t known = 0;
  for (std::uint32_t i = 0; i < order.corners.size(); ++i) {
    const dvec3& position = mesh.position[order.corners[i]];
    const dvec3& normal = mesh.normal[order.corners[i]];
    if (is_near(there[i], position, within)) ++known;
    const bool has_normal =
        mesh.triangles.empty() || is_near(normal_of(points[i], surface.flip), normal, kSameNormal);
    if (has_normal && is_near(points[i].position, position, within)) continue;
    baked.push_back(i);
    positions.push_back(position);
    normals.push_back(normal);
  }
  result.fixed = static_cast<double>(known) < kKnownShare * static_cast<double>(exact.size());
  write_rising(bytes, baked);
  write_places(bytes, positions, result.box);
  write_normals(bytes, normals);

  write_lines(bytes, mesh.lines, order);
  std::vector<dvec3> on_contours;
  for (const auto& line : mesh.contours.lines) {
    for (const std::uint32_t vertex : line) on_contours.push_back(mesh.contours.position[vertex]);
  }
  bytes.varint(on_contours.size());
  write_places(bytes, on_contours, result.box);
  bytes.varint(mesh.contours.lines.size());
  for (const auto& line : mesh.contours.lines) bytes.varint(line.size());
  result.bytes = bytes.take();
  return result;
}

std::string colormap_bytes(const std::string& name) {
  std::string bytes;
  for (int i = 0; i < kColormapTexels; ++i) {
    const dvec3 color = colormap_at(name, i / (kColormapTexels - 1.0));
    for (int k = 0; k < 3; ++k) bytes += static_cast<char>(std::lround(255 * color[k]));
  }
  return bytes;
}

}  // namespace saddle
