#include "render/overlay/box_edges.h"

#include <glm/common.hpp>

namespace saddle {
namespace {

/// An edge is upright if it is so many times as high as it is wide.
constexpr double kUpright = 2.5;

}  // namespace

std::vector<std::array<dvec3, 2>> BoxEdges::drawn() const {
  std::vector<std::array<dvec3, 2>> edges;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 4; ++i) {
      const bool first = (i & 1) != 0;
      const bool second = (i & 2) != 0;
      if (is_front((axis + 1) % 3, first) && is_front((axis + 2) % 3, second)) continue;
      edges.push_back({corner(axis, first, second, false), corner(axis, first, second, true)});
    }
  }
  return edges;
}

std::optional<dvec2> BoxEdges::pixel_of(const dvec3& point) const {
  return saddle::pixel_of(camera_, point, size_);
}

bool BoxEdges::is_front(int axis, bool high) const {
  const dvec3 backward(camera_.world_to_eye[0][2], camera_.world_to_eye[1][2],
                       camera_.world_to_eye[2][2]);
  double toward = backward[axis];
  if (!ortho_) {
    const dvec3 eye = camera_.target + camera_.distance * backward;
    toward = high ? eye[axis] - box_.high[axis] : eye[axis] - box_.low[axis];
  }
  return high ? toward > 0 : toward < 0;
}

dvec3 BoxEdges::corner(int axis, bool first_high, bool second_high, bool end) const {
  dvec3 p;
  p[axis] = end ? box_.high[axis] : box_.low[axis];
  p[(axis + 1) % 3] = first_high ? box_.high[(axis + 1) % 3] : box_.low[(axis + 1) % 3];
  p[(axis + 2) % 3] = second_high ? box_.high[(axis + 2) % 3] : box_.low[(axis + 2) % 3];
  return p;
}

std::optional<Edge> BoxEdges::with_ticks(int axis) const {
  std::optional<Edge> best;
  double best_rank = 0;
  for (int i = 0; i < 4; ++i) {
    const bool first = (i & 1) != 0;
    const bool second = (i & 2) != 0;
    if (is_front((axis + 1) % 3, first) == is_front((axis + 2) % 3, second)) continue;
    const auto edge = edge_at(axis, first, second);
    if (!edge) continue;
    const dvec2 way = glm::abs(edge->to - edge->from);
    const dvec2 middle = (edge->from + edge->to) / 2.0;
    const double rank = way.y > kUpright * way.x ? -middle.x : middle.y;
    if (best && rank <= best_rank) continue;
    best = edge;
    best_rank = rank;
  }
  return best;
}

std::optional<Edge> BoxEdges::edge_at(int axis, bool first, bool second) const {
  Edge edge;
  edge.axis = axis;
  edge.begin = corner(axis, first, second, false);
  edge.end = corner(axis, first, second, true);
  const auto from = pixel_of(edge.begin);
  const auto to = pixel_of(edge.end);
  const auto middle = pixel_of(box_.centre());
  if (!from || !to || !middle) return std::nullopt;
  edge.from = *from;
  edge.to = *to;
  const dvec2 away = (*from + *to) / 2.0 - *middle;
  const dvec2 along = *to - *from;
  if (edge.begin == edge.end) {  // a flat box
    if (glm::length(away) == 0) return std::nullopt;
    edge.out = glm::normalize(away);
    return edge;
  }
  if (glm::length(along) < least_length_) return std::nullopt;
  edge.out = glm::normalize(dvec2(along.y, -along.x));
  if (glm::dot(edge.out, away) < 0) edge.out = -edge.out;
  return edge;
}

Rect BoxEdges::outline() const {
  Rect rect{size_, dvec2(0)};
  for (int i = 0; i < 8; ++i) {
    const auto at = pixel_of(corner(0, (i & 1) != 0, (i & 2) != 0, (i & 4) != 0));
    if (!at) return {dvec2(0), size_};
    rect.low = glm::min(rect.low, *at);
    rect.high = glm::max(rect.high, *at);
  }
  return rect;
}

}  // namespace saddle
