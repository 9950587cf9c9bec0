// Distance of points to the nearest of many triangles: a tree of boxes, each halved at the median
// of its longest side. A library for nearest.py.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace {

using Vec = std::array<double, 3>;
constexpr int kLeaf = 6;

Vec operator-(const Vec& a, const Vec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vec along(const Vec& a, const Vec& d, double s) {
  return {a[0] + s * d[0], a[1] + s * d[1], a[2] + s * d[2]};
}
double dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double to_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec d = b - a;
  const double square = dot(d, d);
  const double s = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  const Vec rest = p - along(a, d, s);
  return dot(rest, rest);
}

// Squared distance: that of the plane where the foot is inside of the triangle, else of an edge.
double to_triangle(const Vec& p, const Vec& a, const Vec& b, const Vec& c) {
  double best = std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
  const Vec e = b - a;
  const Vec f = c - a;
  const double ee = dot(e, e);
  const double ef = dot(e, f);
  const double ff = dot(f, f);
  const double area = ee * ff - ef * ef;
  if (!(area > 1e-14 * ee * ff)) return best;
  const Vec q = p - a;
  const double s = (ff * dot(q, e) - ef * dot(q, f)) / area;
  const double t = (ee * dot(q, f) - ef * dot(q, e)) / area;
  if (s >= 0 && t >= 0 && s + t <= 1) {
    const Vec rest = p - along(along(a, e, s), f, t);
    best = std::min(best, dot(rest, rest));
  }
  return best;
}

struct Node {
  Vec low, high;
  std::int32_t first, count, right;  // count > 0: a leaf
};

struct Tree {
  std::vector<Vec> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<Vec> centres;
  std::vector<std::int32_t> order;
  std::vector<Node> nodes;

  void build(std::int32_t first, std::int32_t count) {
    const std::size_t self = nodes.size();
    nodes.emplace_back();
    Vec low, high, least, most;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    least = low;
    most = high;
    for (std::int32_t i = first; i < first + count; ++i) {
      const std::int32_t n = order[i];
      for (int k = 0; k < 3; ++k) {
        for (const std::int32_t corner : triangles[n]) {
          low[k] = std::min(low[k], points[corner][k]);
          high[k] = std::max(high[k], points[corner][k]);
        }
        least[k] = std::min(least[k], centres[n][k]);
        most[k] = std::max(most[k], centres[n][k]);
      }
    }
    nodes[self] = {low, high, first, count, 0};
    if (count <= kLeaf) return;
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (most[k] - least[k] > most[axis] - least[axis]) axis = k;
    }
    const std::int32_t half = count / 2;
    std::nth_element(
        order.begin() + first, order.begin() + first + half, order.begin() + first + count,
        [&](std::int32_t a, std::int32_t b) { return centres[a][axis] < centres[b][axis]; });
    nodes[self].count = 0;
    build(first, half);
    nodes[self].right = static_cast<std::int32_t>(nodes.size());
    build(first + half, count - half);
  }

  double to_box(const Vec& p, const Node& node) const {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double d = std::max({node.low[k] - p[k], p[k] - node.high[k], 0.0});
      sum += d * d;
    }
    return sum;
  }

  void search(const Vec& p, std::int32_t at, double enough, double& best,
              std::int32_t& which) const {
    const Node& node = nodes[at];
    if (node.count > 0) {
      for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
        const auto& t = triangles[order[i]];
        const double d = to_triangle(p, points[t[0]], points[t[1]], points[t[2]]);
        if (d < best) {
          best = d;
          which = order[i];
        }
      }
      return;
    }
    const double left = to_box(p, nodes[at + 1]);
    const double right = to_box(p, nodes[node.right]);
    const bool left_first = left <= right;
    if (std::min(left, right) < best) {
      search(p, left_first ? at + 1 : node.right, enough, best, which);
    }
    if (std::max(left, right) < best && best > enough) {
      search(p, left_first ? node.right : at + 1, enough, best, which);
    }
  }
};

}  // namespace

extern "C" {

void* tree_new(const double* points, std::int64_t point_count, const std::int32_t* triangles,
               std::int64_t triangle_count) {
  auto* tree = new Tree;
  tree->points.resize(static_cast<std::size_t>(point_count));
  std::copy_n(points, 3 * point_count, tree->points.front().data());
  tree->triangles.resize(static_cast<std::size_t>(triangle_count));
  std::copy_n(triangles, 3 * triangle_count, tree->triangles.front().data());
  for (const auto& t : tree->triangles) {
    Vec centre;
    for (int k = 0; k < 3; ++k) {
      centre[k] = (tree->points[t[0]][k] + tree->points[t[1]][k] + tree->points[t[2]][k]) / 3;
    }
    tree->centres.push_back(centre);
  }
  tree->order.resize(tree->triangles.size());
  std::iota(tree->order.begin(), tree->order.end(), 0);
  tree->build(0, static_cast<std::int32_t>(triangle_count));
  return tree;
}

void tree_delete(void* tree) {
  delete static_cast<Tree*>(tree);
}

// Distances of finite points, and the triangles that are nearest. The nearest of the point before
// is tried first. A distance up to `enough` is an upper bound.
void tree_distances(const void* tree, const double* points, std::int64_t count, double enough,
                    double* distances, std::int32_t* nearest) {
  const Tree& in = *static_cast<const Tree*>(tree);
  std::int32_t last = in.order.front();
  for (std::int64_t i = 0; i < count; ++i) {
    const Vec p = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
    const auto& t = in.triangles[last];
    double best = to_triangle(p, in.points[t[0]], in.points[t[1]], in.points[t[2]]);
    if (best > enough * enough) in.search(p, 0, enough * enough, best, last);
    distances[i] = std::sqrt(best);
    nearest[i] = last;
  }
}

}  // extern "C"
