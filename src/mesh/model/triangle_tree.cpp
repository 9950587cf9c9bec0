#include "mesh/model/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "base/parallel.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

double square(const dvec3& a) {
  return glm::dot(a, a);
}

/// The square of the distance of a triangle's nearest point, by the region that `p` is over.
double square_distance(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 ab = b - a;
  const dvec3 ac = c - a;
  const double d1 = glm::dot(ab, p - a);
  const double d2 = glm::dot(ac, p - a);
  if (d1 <= 0 && d2 <= 0) return square(p - a);
  const double d3 = glm::dot(ab, p - b);
  const double d4 = glm::dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return square(p - b);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return square(p - (a + d1 / (d1 - d3) * ab));
  const double d5 = glm::dot(ab, p - c);
  const double d6 = glm::dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return square(p - c);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return square(p - (a + d2 / (d2 - d6) * ac));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    return square(p - (b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)));
  }
  const double sum = va + vb + vc;
  return square(p - (a + vb / sum * ab + vc / sum * ac));
}

/// A corner that is finite, or 0: near all of them, beside how far they may be from 0.
dvec3 finite_corner(std::span<const dvec3> position, std::span<const Triangle> triangles) {
  for (const Triangle& t : triangles) {
    if (is_finite(position[t[0]])) return position[t[0]];
  }
  return dvec3(0);
}

/// Nodes of a tree of so many triangles. A level has halves of the triangles of the level before,
/// rounded either way: all but the last one are full.
std::size_t count_nodes(std::size_t triangles) {
  std::size_t level = 1;
  while (triangles / level > kTrianglesOfNode) level *= 2;
  // A node with one triangle too many has two leaves below it.
  const std::size_t halved = triangles / level == kTrianglesOfNode ? triangles % level : 0;
  return 2 * level - 1 + 2 * halved;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const dvec3> position, std::span<const Triangle> triangles,
                           unsigned threads, std::shared_ptr<PointCount> count)
    : position_(position), origin_(finite_corner(position, triangles)), count_(std::move(count)) {
  Array<Item> items(triangles.size());
  parallel_chunks(items.size(), kKeptAtATime, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Triangle& t = triangles[k];
      items[k] = {position[t[0]] + position[t[1]] + position[t[2]], static_cast<std::uint32_t>(k)};
    }
  });
  entries_.resize(items.size());
  nodes_.resize(items.empty() ? 0 : count_nodes(items.size()));
  if (!items.empty()) build(items, triangles, threads);
}

/// Builds large subtrees side by side.
void TriangleTree::build(std::span<Item> items, std::span<const Triangle> triangles,
                         unsigned threads) {
  std::vector<Subtree> subtrees = {{0, 0, items}};
  std::vector<std::size_t> above;  // nodes, each after the one that it is a half of
  while (subtrees.front().items.size() > kInBatch && subtrees.size() < kSearchedTogether) {
    std::vector<Subtree> halves(2 * subtrees.size());
    parallel_chunks(subtrees.size(), 1, threads, [&](std::size_t k, std::size_t) {
      std::ranges::copy(halve(subtrees[k]), halves.begin() + static_cast<std::ptrdiff_t>(2 * k));
    });
    for (const Subtree& subtree : subtrees) above.push_back(subtree.node);
    subtrees = std::move(halves);
  }
  parallel_chunks(subtrees.size(), 1, threads,
                  [&](std::size_t k, std::size_t) { build(subtrees[k], triangles); });
  std::for_each(above.rbegin(), above.rend(),
                [this](std::size_t node) { add_boxes_of_halves(node); });
}

void TriangleTree::build(const Subtree& subtree, std::span<const Triangle> triangles) {
  if (subtree.items.size() <= kTrianglesOfNode) return make_leaf(subtree, triangles);
  for (const Subtree& half : halve(subtree)) build(half, triangles);
  add_boxes_of_halves(subtree.node);
}

