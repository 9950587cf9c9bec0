#include "study/dice.h"

#include <algorithm>
#include <cmath>

namespace saddle {
namespace {

/// Cells of the first raster, each way.
constexpr int kFirst = 128;
/// Longest side of a cell that is small enough, in pixels.
constexpr double kSmall = 2;
/// A cell that is still longer than this where halving ends is a jump.
constexpr double kJump = 8;
/// Cells are halved so many times each way at most, and at the rim until they are so small.
constexpr int kMostHalvings = 26;
constexpr int kRimHalvings = 3;
constexpr int kRimBisections = 48;  // of an edge: to the last bit of a parameter
constexpr std::size_t kMostTriangles = 4'000'000;
/// Pieces of a generation. A smooth surface has small enough ones long before; along poles and
/// jumps that run across both parameters each generation has twice as many, without end.
constexpr std::size_t kMostPieces = 2'000'000;
constexpr std::size_t kPieceBlock = 16'384;  // that are evaluated at a time

/// A rectangle of parameters.
struct Piece {
  dvec2 low, high;
  int halvings_u = 0;
  int halvings_v = 0;

  std::array<dvec2, 4> corners() const {
    return {low, dvec2(high.x, low.y), high, dvec2(low.x, high.y)};
  }
};

std::array<Piece, 2> halves(const Piece& piece, bool across_u) {
  Piece first = piece;
  Piece second = piece;
  if (across_u) {
    first.high.x = second.low.x = 0.5 * (piece.low.x + piece.high.x);
    ++first.halvings_u, ++second.halvings_u;
  } else {
    first.high.y = second.low.y = 0.5 * (piece.low.y + piece.high.y);
    ++first.halvings_v, ++second.halvings_v;
  }
  return {first, second};
}

class Dicer {
 public:
  Dicer(const Subject& subject, const Projection& projection)
      : subject_(subject),
        projection_(projection),
        screen_{{0, 0}, {subject.width, subject.height}} {}

  std::vector<DicedTriangle> run() {
    std::vector<Piece> pieces = first_pieces();
    while (!pieces.empty() && pieces.size() <= kMostPieces && result_.size() < kMostTriangles) {
      std::vector<Piece> next;
      for (std::size_t begin = 0; begin < pieces.size(); begin += kPieceBlock) {
        take_block(std::span(pieces).subspan(begin, std::min(kPieceBlock, pieces.size() - begin)),
                   next);
      }
      pieces = std::move(next);
    }
    return std::move(result_);
  }

 private:
  struct Screen {
    dvec2 low, high;
  };

  void take_block(std::span<const Piece> pieces, std::vector<Piece>& next) {
    std::vector<dvec2> uv;
    for (const Piece& piece : pieces) {
      for (const dvec2& corner : piece.corners()) uv.push_back(corner);
    }
    const std::vector<SurfacePoint> points = evaluate(subject_.surface, uv, subject_.threads);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      take(pieces[k], std::span(points).subspan(4 * k, 4), next);
    }
  }

  std::vector<Piece> first_pieces() const {
    const Domain& d = subject_.bound.domain;
    std::vector<Piece> pieces;
    for (int j = 0; j < kFirst; ++j) {
      for (int i = 0; i < kFirst; ++i) {
        const auto at = [&](int a, int b) {
          return dvec2(d.u0 + (d.u1 - d.u0) * a / kFirst, d.v0 + (d.v1 - d.v0) * b / kFirst);
        };
        pieces.push_back({at(i, j), at(i + 1, j + 1)});
      }
    }
    return pieces;
  }

  void split(const Piece& piece, bool across_u, std::vector<Piece>& next) const {
    for (const Piece& half : halves(piece, across_u)) next.push_back(half);
  }

  void take(const Piece& piece, std::span<const SurfacePoint> points, std::vector<Piece>& next) {
    std::array<dvec3, 4> seen;
    int defined = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      seen[k] = projection_(points[k].position);
      if (is_finite(points[k].position)) ++defined;
    }
    if (defined < 4) return take_rim(piece, defined, next);
    if (is_clipped(points) || is_off_screen(seen)) return;
    const auto length = [&](int a, int b) {
      return std::hypot(seen[a].x - seen[b].x, seen[a].y - seen[b].y);
    };
    const double long_u = std::max(length(0, 1), length(3, 2));
    const double long_v = std::max(length(0, 3), length(1, 2));
    const bool across_u = long_u >= long_v;
    const double longest = std::max(long_u, long_v);
    const int halvings = across_u ? piece.halvings_u : piece.halvings_v;
    // Also NaN, behind the eye.
    if (!(longest <= kSmall) && halvings < kMostHalvings) return split(piece, across_u, next);
    if (!(longest <= kJump)) return;
    const std::array<dvec2, 4> uv = piece.corners();
    if (sticks_out(points)) return add_fan(within_box({uv.begin(), uv.end()}));
    result_.push_back({{seen[0], seen[1], seen[2]}, {uv[0], uv[1], uv[2]}});
    result_.push_back({{seen[0], seen[2], seen[3]}, {uv[0], uv[2], uv[3]}});
  }

  bool sticks_out(std::span<const SurfacePoint> points) const {
    if (!subject_.clip) return false;
    return std::ranges::any_of(points, [&](const SurfacePoint& p) {
      return glm::clamp(p.position, subject_.clip->low, subject_.clip->high) != p.position;
    });
  }

