#include "mesh/tree/outline.h"

#include <algorithm>
#include <optional>

namespace saddle {

namespace {

/// The vertices in use around a leaf, counter-clockwise in (u, v), defined or not.
Polygon outline(const Leaf& leaf, const Lattice& lattice) {
  Polygon polygon;
  polygon.reserve(8);
  for (std::size_t k = 0; k < 4; ++k) {
    lattice.walk(leaf, k, [&](std::uint32_t vertex, LatticePlace place) {
      polygon.push_back({vertex, {place.u, place.v}});
    });
  }
  return polygon;
}

/// Adds the point of the surface at a singular vertex, if it is not among those yet.
void add_singular_vertex(std::uint32_t vertex, const Lattice& lattice,
                         std::vector<std::uint32_t>& points) {
  if (lattice.is_regular(vertex)) return;
  const std::uint32_t point = lattice.mesh().point[vertex];
  if (std::ranges::count(points, point) == 0) points.push_back(point);
}

/// The different points of the surface at the singular vertices of a polygon.
std::vector<std::uint32_t> singular_points(const Polygon& polygon, const Lattice& lattice) {
  std::vector<std::uint32_t> points;
  for (const PolygonCorner& corner : polygon) add_singular_vertex(corner.corner, lattice, points);
  return points;
}

Bounds box_around(const Polygon& polygon) {
  Bounds box;
  for (const PolygonCorner& corner : polygon) box.add(dvec3(corner.place, 0));
  return box;
}

/// Whether a leaf is defined in two opposite corners, and not in the others.
bool has_opposite_gaps(const Leaf& leaf, const Lattice& lattice) {
  std::array<bool, 4> is_defined{};
  for (std::size_t k = 0; k < 4; ++k) is_defined[k] = lattice.is_defined(leaf.samples.corner[k]);
  return is_defined[0] == is_defined[2] && is_defined[1] == is_defined[3] &&
         is_defined[0] != is_defined[1];
}

/// A run of vertices between two cuts of the outline.
struct Run {
  Polygon polygon;
  bool goes_far = false;  ///< to a pole, or to where there is no limit
};

/// Cuts an outline at its crossings.
class Cutter {
 public:
  Cutter(const Polygon& whole, const Lattice& lattice) : whole_(whole), lattice_(lattice) {
    for (std::size_t k = 0; k < whole.size(); ++k) go_on(k);
  }

  /// `folded`: a crease goes through the leaf, from crossing to crossing or singular point.
  /// `has_middle`: the surface is defined in the leaf's middle. `has_opposite_gaps`: of the leaf.
  std::vector<Polygon> take(bool folded, bool has_middle, bool has_opposite_gaps) {
    // A crease that ends here leaves the leaf whole; a jump or a pole that does would be a wall.
    if (cuts_ == 1 && creases_.empty()) return {};
    if (cuts_ > rims_ && faces_ % 2 == 1) return {};  // so would a pole that leaves unseen
    if (cuts_ > 0) join_ends();
    const bool is_parted = lines_ > 1 || (faces_ > 0 && has_opposite_gaps);
    if (has_middle && cuts_ == rims_ && !is_parted) join_runs();
    if (folded && cuts_ < 2) cut_at_singular_points();
    std::vector<Polygon> result;
    if (creases_.size() >= 3) add(middle(), result);
    for (Run& run : runs_) {
      if (!run.goes_far) add(std::move(run.polygon), result);
    }
    return result;
  }

 private:
  /// What creases that cross more than two sides leave between them: it has what is on a side
  /// between two of them, which is no polygon by itself.
  Polygon middle() {
    if (creases_.size() != runs_.size()) return std::move(creases_);
    Polygon polygon;
    for (std::size_t k = 0; k < creases_.size(); ++k) {
      polygon.push_back(creases_[k]);
      Polygon& run = runs_[(k + 1) % runs_.size()].polygon;
      if (!is_flat(run)) continue;
      for (std::size_t i = 1; i + 1 < run.size(); ++i) polygon.push_back(run[i]);
      run.clear();
    }
    return polygon;
  }

