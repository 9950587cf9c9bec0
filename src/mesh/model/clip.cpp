#include "mesh/model/clip.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "mesh/model/pair_table.h"
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
    if (!move_onto_face()) return;
    clip_triangles();
    clip_lines();
  }

 private:
  /// Returns whether a corner is outside.
  bool move_onto_face() {
    bool is_any_outside = false;
    for (dvec3& p : mesh_.position) {
      if (std::fabs(p[axis_] - limit_) <= rounding_) p[axis_] = limit_;
      is_any_outside = is_any_outside || !(beyond(p) <= 0);
    }
    return is_any_outside;
  }

  /// Distance of a corner from the face; less than 0 inside.
  double beyond(const dvec3& p) const { return sign_ * (p[axis_] - limit_); }
  double beyond(std::uint32_t corner) const { return beyond(mesh_.position[corner]); }
  bool is_inside(std::uint32_t corner) const { return beyond(corner) <= 0; }
  /// Whether the face goes through an edge, and through neither of its ends.
  bool cuts(std::uint32_t a, std::uint32_t b) const {
    return (beyond(a) < 0 && beyond(b) > 0) || (beyond(a) > 0 && beyond(b) < 0);
  }

  /// The corner where the edge from a to b crosses the face; the same from both sides.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto corner = static_cast<std::uint32_t>(mesh_.position.size());
    const auto [known, is_new] = corners_.insert(pair_of(a, b), corner);
    if (!is_new) return known;
    const dvec3 p = mesh_.position[a];
    const dvec3 q = mesh_.position[b];
    const double t = (limit_ - p[axis_]) / (q[axis_] - p[axis_]);
    dvec3 position = glm::mix(p, q, t);
    position[axis_] = limit_;
    const dvec3 normal = glm::mix(mesh_.normal[a], mesh_.normal[b], t);
    const double length = glm::length(normal);
    // Edges of the same two points, on both sides of a seam or a crease, cross at one point.
    const std::uint32_t point =
        points_.insert(pair_of(mesh_.point[a], mesh_.point[b]), corner).first;
    if (point != corner) position = mesh_.position[point];
    const dvec3 own_normal = mesh_.normal[a];
    const dvec2 uv = glm::mix(mesh_.uv[a], mesh_.uv[b], t);
    mesh_.position.push_back(position);
    mesh_.normal.push_back(length > 0 ? normal / length : own_normal);
    mesh_.uv.push_back(uv);
    mesh_.point.push_back(std::uint32_t{point});
    return corner;
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

  int axis_;
  double sign_;
  double limit_;
  double rounding_;  ///< within which a vertex is on the face
  Mesh& mesh_;
  PairTable corners_;
  PairTable points_;
};

}  // namespace

bool is_along_face(const Bounds& clip, const dvec3& from, const dvec3& to) {
  const double near = kNearly * glm::distance(from, to);
  const dvec3 low = glm::min(from, to);
  const dvec3 high = glm::max(from, to);
  return glm::any(glm::lessThanEqual(high, clip.low + near)) ||
         glm::any(glm::greaterThanEqual(low, clip.high - near));
}

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
