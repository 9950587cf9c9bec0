#include "mesh/solid/fans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include <glm/matrix.hpp>

#include "base/numbers.h"

namespace saddle {
namespace {

/// Eigenvalues below this part of the largest are taken for 0: normals that differ by less than
/// four degrees are one normal, and give no mitre.
constexpr double kSmallEigenvalue = 1e-3;
/// Along a direction that is less than this beside some triangle's normal, the front does not leave
/// the triangle: a fold or a cusp, or a point without a side.
constexpr double kLeastRise = 1e-2;
/// Turns of Jacobi's method; a matrix of three rows needs five or so.
constexpr int kMostSweeps = 20;
/// Relative: a smaller element beside the diagonal is 0.
constexpr double kDiagonal = 1e-15;

/// A corner of a triangle, and whether the triangle is turned against the first of the fan.
struct Member {
  std::uint32_t corner;  ///< 3 t + k
  bool turned;
};

/// Turns rows and columns i and j so that the element where they meet becomes 0.
void turn(int i, int j, glm::dmat3& a, glm::dmat3& axes) {
  if (std::abs(a[i][j]) <= kDiagonal * (std::abs(a[i][i]) + std::abs(a[j][j]))) return;
  const double theta = (a[j][j] - a[i][i]) / (2 * a[i][j]);
  const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double c = 1 / std::hypot(t, 1.0);
  const double s = t * c;
  glm::dmat3 rotation(1);
  rotation[i][i] = rotation[j][j] = c;
  rotation[j][i] = s;
  rotation[i][j] = -s;
  a = glm::transpose(rotation) * a * rotation;
  axes = axes * rotation;
}

/// The shortest d of those for which |a d - b| is least; a is symmetric, with eigenvalues of at
/// least 0. Source: G. Golub, C. Van Loan, "Matrix computations", 1996, 5.5 and 8.4.
dvec3 least_squares(glm::dmat3 a, const dvec3& b) {
  glm::dmat3 axes(1);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    turn(0, 1, a, axes);
    turn(0, 2, a, axes);
    turn(1, 2, a, axes);
  }
  const double largest = std::max({a[0][0], a[1][1], a[2][2]});
  dvec3 d(0);
  for (int k = 0; k < 3; ++k) {
    if (a[k][k] > kSmallEigenvalue * largest) d += glm::dot(axes[k], b) / a[k][k] * axes[k];
  }
  return d;
}

dvec3 unit(const dvec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : dvec3(0);
}

class FanFinder {
 public:
  FanFinder(const Mesh& mesh, const JoinedSides& joined) : mesh_(mesh), across_(joined.across) {}

  Fans run() {
    const std::size_t corners = 3 * mesh_.triangles.size();
    fans_.of.assign(corners, kNoIndex);
    fans_.turned.assign(corners, 0);
    fans_.point.reserve(mesh_.point_count);
    fans_.direction.reserve(mesh_.point_count);
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
      if (fans_.of[corner] != kNoIndex) continue;
      gather(corner);
      fans_.point.push_back(std::uint32_t{point_of(corner)});
      fans_.direction.push_back(dvec3(direction()));
    }
    return std::move(fans_);
  }

 private:
  std::uint32_t mesh_corner(std::uint32_t corner) const {
    return mesh_.triangles[corner / 3][corner % 3];
  }
  std::uint32_t point_of(std::uint32_t corner) const { return mesh_.point[mesh_corner(corner)]; }
  static std::uint32_t side_before(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
  }
  static std::uint32_t side_after(std::uint32_t corner) { return corner; }
  static std::uint32_t corner_after(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }

  void take(const Member& member) {
    fans_.of[member.corner] = static_cast<std::uint32_t>(fans_.point.size());
    fans_.turned[member.corner] = member.turned ? 1 : 0;
    fans_.one_sided = fans_.one_sided || member.turned;
    members_.push_back(member);
  }

  /// The corners of a fan: on from one through the side after it, then through the one before it.
  void gather(std::uint32_t first) {
    members_.clear();
    take({first, false});
    if (!walk({first, false}, side_after(first))) walk({first, false}, side_before(first));
  }

  /// Goes on around the point, leaving each triangle through its other side. Returns whether it
  /// came back to where it began.
  bool walk(Member at, std::uint32_t through) {
    const std::uint32_t begin = at.corner;
    const std::uint32_t point = point_of(begin);
    while (across_[through] != kNoIndex) {
      const std::uint32_t entered = across_[through];
      const bool from_start = through == side_after(at.corner);  // the side begins at the point
      const bool at_start = point_of(entered) == point;
      const std::uint32_t corner = at_start ? entered : corner_after(entered);
      if (corner == begin) return true;
      // Neighbours run along their side in opposite directions.
      at = {corner, at.turned != (at_start == from_start)};
      take(at);
      through = at_start ? side_before(corner) : side_after(corner);
    }
    return false;
  }

  dvec3 direction() const {
    const std::uint32_t first = mesh_corner(members_[0].corner);
    const bool is_smooth = std::ranges::all_of(
        members_, [&](const Member& m) { return mesh_corner(m.corner) == first; });
    return is_smooth ? mesh_.normal[first] : mitre();
  }

  dvec3 normal_of(const Member& member) const {
    const dvec3& normal = mesh_.normal[mesh_corner(member.corner)];
    return member.turned ? -normal : normal;
  }

  /// The other two corners of a triangle, as ways from the point.
  std::array<dvec3, 2> ways(const Member& member) const {
    const std::uint32_t next = corner_after(member.corner);
    const dvec3& p = mesh_.position[mesh_corner(member.corner)];
    return {mesh_.position[mesh_corner(next)] - p,
            mesh_.position[mesh_corner(corner_after(next))] - p};
  }

  /// The distance of 1 from all triangles' planes, as nearly as can be. Triangles count by their
  /// angles, so that halving one changes nothing.
  dvec3 mitre() const {
    glm::dmat3 products(0);
    dvec3 sum(0);
    for (const Member& member : members_) {
      const auto [a, b] = ways(member);
      const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      const dvec3 n = normal_of(member);
      products += angle * glm::outerProduct(n, n);
      sum += angle * n;
    }
    const dvec3 d = least_squares(products, sum);
    const bool rises = std::ranges::all_of(
        members_, [&](const Member& m) { return glm::dot(d, normal_of(m)) > kLeastRise; });
    if (!rises) return away();
    const double length = glm::length(d);
    return length > kLongestMitre ? kLongestMitre / length * d : d;
  }

  /// At a fold or cusp: away from the triangles, on the side of their fronts.
  dvec3 away() const {
    dvec3 toward(0);
    dvec3 front(0);
    for (const Member& member : members_) {
      const auto [a, b] = ways(member);
      toward += unit(a) + unit(b);
      const dvec3 face = glm::cross(a, b);
      front += member.turned ? -face : face;
    }
    const dvec3 out = -unit(toward);
    if (out == dvec3(0)) return unit(front) == dvec3(0) ? normal_of(members_[0]) : unit(front);
    return glm::dot(out, front) < 0 ? -out : out;
  }

  const Mesh& mesh_;
  const Array<std::uint32_t>& across_;
  Fans fans_;
  std::vector<Member> members_;  // of the fan that is being gathered
};

}  // namespace

Fans fans_of(const Mesh& mesh, const JoinedSides& joined) {
  return FanFinder(mesh, joined).run();
}

}  // namespace saddle
