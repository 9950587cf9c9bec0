#include "export/page/page_triangles.h"

#include <algorithm>

namespace saddle {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Triangles by their corners.
class TrianglesOfCorners {
 public:
  explicit TrianglesOfCorners(const Mesh& mesh)
      : triangles_(mesh.triangles), begin_(mesh.position.size() + 1) {
    for (const Triangle& triangle : triangles_) {
      for (const std::uint32_t corner : triangle) ++begin_[corner + 1];
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    all_.resize(3 * triangles_.size());
    std::vector<std::uint32_t> end(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (const std::uint32_t corner : triangles_[t]) all_[end[corner]++] = t;
    }
  }

  /// A triangle that goes from `a` to `b` and is not in `gone`, or kNone.
  std::uint32_t along(std::uint32_t a, std::uint32_t b, const std::vector<bool>& gone) const {
    for (std::uint32_t i = begin_[a]; i < begin_[a + 1]; ++i) {
      if (!gone[all_[i]] && next_in(all_[i], a) == b) return all_[i];
    }
    return kNone;
  }

  /// The corner behind `corner` in a triangle.
  std::uint32_t next_in(std::uint32_t triangle, std::uint32_t corner) const {
    const Triangle& t = triangles_[triangle];
    return corner == t[0] ? t[1] : corner == t[1] ? t[2] : t[0];
  }

 private:
  std::span<const Triangle> triangles_;
  std::vector<std::uint32_t> begin_, all_;
};

class Walk {
 public:
  explicit Walk(const Mesh& mesh)
      : mesh_(mesh),
        beside_(mesh),
        gone_(mesh.triangles.size()),
        after_(mesh.position.size(), kNone),
        before_(mesh.position.size(), kNone) {
    result_.place.assign(mesh.position.size(), kNone);
  }

  PageTriangles all() {
    for (std::uint32_t t = 0; t < gone_.size(); ++t) {
      if (gone_[t]) continue;
      const auto [a, b, c] = mesh_.triangles[t];
      for (const std::uint32_t corner : {a, b, c}) say(corner, Gate{});
      take(t, a, b, c);
      follow_gates();
    }
    for (const auto& line : mesh_.lines) {
      for (const std::uint32_t corner : line) {
        if (result_.place[corner] == kNone) add(corner, Gate{});
      }
    }
    return std::move(result_);
  }

 private:
  /// A side of the last triangles, and their third corner.
  struct Gate {
    std::uint32_t a = kNone, b = kNone, c = kNone;
  };

  void follow_gates() {
    while (!gates_.empty()) {
      const Gate gate = gates_.back();
      gates_.pop_back();
      if (after_[gate.a] != gate.b) continue;
      const std::uint32_t t = beside_.along(gate.b, gate.a, gone_);
      if (t == kNone) {
        result_.codes.push_back(PageTriangles::kNothing);
        continue;
      }
      const std::uint32_t corner = beside_.next_in(t, gate.a);
      say(corner, gate);
      take(t, gate.b, gate.a, corner);
    }
  }

  void say(std::uint32_t corner, const Gate& gate) {
    const auto next = static_cast<std::uint32_t>(result_.corners.size());
    if (result_.place[corner] == kNone) {
      result_.codes.push_back(PageTriangles::kNew);
      add(corner, gate);
    } else if (gate.a != kNone && before_[gate.a] == corner) {
      result_.codes.push_back(PageTriangles::kBehind);
    } else {
      result_.codes.push_back(PageTriangles::kOld + next - result_.place[corner]);
    }
  }

  void add(std::uint32_t corner, const Gate& gate) {
    const auto number = static_cast<std::uint32_t>(result_.corners.size());
    result_.place[corner] = number;
    result_.corners.push_back(corner);
    if (gate.a != kNone) {
      const auto& place = result_.place;
      result_.guesses.push_back({place[gate.a], place[gate.b], place[gate.c]});
    } else if (number > 0) {
      result_.guesses.push_back({number - 1, number - 1, number - 1});
    }
  }

  /// Its sides leave or join the border of the triangles so far. Where the border touches itself it
  /// is known in part; triangles that are not reached so begin anew.
  void take(std::uint32_t triangle, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    gone_[triangle] = true;
    const std::array sides = {Gate{a, b, c}, Gate{c, a, b}, Gate{b, c, a}};
    std::array<bool, 3> joins{};
    for (int k = 0; k < 3; ++k) {
      joins[k] = after_[sides[k].b] == sides[k].a;
      if (joins[k]) after_[sides[k].b] = kNone;
    }
    for (int k = 0; k < 3; ++k) {
      if (joins[k]) continue;
      after_[sides[k].a] = sides[k].b;
      before_[sides[k].b] = sides[k].a;
      gates_.push_back(sides[k]);
    }
  }

  const Mesh& mesh_;
  TrianglesOfCorners beside_;
  std::vector<bool> gone_;
  std::vector<std::uint32_t> after_;   ///< each corner on the border
  std::vector<std::uint32_t> before_;  ///< the last one that was
  std::vector<Gate> gates_;
  PageTriangles result_;
};

}  // namespace

PageTriangles page_triangles(const Mesh& mesh) {
  return Walk(mesh).all();
}

}  // namespace saddle