void TriangleTree::make_leaf(const Subtree& leaf, std::span<const Triangle> triangles) {
  Bounds around;
  for (std::size_t k = 0; k < leaf.items.size(); ++k) {
    const std::uint32_t number = leaf.items[k].triangle;
    const Bounds box = box_of(triangles[number]);
    entries_[leaf.first + k] = {from_origin(box), triangles[number], number};
    around.add(box);
  }
  nodes_[leaf.node] = {from_origin(around), static_cast<std::uint32_t>(leaf.first),
                       static_cast<std::uint32_t>(leaf.items.size())};
}

/// Sorts the triangles of a node into its halves, and makes it known where the second one is: nodes
/// follow each other in this order: a node, those of its first half, of its second.
std::array<TriangleTree::Subtree, 2> TriangleTree::halve(const Subtree& whole) {
  Bounds middles;
  for (const Item& item : whole.items) middles.add(item.middle);
  const dvec3 size = middles.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = whole.items.size() / 2;
  std::ranges::nth_element(whole.items, whole.items.begin() + static_cast<std::ptrdiff_t>(half), {},
                           [axis](const Item& item) { return item.middle[axis]; });
  const Subtree first = {whole.node + 1, whole.first, whole.items.first(half)};
  const Subtree second = {first.node + count_nodes(half), whole.first + half,
                          whole.items.subspan(half)};
  nodes_[whole.node] = {{}, static_cast<std::uint32_t>(second.node), 0};
  return {first, second};
}

void TriangleTree::add_boxes_of_halves(std::size_t node) {
  nodes_[node].box = WideBox(nodes_[node + 1].box, nodes_[nodes_[node].first].box);
}

bool TriangleTree::overlap(const NodePair& pair) const {
  const Bounds a = nodes_[pair.first].box.bounds();
  const Bounds b = nodes_[pair.second].box.bounds();
  return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

bool TriangleTree::are_leaves(const NodePair& pair) const {
  return nodes_[pair.first].count > 0 && nodes_[pair.second].count > 0;
}

/// The pairs that a pair is made of, of those that overlap.
void TriangleTree::add_halves(const NodePair& pair, std::vector<NodePair>& pairs) const {
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    if (a == b || overlap({a, b})) pairs.emplace_back(a, b);
  };
  const auto& [a, b] = pair;
  if (a == b) {
    add(a + 1, a + 1);
    add(nodes_[a].first, nodes_[a].first);
    add(a + 1, nodes_[a].first);
    return;
  }
  const bool halve_first = nodes_[b].count > 0 ||
                           (nodes_[a].count == 0 &&
                            nodes_[a].box.bounds().diagonal() >= nodes_[b].box.bounds().diagonal());
  const std::uint32_t halved = halve_first ? a : b;
  const std::uint32_t other = halve_first ? b : a;
  add(halved + 1, other);
  add(nodes_[halved].first, other);
}

/// Pairs that together are the pair of the root with itself: kInBatch of them or more, or leaves.
std::vector<TriangleTree::NodePair> TriangleTree::pairs_of_tasks() const {
  std::vector<NodePair> tasks = {{0, 0}};
  for (bool has_grown = true; has_grown && tasks.size() < kInBatch;) {
    std::vector<NodePair> next;
    has_grown = false;
    for (const NodePair& pair : tasks) {
      const bool is_whole = are_leaves(pair);
      is_whole ? next.push_back(pair) : add_halves(pair, next);
      has_grown = has_grown || !is_whole;
    }
    tasks = std::move(next);
  }
  return tasks;
}

Bounds TriangleTree::box_of(const Triangle& triangle) const {
  Bounds box;
  for (const std::uint32_t corner : triangle) box.add(position_[corner]);
  return box;
}

/// Tests the triangles of two leaves.
void TriangleTree::test_leaves(const NodePair& pair, const PairTest& test, PairCount& count) const {
  const Node& a = nodes_[pair.first];
  const Node& b = nodes_[pair.second];
  for (std::uint32_t i = 0; i < a.count; ++i) {
    const Entry& one = entries_[a.first + i];
    const Bounds box = box_of(one.corners);
    for (std::uint32_t j = pair.first == pair.second ? i + 1 : 0; j < b.count; ++j) {
      const Entry& other = entries_[b.first + j];
      const Bounds its = box_of(other.corners);
      const bool meet = glm::all(glm::lessThanEqual(box.low, its.high)) &&
                        glm::all(glm::lessThanEqual(its.low, box.high));
      if (!meet) continue;
      ++count.tested;
      if (test(one.number, other.number)) ++count.passed;
    }
  }
}

