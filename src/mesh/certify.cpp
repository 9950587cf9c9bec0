#include "mesh/certify.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "eval/enclose.h"
#include "mesh/judge.h"

namespace saddle {

namespace {

/// Halvings of a leaf, both ways taken together: 1/64 of each side.
constexpr int kMaxDepth = 12;

/// A range of parameters in either direction.
Interval range(double a, double b) {
  return {std::min(a, b), std::max(a, b)};
}

double magnitude(const Interval& a) {
  return std::max(std::fabs(a.low), std::fabs(a.high));
}
double length(std::span<const Interval> vector) {
  return std::hypot(magnitude(vector[0]), magnitude(vector[1]), magnitude(vector[2]));
}

struct Box {
  dvec2 low, high;
  dvec2 middle() const { return 0.5 * low + 0.5 * high; }
  dvec2 size() const { return glm::abs(high - low); }
};

/// Cells [first, end) of the root grid.
struct Cells {
  std::size_t first_u, end_u;
  std::size_t first_v, end_v;
  bool is_one() const { return end_u - first_u == 1 && end_v - first_v == 1; }
};

class Certifier {
 public:
  Certifier(const Surface& surface, const Grid& grid, const Lattice& lattice,
            std::span<const Leaf> leaves, std::span<const double> allowed, std::size_t& boxes)
      : grid_(grid),
        lattice_(lattice),
        leaves_(leaves),
        allowed_(allowed),
        boxes_(boxes),
        enclosure_(surface.bounds),
        outputs_(surface.bounds.outputs.size()),
        leaves_of_(grid.cell_count()) {
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      const LatticePlace& low = leaves[k].low;
      leaves_of_[grid.cell(low.u / kCellUnit, low.v / kCellUnit)].push_back(k);
    }
  }

  Certification run() {
    std::vector<Cells> stack = {{0, grid_.cells_u, 0, grid_.cells_v}};
    while (!stack.empty()) {
      const Cells cells = stack.back();
      stack.pop_back();
      const Box box = {{grid_.u[cells.first_u], grid_.v[cells.first_v]},
                       {grid_.u[cells.end_u], grid_.v[cells.end_v]}};
      if (is_proved(box, largest_leaf(cells), smallest_tolerance(cells))) continue;
      if (cells.is_one()) {
        const auto& inside = leaves_of_[grid_.cell(cells.first_u, cells.first_v)];
        for (const std::size_t leaf : inside) prove_leaf(leaf);
        continue;
      }
      Cells a = cells;
      Cells b = cells;
      if (cells.end_u - cells.first_u >= cells.end_v - cells.first_v) {
        a.end_u = b.first_u = (cells.first_u + cells.end_u) / 2;
      } else {
        a.end_v = b.first_v = (cells.first_v + cells.end_v) / 2;
      }
      stack.push_back(b);
      stack.push_back(a);
    }
    return std::move(result_);
  }

 private:
  dvec2 size_of(const Leaf& leaf) const {
    return glm::abs(lattice_.parameters(leaf.high) - lattice_.parameters(leaf.low));
  }

  template <class F>
  void for_leaves(const Cells& cells, F f) const {
    for (std::size_t j = cells.first_v; j < cells.end_v; ++j) {
      for (std::size_t i = cells.first_u; i < cells.end_u; ++i) {
        for (const std::size_t leaf : leaves_of_[grid_.cell(i, j)]) f(leaf);
      }
    }
  }

  dvec2 largest_leaf(const Cells& cells) const {
    dvec2 largest(0);
    for_leaves(cells, [&](std::size_t k) { largest = glm::max(largest, size_of(leaves_[k])); });
    return largest;
  }

  double smallest_tolerance(const Cells& cells) const {
    double least = std::numeric_limits<double>::infinity();
    for_leaves(cells, [&](std::size_t k) { least = std::min(least, allowed_[k]); });
    return least;
  }

  /// Whether leaves of a size are near enough wherever they are in the box.
  bool is_proved(const Box& box, const dvec2& leaf, double eps) {
    if (boxes_ == 0) {
      result_.complete = false;
      return true;  // nobody looks any more
    }
    --boxes_;
    enclosure_(range(box.low.x, box.high.x), range(box.low.y, box.high.y), outputs_);
    // r, r_u, r_v, then r_uu, r_uv, r_vv.
    const std::span<const Interval> all(outputs_);
    for (const Interval& a : all.first(9)) {
      if (a.defined != Defined::Yes || !a.continuous) return false;
    }
    for (const Interval& a : all.subspan(9)) {
      if (a.defined != Defined::Yes) return false;
    }
    const double bound = leaf.x * leaf.x * length(all.subspan(9, 3)) +
                         2 * leaf.x * leaf.y * length(all.subspan(12, 3)) +
                         leaf.y * leaf.y * length(all.subspan(15, 3));
    return bound <= 8 * kProofFactor * eps;  // false for NaN, too
  }

  void prove_leaf(std::size_t index) {
    const Leaf& leaf = leaves_[index];
    if (leaf.on_rim || leaf.is_split) {
      result_.complete = false;  // nothing is proved about rims, jumps and creases
      return;
    }
    const dvec2 size = size_of(leaf);
    const double eps = allowed_[index];
    struct Part {
      Box box;
      int depth;
    };
    std::vector<Part> stack = {
        {{lattice_.parameters(leaf.low), lattice_.parameters(leaf.high)}, 0}};
    while (!stack.empty()) {
      const auto [box, depth] = stack.back();
      stack.pop_back();
      if (is_proved(box, size, eps)) continue;
      if (depth == kMaxDepth) {
        const std::span<const Interval> second = std::span(outputs_).subspan(9);
        const dvec2 bend(length(second.first(3)), length(second.subspan(6, 3)));
        result_.suspects.push_back({index, box.middle(), box.size(), bend});
        continue;
      }
      Box a = box;
      Box b = box;
      const int axis = depth % 2;
      a.high[axis] = b.low[axis] = box.middle()[axis];
      stack.push_back({b, depth + 1});
      stack.push_back({a, depth + 1});
    }
  }

  const Grid& grid_;
  const Lattice& lattice_;
  std::span<const Leaf> leaves_;
  std::span<const double> allowed_;
  std::size_t& boxes_;
  Enclosure enclosure_;
  std::vector<Interval> outputs_;
  std::vector<std::vector<std::size_t>> leaves_of_;  // by root cell
  Certification result_;
};

}  // namespace

Certification certify(const Surface& surface, const Grid& grid, const Lattice& lattice,
                      std::span<const Leaf> leaves, std::span<const double> allowed,
                      std::size_t& boxes) {
  return Certifier(surface, grid, lattice, leaves, allowed, boxes).run();
}

}  // namespace saddle
