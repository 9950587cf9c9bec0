// The distance of points from many triangles, and pairs of these that are near each other: a tree
// of boxes.
// Source: C. Ericson, "Real-time collision detection", 2005, 5.1.5 and chapter 6.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/array.h"
#include "eval/point_count.h"
#include "mesh/model/mesh.h"
#include "mesh/model/wide_box.h"

namespace saddle {

/// Nodes that are visited for a distance while a point of a short formula is computed.
inline constexpr std::size_t kVisitsPerPoint = 4;

/// Pairs of triangles that were tested, and those that passed.
struct PairCount {
  std::size_t passed = 0;
  std::size_t tested = 0;
  bool is_complete = false;  ///< all pairs were tested
};

class TriangleTree {
 public:
  /// The tree keeps a reference to the positions. It is built on so many threads (0: all).
  explicit TriangleTree(const Mesh& mesh, unsigned threads = 0)
      : TriangleTree(mesh.position, mesh.triangles, threads) {}
  /// Distances are counted as work in `count`, if there is one.
  TriangleTree(std::span<const dvec3> position, std::span<const Triangle> triangles,
               unsigned threads = 0, std::shared_ptr<PointCount> count = nullptr);

  /// The nearest triangle, by its number, and its distance.
  struct Nearest {
    double distance;
    std::optional<std::uint32_t> triangle;  ///< none is nearer than what was known
  };
  /// Any triangle within `enough` will do.
  Nearest nearest(const dvec3& p, double known = std::numeric_limits<double>::infinity(),
                  double enough = 0) const;
  /// The distance of the nearest triangle, or `known` if none is nearer; any that is within
  /// `enough`.
  double distance(const dvec3& p, double known = std::numeric_limits<double>::infinity(),
                  double enough = 0) const {
    return nearest(p, known, enough).distance;
  }
  /// The nearest corner of a triangle, by its number in the positions, and its distance.
  struct NearestCorner {
    double distance;
    std::optional<std::uint32_t> corner;  ///< none is nearer than what was known
  };
  NearestCorner nearest_corner(const dvec3& p, double known) const;

  /// A test of two triangles, by their numbers.
  using PairTest = std::function<bool(std::uint32_t, std::uint32_t)>;
  /// Counts the pairs of triangles whose boxes overlap and that pass a test, which several threads
  /// (0: all) call. Stops after `most_tests`, or less than twice as many.
  PairCount count_pairs(const PairTest& test, std::size_t most_tests, unsigned threads) const;

 private:
  /// Small, as what its test needs is in one place: in large trees most time is waiting for memory.
  struct Node {
    WideBox box;
    std::uint32_t first;  ///< leaf: of its triangles; else: its second child (the first follows)
    std::uint32_t count;  ///< leaf: triangles; else 0
  };
  /// A triangle, with what its test needs.
  struct Entry {
    WideBox box;
    Triangle corners;
    std::uint32_t number;
  };
  /// A triangle and the sum of its corners.
  struct Item {
    dvec3 middle;
    std::uint32_t triangle;
  };
  struct Subtree {
    std::size_t node = 0;   ///< its root
    std::size_t first = 0;  ///< its first entry
    std::span<Item> items;
  };
  void build(std::span<Item> items, std::span<const Triangle> triangles, unsigned threads);
  void build(const Subtree& subtree, std::span<const Triangle> triangles);
  void make_leaf(const Subtree& leaf, std::span<const Triangle> triangles);
  std::array<Subtree, 2> halve(const Subtree& whole);
  void add_boxes_of_halves(std::size_t node);
  struct Found {
    double distance;
    const Entry* entry;  ///< null: none is nearer than what was known
  };
  /// The nearest by the square of a distance, which is computed from the corners of a triangle.
  template <class SquareOf>
  Found find_nearest(const dvec3& p, double known, double enough, SquareOf square_of) const;
  /// Two nodes, or one with itself, whose boxes overlap.
  using NodePair = std::pair<std::uint32_t, std::uint32_t>;
  bool overlap(const NodePair& pair) const;
  bool are_leaves(const NodePair& pair) const;
  void add_halves(const NodePair& pair, std::vector<NodePair>& pairs) const;
  std::vector<NodePair> pairs_of_tasks() const;
  Bounds box_of(const Triangle& triangle) const;
  WideBox from_origin(const Bounds& box) const {
    return WideBox({box.low - origin_, box.high - origin_});
  }
  void test_leaves(const NodePair& pair, const PairTest& test, PairCount& count) const;

  std::span<const dvec3> position_;
  dvec3 origin_;  // of boxes: floats have few digits for a mesh that is far from 0
  std::shared_ptr<PointCount> count_;
  Array<Entry> entries_;  // in the order of the leaves
  Array<Node> nodes_;
};

}  // namespace saddle