/// In rounds, after each of which all threads know how many tests were made: so the count is the
/// same on any number of threads.
PairCount TriangleTree::count_pairs(const PairTest& test, std::size_t most_tests,
                                    unsigned threads) const {
  if (nodes_.empty()) return {0, 0, true};
  std::vector<std::vector<NodePair>> tasks;
  for (const NodePair& pair : pairs_of_tasks()) tasks.push_back({pair});
  std::vector<PairCount> counts(tasks.size());
  PairCount total;
  const auto has_ended = [](const std::vector<NodePair>& task) { return task.empty(); };
  for (std::size_t round = 1; !total.is_complete; ++round) {
    const std::size_t most = round * (most_tests / tasks.size() + 1);
    parallel_chunks(tasks.size(), 1, threads, [&](std::size_t k, std::size_t) {
      while (!tasks[k].empty() && counts[k].tested < most) {
        const NodePair pair = tasks[k].back();
        tasks[k].pop_back();
        are_leaves(pair) ? test_leaves(pair, test, counts[k]) : add_halves(pair, tasks[k]);
      }
    });
    total = {0, 0, std::ranges::all_of(tasks, has_ended)};
    for (const PairCount& count : counts) {
      total.passed += count.passed;
      total.tested += count.tested;
    }
    if (total.tested >= most_tests) break;
  }
  return total;
}

template <class SquareOf>
TriangleTree::Found TriangleTree::find_nearest(const dvec3& p, double known, double enough,
                                               SquareOf square_of) const {
  if (nodes_.empty()) return {known, nullptr};
  double best = known * known;
  const Entry* nearest = nullptr;
  struct Visit {
    std::size_t node;
    double from;  // square of the distance of its box
  };
  std::array<Visit, 64> stack{};  // halves of halves: as deep as the logarithm of the count
  std::size_t depth = 0;
  std::size_t visited = 0;
  const dvec3 local = p - origin_;
  stack[depth++] = {0, nodes_[0].box.square_distance(local)};
  while (depth > 0 && !(best <= enough * enough)) {
    const Visit visit = stack[--depth];
    if (visit.from >= best) continue;
    const Node& node = nodes_[visit.node];
    ++visited;
    if (node.count > 0) {
      for (const Entry& entry : std::span(entries_).subspan(node.first, node.count)) {
        // Skips about five of six triangles.
        if (entry.box.square_distance(local) >= best) continue;
        const double square = square_of(entry.corners);
        if (!(square < best)) continue;
        best = square;
        nearest = &entry;
      }
      continue;
    }
    Visit near = {visit.node + 1, nodes_[visit.node + 1].box.square_distance(local)};
    Visit far = {node.first, nodes_[node.first].box.square_distance(local)};
    if (far.from < near.from) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  if (count_) count_->add_work(visited / kVisitsPerPoint);
  return {std::min(std::sqrt(best), known), nearest};
}

TriangleTree::Nearest TriangleTree::nearest(const dvec3& p, double known, double enough) const {
  const auto [distance, entry] = find_nearest(p, known, enough, [&](const Triangle& t) {
    return square_distance(p, position_[t[0]], position_[t[1]], position_[t[2]]);
  });
  if (entry == nullptr) return {distance, std::nullopt};
  return {distance, entry->number};
}

TriangleTree::NearestCorner TriangleTree::nearest_corner(const dvec3& p, double known) const {
  const auto square_of = [&](std::uint32_t corner) { return square(p - position_[corner]); };
  const auto [distance, entry] = find_nearest(p, known, 0, [&](const Triangle& t) {
    return std::min({square_of(t[0]), square_of(t[1]), square_of(t[2])});
  });
  if (entry == nullptr) return {distance, std::nullopt};
  return {distance, *std::ranges::min_element(entry->corners, {}, square_of)};
}

}  // namespace saddle