  void append(std::uint32_t vertex) {
    runs_.back().polygon.push_back({vertex, lattice_.place_between(vertex)});
  }

  void cut() {
    ++cuts_;
    runs_.emplace_back();
  }

  /// Appends the k-th vertex, and what lies between it and the next.
  void go_on(std::size_t k) {
    const std::uint32_t a = whole_[k].corner;
    const std::uint32_t b = whole_[(k + 1) % whole_.size()].corner;
    if (lattice_.is_defined(a)) {
      runs_.back().polygon.push_back(whole_[k]);
    } else {
      cut();
      ++rims_;
      if (lattice_.hole(a) == Hole::Kind::Line) ++lines_;
    }
    const std::optional<Crossing> crossing = lattice_.crossing(a, b);
    if (!crossing) return;
    const bool far = leaves_out(crossing->kind);
    if (lattice_.is_defined(a)) {
      runs_.back().goes_far = runs_.back().goes_far || far;
      if (!far) append(crossing->beside(a));
    }
    if (crossing->is_rim()) ++rims_;
    if (crossing->kind == Cut::Face && lattice_.is_defined(a)) ++faces_;
    if (crossing->kind == Cut::Crease) creases_.push_back({crossing->beside(a), place(*crossing)});
    cut();
    if (lattice_.is_defined(b)) {
      runs_.back().goes_far = far;
      if (!far) append(crossing->beside(b));
    }
  }

  dvec2 place(const Crossing& crossing) const {
    return lattice_.place_between(crossing.beside_first);
  }

  /// The outline is closed: its first run goes on where its last one ends.
  void join_ends() {
    Run last = std::move(runs_.back());
    runs_.pop_back();
    Run& first = runs_.front();
    last.polygon.insert(last.polygon.end(), first.polygon.begin(), first.polygon.end());
    first.polygon = std::move(last.polygon);
    first.goes_far = first.goes_far || last.goes_far;
  }

  /// Rims that leave the middle whole cut corners off, and no more. But a line on which it is not
  /// defined goes from one of its places to the next, and of rims at infinity two may cross there.
  void join_runs() {
    Polygon& whole = runs_.front().polygon;
    for (std::size_t k = 1; k < runs_.size(); ++k) {
      whole.insert(whole.end(), runs_[k].polygon.begin(), runs_[k].polygon.end());
    }
    runs_.resize(1);
  }

  /// Where the crease ends in one singular point, or goes from one to another: a vertex as good as
  /// on it.
  void cut_at_singular_points() {
    Polygon& whole = runs_.front().polygon;
    const std::vector<std::uint32_t> points = singular_points(whole, lattice_);
    if (cuts_ + points.size() != 2) return;
    const auto& point = lattice_.mesh().point;
    if (cuts_ == 1 && point[creases_.front().corner] == points.back()) return;  // it only ends here
    if (cuts_ == 0) start_after(points[0], whole);
    const auto is_there = [&](const PolygonCorner& c) { return point[c.corner] == points.back(); };
    const auto first = std::ranges::find_if(whole, is_there);
    const auto last = std::find_if(whole.rbegin(), whole.rend(), is_there).base() - 1;
    Run rest{{last, whole.end()}};
    whole.erase(first + 1, whole.end());
    runs_.push_back(std::move(rest));
  }

  /// Rotates a polygon so that it begins and ends at a point.
  void start_after(std::uint32_t point, Polygon& polygon) const {
    const auto is_there = [&](const PolygonCorner& c) {
      return lattice_.mesh().point[c.corner] == point;
    };
    const auto elsewhere = std::ranges::find_if_not(polygon, is_there);
    // What is there is then inside or at the end.
    std::rotate(polygon.begin(), elsewhere, polygon.end());
    const auto end = std::find_if(polygon.rbegin(), polygon.rend(), is_there).base();
    std::rotate(polygon.begin(), end, polygon.end());
    polygon.insert(polygon.begin(), polygon.back());
  }

