#include "mesh/curve/tube.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
/// Corners of a ring, at least and at most.
constexpr double kLeastCorners = 12;
constexpr double kMostCorners = 512;
/// Radians by which tangents at one place differ before the tube needs a joint.
constexpr double kJoint = 1e-3;

/// A circle of the tube, round a point of the curve. That of a cap is a smaller one beside it.
struct Ring {
  double s = 0;
  dvec3 centre;
  dvec3 tangent;        ///< unit
  dvec3 side{0, 0, 0};  ///< unit, across the tangent: where the angle is 0
  double latitude = 0;  ///< radians toward the tangent: of a cap
};

dvec3 unit_across(const dvec3& v) {
  const dvec3 size = glm::abs(v);
  const dvec3 axis = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                     : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                          : dvec3(0, 0, 1);
  return glm::normalize(glm::cross(v, axis));
}

dvec3 rotated(const dvec3& v, const dvec3& axis, double angle) {
  const double c = std::cos(angle);
  return c * v + std::sin(angle) * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis;
}

double angle_between(const dvec3& a, const dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The axis of the smallest rotation from one direction to another.
dvec3 axis_between(const dvec3& a, const dvec3& b) {
  const dvec3 axis = glm::cross(a, b);
  const double length = glm::length(axis);
  return length > kSame ? axis / length : unit_across(a);
}

/// The side of the next ring that is least twisted against this one's: two reflections.
dvec3 carried_side(const Ring& from, const Ring& to) {
  const dvec3 way = to.centre - from.centre;
  const double square = glm::dot(way, way);
  const auto reflected = [](const dvec3& v, const dvec3& across, double length_square) {
    return v - (2 * glm::dot(across, v) / length_square) * across;
  };
  dvec3 side = from.side;
  dvec3 tangent = from.tangent;
  if (square > 0) {
    side = reflected(side, way, square);
    tangent = reflected(tangent, way, square);
  }
  const dvec3 rest = to.tangent - tangent;
  const double rest_square = glm::dot(rest, rest);
  if (rest_square > 0) side = reflected(side, rest, rest_square);
  if (square == 0) {  // one reflection turns the ring inside out: the rotation, in a joint
    const dvec3 axis = axis_between(from.tangent, to.tangent);
    side = rotated(from.side, axis, angle_between(from.tangent, to.tangent));
  }
  side -= glm::dot(side, to.tangent) * to.tangent;
  return glm::normalize(side);
}

class TubeMaker {
 public:
  TubeMaker(double radius, double tolerance) : radius_(radius) {
    // A polygon of n corners is radius * (1 - cos(pi / n)) inside of its circle.
    const double share = std::clamp(1 - 0.5 * tolerance / radius, -1.0, 1.0);
    const double count = std::ceil(std::numbers::pi / std::acos(share));
    corners_ = static_cast<std::uint32_t>(std::clamp(count, kLeastCorners, kMostCorners));
    step_ = kTurn / corners_;
  }

  void add(const CurveChain& chain, bool closed) {
    rings_.clear();
    for (std::size_t i = 0; i < chain.size(); ++i) {
      add_ring({chain[i].s, chain[i].position, direction(chain, i)});
    }
    if (closed) {
      add_joint(rings_.back(), rings_.front().tangent);
      untwist();
    } else {
      add_caps();
    }
    add_corners(closed);
  }

  Mesh take() { return std::move(mesh_); }

 private:
  /// The tangent; where the curve has none, the way to a neighbour.
  static dvec3 direction(const CurveChain& chain, std::size_t i) {
    const dvec3& tangent = chain[i].tangent;
    const double length = glm::length(tangent);
    if (length > 0 && std::isfinite(length)) return tangent / length;
    dvec3 way(0);
    for (std::size_t k = i + 1; k < chain.size() && way == dvec3(0); ++k) {
      way = chain[k].position - chain[i].position;
    }
    for (std::size_t k = i; k-- > 0 && way == dvec3(0);) {
      way = chain[i].position - chain[k].position;
    }
    return way == dvec3(0) ? dvec3(0, 0, 1) : glm::normalize(way);
  }

  void add_ring(Ring ring) {
    if (rings_.empty()) {
      ring.side = unit_across(ring.tangent);
      rings_.push_back(ring);
      return;
    }
    const Ring& last = rings_.back();
    if (glm::length(ring.centre - last.centre) <= kNearly * radius_) {
      add_joint(last, ring.tangent);
    }
    ring.side = carried_side(rings_.back(), ring);
    rings_.push_back(ring);
  }

  /// Rings round one point from its tangent to another.
  void add_joint(const Ring& at, const dvec3& tangent) {
    const double angle = angle_between(at.tangent, tangent);
    if (angle <= kJoint) return;
    const Ring first = at;
    const dvec3 axis = axis_between(first.tangent, tangent);
    const int count = std::max(1, static_cast<int>(std::ceil(angle / step_)));
    for (int k = 1; k <= count; ++k) {
      Ring ring = first;
      ring.tangent = rotated(first.tangent, axis, angle * k / count);
      ring.side = rotated(first.side, axis, angle * k / count);
      rings_.push_back(ring);
    }
  }

  /// The last ring becomes the first one again: what they are twisted is spread over all.
  void untwist() {
    const Ring& first = rings_.front();
    const Ring& last = rings_.back();
    const dvec3 up = glm::cross(first.tangent, first.side);
    const double twist = std::atan2(glm::dot(last.side, up), glm::dot(last.side, first.side));
    std::vector<double> way = {0};
    for (std::size_t i = 1; i < rings_.size(); ++i) {
      way.push_back(way.back() + glm::length(rings_[i].centre - rings_[i - 1].centre));
    }
    if (!(way.back() > 0)) return;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      Ring& ring = rings_[i];
      ring.side = rotated(ring.side, ring.tangent, -twist * way[i] / way.back());
    }
  }

  void add_caps() {
    const std::uint32_t count = corners_ / 4;
    const Ring first = rings_.front();
    const Ring last = rings_.back();
    std::vector<Ring> start;
    for (std::uint32_t k = 0; k < count; ++k) {
      const double latitude = (std::numbers::pi / 2) * (count - k) / count;
      start.push_back(first);
      start.back().latitude = -latitude;
      Ring& end = rings_.emplace_back(last);
      end.latitude = (std::numbers::pi / 2) * (k + 1) / count;
    }
    rings_.insert(rings_.begin(), start.begin(), start.end());
  }

  static bool is_pole(const Ring& ring) { return std::fabs(ring.latitude) > 1.5; }

  void add_corners(bool closed) {
    const auto first_corner = static_cast<std::uint32_t>(mesh_.position.size());
    const std::uint32_t first_point = mesh_.point_count;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      const bool is_first_again = closed && i + 1 == rings_.size();
      add_ring_corners(rings_[i], first_corner, is_first_again ? first_point : mesh_.point_count,
                       is_first_again);
    }
    const std::uint32_t row = corners_ + 1;
    for (std::uint32_t i = 0; i + 1 < rings_.size(); ++i) {
      for (std::uint32_t j = 0; j < corners_; ++j) {
        const std::uint32_t a = first_corner + i * row + j;
        const std::uint32_t b = a + row;
        add_triangle({a, a + 1, b + 1});
        add_triangle({a, b + 1, b});
      }
    }
  }

  void add_ring_corners(const Ring& ring, std::uint32_t first_corner, std::uint32_t point,
                        bool is_first_again) {
    const dvec3 up = glm::cross(ring.tangent, ring.side);
    const double across = is_pole(ring) ? 0 : std::cos(ring.latitude);
    const double along = std::sin(ring.latitude);
    const auto start = mesh_.position.size();
    for (std::uint32_t j = 0; j <= corners_; ++j) {
      const double angle = step_ * (j % corners_);
      const dvec3 out =
          across * (std::cos(angle) * ring.side + std::sin(angle) * up) + along * ring.tangent;
      // Corners of one point have the same bits.
      const dvec3 position = is_first_again  ? mesh_.position[first_corner + j]
                             : j == corners_ ? mesh_.position[start]
                                             : ring.centre + radius_ * out;
      mesh_.position.push_back(dvec3(position));
      mesh_.normal.push_back(dvec3(out));
      mesh_.uv.push_back({ring.s, step_ * j});
      mesh_.point.push_back(point + (is_pole(ring) ? 0 : j % corners_));
      mesh_.bounds.add(position);
    }
    if (!is_first_again) mesh_.point_count = point + (is_pole(ring) ? 1 : corners_);
  }

  /// Not one of a pole's, without area.
  void add_triangle(const Triangle& t) {
    const auto point = [&](std::size_t k) { return mesh_.point[t[k]]; };
    if (point(0) == point(1) || point(1) == point(2) || point(2) == point(0)) return;
    mesh_.triangles.push_back(Triangle(t));
  }

  double radius_;
  std::uint32_t corners_ = 0;
  double step_ = 0;
  std::vector<Ring> rings_;
  Mesh mesh_;
};

}  // namespace

Mesh line_mesh(const CurveMesh& curve) {
  Mesh mesh;
  mesh.bounds = curve.bounds;
  for (const CurveChain& chain : curve.chains) {
    std::vector<std::uint32_t>& line = mesh.lines.emplace_back();
    for (const CurvePoint& p : chain) {
      line.push_back(mesh.point_count);
      mesh.position.push_back(dvec3(p.position));
      mesh.normal.push_back({0, 0, 1});
      mesh.uv.push_back({p.s, 0});
      mesh.point.push_back(mesh.point_count++);
    }
  }
  return mesh;
}

Mesh tube_mesh(const CurveMesh& curve, double radius, double tolerance) {
  TubeMaker maker(radius, tolerance);
  for (const CurveChain& chain : curve.chains) maker.add(chain, curve.closed);
  return maker.take();
}

}  // namespace saddle