  /// The part of a small cell that is inside of the clip box, if there is one, by one face of the
  /// box after the other. Source: I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping",
  /// 1974.
  std::vector<dvec2> within_box(std::vector<dvec2> polygon) const {
    if (!subject_.clip) return polygon;
    for (int k = 0; k < 3; ++k) {
      polygon = part_where(polygon, [&](const dvec3& p) { return p[k] >= subject_.clip->low[k]; });
      polygon = part_where(polygon, [&](const dvec3& p) { return p[k] <= subject_.clip->high[k]; });
    }
    return polygon;
  }

  /// Whether a piece is outside of the clip box, by more than its own size.
  bool is_clipped(std::span<const SurfacePoint> points) const {
    if (!subject_.clip) return false;
    Bounds bounds;
    for (const SurfacePoint& p : points) bounds.add(p.position);
    for (int k = 0; k < 3; ++k) {
      const double size = bounds.size()[k];
      if (bounds.low[k] - size > subject_.clip->high[k]) return true;
      if (bounds.high[k] + size < subject_.clip->low[k]) return true;
    }
    return false;
  }

  bool is_off_screen(const std::array<dvec3, 4>& seen) const {
    for (int k = 0; k < 2; ++k) {
      double low = seen[0][k];
      double high = low;
      for (const dvec3& p : seen) {
        low = std::min(low, p[k]);
        high = std::max(high, p[k]);
      }
      const double size = high - low;
      if (low - size > screen_.high[k] || high + size < screen_.low[k]) return true;
    }
    return false;
  }

  /// A piece with corners that are undefined: halved, then cut at the rim.
  void take_rim(const Piece& piece, int defined, std::vector<Piece>& next) {
    const int halvings = std::min(piece.halvings_u, piece.halvings_v);
    if (halvings < kRimHalvings) return split(piece, piece.halvings_u <= piece.halvings_v, next);
    if (defined == 0) return;
    const std::array<dvec2, 4> corners = piece.corners();
    const auto is_defined = [](const dvec3& p) { return is_finite(p); };
    add_fan(within_box(part_where({corners.begin(), corners.end()}, is_defined)));
  }

  /// The part of a polygon of parameters where a condition holds, by its corners and edges.
  template <class Condition>
  std::vector<dvec2> part_where(const std::vector<dvec2>& polygon, Condition holds) const {
    std::vector<dvec2> part;
    const std::vector<SurfacePoint> points = evaluate(subject_.surface, polygon, 1);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t after = (k + 1) % polygon.size();
      const bool here = holds(points[k].position);
      const bool there = holds(points[after].position);
      if (here) part.push_back(polygon[k]);
      if (here && !there) part.push_back(last_where(holds, polygon[k], polygon[after]));
      if (there && !here) part.push_back(last_where(holds, polygon[after], polygon[k]));
    }
    return part;
  }

  /// The last point where a condition holds on the way from one where it does to one where not.
  template <class Condition>
  dvec2 last_where(Condition holds, dvec2 inside, dvec2 outside) const {
    for (int i = 0; i < kRimBisections; ++i) {
      const dvec2 middle = 0.5 * (inside + outside);
      const bool is = holds(evaluate(subject_.surface, std::span(&middle, 1), 1)[0].position);
      (is ? inside : outside) = middle;
    }
    return inside;
  }

  void add_fan(const std::vector<dvec2>& polygon) {
    std::vector<dvec3> seen;
    for (const SurfacePoint& p : evaluate(subject_.surface, polygon, 1)) {
      seen.push_back(projection_(p.position));
    }
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      result_.push_back(
          {{seen[0], seen[k], seen[k + 1]}, {polygon[0], polygon[k], polygon[k + 1]}});
    }
  }

  const Subject& subject_;
  const Projection& projection_;
  Screen screen_;
  std::vector<DicedTriangle> result_;
};

}  // namespace

Projection::Projection(const Subject& subject)
    : to_clip_(subject.camera.eye_to_clip * subject.camera.world_to_eye),
      size_(subject.width, subject.height) {}

dvec3 Projection::operator()(const dvec3& p) const {
  const glm::dvec4 clip = to_clip_ * glm::dvec4(p, 1);
  if (!(clip.w > 0)) return dvec3(std::nan(""));
  const dvec2 at = (dvec2(clip) / clip.w * 0.5 + 0.5) * size_;
  return {at, clip.z / clip.w};
}

Projection::Seen Projection::operator()(const SurfacePoint& p) const {
  const glm::dvec4 clip = to_clip_ * glm::dvec4(p.position, 1);
  const auto moved = [&](const dvec3& by) {
    const glm::dvec4 d = to_clip_ * glm::dvec4(by, 0);
    return (dvec2(d) * clip.w - dvec2(clip) * d.w) / (clip.w * clip.w) * 0.5 * size_;
  };
  return {(dvec2(clip) / clip.w * 0.5 + 0.5) * size_, moved(p.r_u), moved(p.r_v)};
}

std::vector<DicedTriangle> dice(const Subject& subject, const Projection& projection) {
  return Dicer(subject, projection).run();
}

}  // namespace saddle
