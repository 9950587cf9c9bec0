#include "mesh/model/clip.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <glm/common.hpp>

#include "base/error.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

double largest_coordinate(const Bounds& box) {
  double largest = 0;
  for (const dvec3& corner : {box.low, box.high}) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isfinite(corner[axis])) largest = std::max(largest, std::fabs(corner[axis]));
    }
  }
  return largest;
}

/// One face of the box: p is inside if sign * (p[axis] - limit) <= 0.
class Face {
 public:
  Face(int axis, double sign, double limit, double rounding, Mesh& mesh)
      : axis_(axis), sign_(sign), limit_(limit), rounding_(rounding), mesh_(mesh) {}

  void clip() {
    if (!std::isfinite(limit_)) return;
    move_onto_face();
    clip_triangles();
    clip_lines();
  }

 private:
  void move_onto_face() {
    for (dvec3& p : mesh_.position) {
      if (std::fabs(p[axis_] - limit_) <= rounding_) p[axis_] = limit_;
    }
  }

  /// Distance of a corner from the face; less than 0 inside.
  double beyond(std::uint32_t corner) const {
    return sign_ * (mesh_.position[corner][axis_] - limit_);
  }
  bool is_inside(std::uint32_t corner) const { return beyond(corner) <= 0; }
  /// Whether the face goes through an edge, and through neither of its ends.
  bool cuts(std::uint32_t a, std::uint32_t b) const {
    return (beyond(a) < 0 && beyond(b) > 0) || (beyond(a) > 0 && beyond(b) < 0);
  }

  /// The corner where the edge from a to b crosses the face; the same from both sides.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto [place, is_new] = corners_.try_emplace(key(a, b), 0);
    if (!is_new) return place->second;
    const dvec3 p = mesh_.position[a];
    const dvec3 q = mesh_.position[b];
    const double t = (limit_ - p[axis_]) / (q[axis_] - p[axis_]);
    dvec3 position = glm::mix(p, q, t);
    position[axis_] = limit_;
    const dvec3 normal = glm::mix(mesh_.normal[a], mesh_.normal[b], t);
    const double length = glm::length(normal);
    const auto corner = static_cast<std::uint32_t>(mesh_.position.size());
    // Edges of the same two points, on both sides of a seam or a crease, cross at one point.
    const std::uint32_t point = points_.try_emplace(point_key(a, b), corner).first->second;
    if (point != corner) position = mesh_.position[point];
    const dvec3 own_normal = mesh_.normal[a];
    const dvec2 uv = glm::mix(mesh_.uv[a], mesh_.uv[b], t);
    mesh_.position.push_back(position);
    mesh_.normal.push_back(length > 0 ? normal / length : own_normal);
    mesh_.uv.push_back(uv);
    mesh_.point.push_back(std::uint32_t{point});
    return place->second = corner;
  }

  void clip_triangles() {
    Array<Triangle> kept;
    kept.reserve(mesh_.triangles.size());
    std::vector<std::uint32_t> polygon;
    for (const Triangle& t : mesh_.triangles) {
      if (std::ranges::all_of(t, [this](std::uint32_t corner) { return is_inside(corner); })) {
        kept.push_back(t);
        continue;
      }
      polygon.clear();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k];
        const std::uint32_t b = t[(k + 1) % 3];
        if (is_inside(a)) polygon.push_back(a);
        if (cuts(a, b)) polygon.push_back(crossing(a, b));
      }
      for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        kept.push_back({polygon[0], polygon[k], polygon[k + 1]});
      }
    }
    mesh_.triangles = std::move(kept);
  }

  void clip_lines() {
    std::vector<std::vector<std::uint32_t>> kept;
    for (const std::vector<std::uint32_t>& line : mesh_.lines) {
      std::vector<std::uint32_t> chain;
      const auto end_chain = [&] {
        if (chain.size() > 1) kept.push_back(chain);
        chain.clear();
      };
      for (std::size_t k = 0; k < line.size(); ++k) {
        if (is_inside(line[k])) chain.push_back(line[k]);
        if (k + 1 == line.size()) continue;
        if (cuts(line[k], line[k + 1])) chain.push_back(crossing(line[k], line[k + 1]));
        if (!is_inside(line[k + 1])) end_chain();
      }
      end_chain();
    }
    mesh_.lines = std::move(kept);
  }

  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t{a} << 32U) | b;
  }
  std::uint64_t point_key(std::uint32_t a, std::uint32_t b) const {
    const auto [first, second] = std::minmax(mesh_.point[a], mesh_.point[b]);
    return key(first, second);
  }

  int axis_;
  double sign_;
  double limit_;
  double rounding_;  ///< within which a vertex is on the face
  Mesh& mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> corners_;
  std::unordered_map<std::uint64_t, std::uint32_t> points_;
};

}  // namespace

bool reach_outside(const std::optional<Bounds>& clip, const Mesh& mesh,
                   std::span<const Triangle> triangles) {
  const auto is_outside = [&](std::uint32_t corner) {
    return !clip->contains(mesh.position[corner]);
  };
  return clip && std::ranges::any_of(triangles, [&](const Triangle& t) {
           return std::ranges::any_of(t, is_outside);
         });
}

void clip_mesh(const Bounds& box, Mesh& mesh) {
  const double rounding = kRoundingOfSums * largest_coordinate(box);
  for (int axis = 0; axis < 3; ++axis) {
    Face(axis, -1, box.low[axis], rounding, mesh).clip();
    Face(axis, 1, box.high[axis], rounding, mesh).clip();
  }
  if (mesh.triangles.empty()) {
    throw Error(Status::Nothing, "nothing of the surface is in the box that it is clipped to", {},
                "--clip off shows all of it");
  }
}

}  // namespace saddle