  /// A crossing beside a vertex is that vertex: it is there twice. Where nothing but rims cuts a
  /// leaf, what is left may be a side of it, and no area; between creases that holds sheets
  /// together.
  void add(Polygon polygon, std::vector<Polygon>& result) const {
    const auto same = [](const PolygonCorner& a, const PolygonCorner& b) {
      return a.corner == b.corner || a.place == b.place;
    };
    polygon.erase(std::unique(polygon.begin(), polygon.end(), same), polygon.end());
    while (polygon.size() > 1 && same(polygon.front(), polygon.back())) polygon.pop_back();
    const bool is_side = cuts_ > 0 && cuts_ == rims_ && is_flat(polygon);
    if (polygon.size() >= 3 && !is_side) result.push_back(std::move(polygon));
  }

  const Polygon& whole_;
  const Lattice& lattice_;
  std::vector<Run> runs_{1};
  Polygon creases_;  // where creases cross the sides
  std::size_t cuts_ = 0;
  std::size_t rims_ = 0;   // of the cuts, with what is not defined between them
  std::size_t lines_ = 0;  // places on lines where it is not defined
  std::size_t faces_ = 0;  // times that the surface leaves the box on its way around the leaf
};

}  // namespace

std::vector<Polygon> pieces(const Leaf& leaf, const Lattice& lattice) {
  if (leaf.is_left_out) return {};
  Polygon whole = outline(leaf, lattice);
  if (!lattice.may_be_crossed(leaf) && !leaf.on_rim && !leaf.is_split) {
    std::vector<Polygon> result;
    result.push_back(std::move(whole));
    return result;
  }
  return Cutter(whole, lattice)
      .take(leaf.is_split, lattice.is_defined(leaf.samples.centre),
            has_opposite_gaps(leaf, lattice));
}

std::uint32_t count_outline(const Leaf& leaf, const Lattice& lattice) {
  std::uint32_t count = 0;
  for_sides(leaf, lattice, [&](std::uint32_t, std::uint32_t) { ++count; });
  return count;
}

std::array<dvec3, 4> corner_positions(const Leaf& leaf, const Lattice& lattice) {
  std::array<dvec3, 4> positions;
  for (std::size_t k = 0; k < 4; ++k) {
    positions[k] = lattice.mesh().position[leaf.samples.corner[k]];
  }
  return positions;
}

std::vector<Side> sides_of(const Leaf& leaf, const Lattice& lattice) {
  std::vector<Side> sides;
  for_sides(leaf, lattice, [&](std::uint32_t a, std::uint32_t b) {
    sides.push_back({std::min(a, b), std::max(a, b)});
  });
  return sides;
}

std::optional<std::array<std::uint32_t, 4>> plain_corners(const Leaf& leaf,
                                                          const Lattice& lattice) {
  if (leaf.on_rim || leaf.is_split || leaf.is_left_out) return std::nullopt;
  const auto& corners = leaf.samples.corner;
  for (std::size_t k = 0; k < 4; ++k) {
    if (lattice.is_halved(leaf, k) || !lattice.is_defined(corners[k])) return std::nullopt;
  }
  if (!lattice.may_be_crossed(leaf)) return corners;
  for (std::size_t k = 0; k < 4; ++k) {
    if (lattice.crossing(corners[k], corners[(k + 1) % 4])) return std::nullopt;
  }
  return corners;
}

bool is_flat(const Polygon& piece) {
  const Bounds box = box_around(piece);
  return box.empty() || std::min(box.size().x, box.size().y) <= rounding_of_place(box.high);
}

std::optional<bool> flat_piece_along_u(const Leaf& leaf, const Lattice& lattice) {
  for (const Polygon& piece : pieces(leaf, lattice)) {
    if (!is_flat(piece)) continue;
    const dvec3 size = box_around(piece).size();
    return size.x > size.y;
  }
  return std::nullopt;
}

bool has_cut(Cut kind, const Leaf& leaf, const Lattice& lattice) {
  bool has_cut = false;
  for_sides(leaf, lattice, [&](std::uint32_t a, std::uint32_t b) {
    const std::optional<Crossing> crossing = lattice.crossing(a, b);
    has_cut = has_cut || (crossing && crossing->kind == kind);
  });
  return has_cut;
}

bool is_cusp(std::uint32_t a, std::uint32_t b, const Lattice& lattice) {
  const auto& point = lattice.mesh().point;
  return lattice.is_defined(a) && lattice.is_defined(b) && !lattice.is_regular(a) &&
         !lattice.is_regular(b) && point[a] != point[b];
}

bool is_cut_along_u(const Leaf& leaf, const Lattice& lattice) {
  Bounds cuts;
  for_sides(leaf, lattice, [&](std::uint32_t a, std::uint32_t b) {
    const std::optional<Crossing> crossing = lattice.crossing(a, b);
    if (crossing) cuts.add(dvec3(lattice.place_between(crossing->beside_first), 0));
    if (!is_cusp(a, b, lattice)) return;
    for (const std::uint32_t end : {a, b}) cuts.add(dvec3(lattice.place_between(end), 0));
  });
  const dvec3 size = cuts.empty() ? dvec3(0) : cuts.size();
  const double along_u = size.x / leaf.size_u();
  const double along_v = size.y / leaf.size_v();
  if (along_u == 0 && along_v == 0) return leaf.size_u() >= leaf.size_v();
  return along_u >= along_v;
}

namespace {

/// Whether a side from or to a vertex is cut in the place of that vertex, but not at a crease:
/// there it belongs to both sides.
bool is_cut_at(std::uint32_t vertex, std::uint32_t other, const Lattice& lattice) {
  const std::optional<Crossing> crossing = lattice.crossing(vertex, other);
  return crossing && crossing->kind == Cut::Jump &&
         lattice.place_between(crossing->beside(other)) == lattice.place_between(vertex);
}

bool is_at_corner(const Crossing& crossing, const Leaf& leaf, const Lattice& lattice) {
  const dvec2 place = lattice.place_between(crossing.beside_first);
  return std::ranges::any_of(leaf.corners(), [&](const LatticePlace& corner) {
    return place == dvec2(corner.u, corner.v);
  });
}

/// The vertices in whose place both sides are cut that meet there.
std::size_t count_cut_vertices(const Leaf& leaf, const Lattice& lattice) {
  std::size_t count = 0;
  std::optional<bool> leaves_first;  // whether the first side is cut where it begins
  bool arrives = false;              // whether the side before is where it ends
  for_sides(leaf, lattice, [&](std::uint32_t a, std::uint32_t b) {
    const bool leaves = is_cut_at(a, b, lattice);
    if (!leaves_first) leaves_first = leaves;
    if (arrives && leaves) ++count;
    arrives = is_cut_at(b, a, lattice);
  });
  if (arrives && leaves_first.value_or(false)) ++count;
  return count;
}

}  // namespace

CutCount count_cuts(const Leaf& leaf, const Lattice& lattice) {
  CutCount count;
  std::vector<std::uint32_t> singular;
  for_sides(leaf, lattice, [&](std::uint32_t a, std::uint32_t b) {
    add_singular_vertex(a, lattice, singular);
    const std::optional<Crossing> crossing = lattice.crossing(a, b);
    count.leads_to_pole = count.leads_to_pole || lattice.leads_to_pole(a, b);
    if (!crossing) return;
    // A pole that leaves through a vertex at which it is not defined leaves once.
    if (crossing->kind == Cut::Face && !lattice.is_defined(a)) return;
    const bool on_side_of_u = lattice.place_between(a).x == lattice.place_between(b).x;
    const std::size_t crossings = lattice.has_more(a, b) ? 2 : 1;
    count.crossings += crossings;
    (on_side_of_u ? count.on_sides_of_u : count.on_sides_of_v) += crossings;
    if (is_at_corner(*crossing, leaf, lattice)) {
      ++(on_side_of_u ? count.at_ends_of_u : count.at_ends_of_v);
    }
    if (crossing->kind != Cut::Crease) count.only_creases = false;
  });
  count.singular_points = singular.size();
  if (count.crossings > 2) count.at_vertices = count_cut_vertices(leaf, lattice);
  return count;
}

}  // namespace saddle
