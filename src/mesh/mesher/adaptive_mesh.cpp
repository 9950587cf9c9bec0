#include "mesh/mesher/adaptive_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/compensated_sum.h"
#include "base/heap.h"
#include "mesh/features/nonsmooth_points.h"
#include "mesh/grid/corners.h"
#include "mesh/grid/facing.h"
#include "mesh/mesher/adaptive_mesher.h"
#include "mesh/mesher/pole_features.h"
#include "mesh/mesher/report_errors.h"
#include "mesh/model/clip.h"
#include "mesh/model/tidy.h"
#include "mesh/model/tolerances.h"
#include "mesh/model/triangle_tree.h"
#include "mesh/sizing/grid_sizing.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/leaf_lines.h"

namespace saddle {

namespace {

/// A list of different places.
class PlaceList {
 public:
  /// `listed`, `count`: of the report. `range`: of the parameters.
  PlaceList(const dvec2& range, std::vector<dvec2>& listed, std::size_t& count)
      : range_(range), listed_(listed), count_(count) {}

  /// Adds a place. False if it is in the list.
  bool add(const dvec2& uv) {
    const dvec2 place = glm::round(uv / range_ / kSame);
    if (!seen_.insert({place.x, place.y}).second) return false;
    ++count_;
    if (listed_.size() < kMaxListed) listed_.push_back(uv);
    return true;
  }

 private:
  dvec2 range_;
  std::vector<dvec2>& listed_;
  std::size_t& count_;
  std::set<std::array<double, 2>> seen_;
};

/// Lines of constant u or v that cut the sides of leaves across them from end to end. Many curves
/// may end at the same parameters of both ends, as those of u v: a line cuts most of the grid's
/// lines between them, too. Where a step has no height, it cuts nothing.
class LinesOfCuts {
 public:
  /// Adds a cut of a side that goes from `first` to `last`.
  void add(const dvec2& cut, const dvec2& first, const dvec2& last) {
    if (first.y == last.y) across_u_.emplace_back(cut.x, cut.y);
    if (first.x == last.x) across_v_.emplace_back(cut.y, cut.x);
  }

  /// The lines with cuts at both ends, and on most lines of the grid.
  ParameterLines from_end_to_end(const Grid& grid) {
    return {lines(across_u_, grid.range.x, grid.v), lines(across_v_, grid.range.y, grid.u)};
  }

 private:
  using Cuts = std::vector<std::pair<double, double>>;  // parameters of the line, and on it

  /// `range`: of the lines' parameter; `along`: the grid's values of the other one.
  static std::vector<double> lines(Cuts& cuts, double range, std::span<const double> along) {
    std::ranges::sort(cuts);
    std::vector<double> lines;
    for (auto begin = cuts.begin(); begin != cuts.end();) {
      const double limit = begin->first + kNearly * std::fabs(range);
      const auto end =
          std::find_if(begin, cuts.end(), [limit](const auto& cut) { return cut.first > limit; });
      std::set<double> cut_at;
      std::for_each(begin, end, [&](const auto& cut) { cut_at.insert(cut.second); });
      const auto is_cut = [&](double at) { return cut_at.contains(at); };
      const bool is_whole = is_cut(along.front()) && is_cut(along.back()) &&
                            2 * std::ranges::count_if(along, is_cut) > std::ssize(along);
      if (is_whole) lines.push_back(begin->first);
      begin = end;
    }
    return lines;
  }

  Cuts across_u_, across_v_;
};

/// Fills a report from the leaves of a mesh.
class Finisher {
 public:
  explicit Finisher(AdaptiveMesher& mesher)
      : mesher_(mesher), mesh_(mesher.mesh()), tree_(mesher.tree()), grid_(mesher.grid()) {}

  /// Lists poles, and adds the positions beside them to the report.
  void list_poles(unsigned threads, MeshReport& report) const {
    PlaceList poles(grid_.range, report.poles, report.pole_count);
    LinesOfCuts lines;
    for (const std::array<dvec2, 2>& pole : tree_.edges().poles(tree_.mesh())) {
      const dvec2 place = 0.5 * (pole[0] + pole[1]);  // no double lies between them
      poles.add(place);
      lines.add(place, pole[0], pole[1]);
    }
    report.pole_lines = lines.from_end_to_end(grid_);
    for_singularities(PointSingularity::Kind::Pole,
                      [&](const dvec2& uv, const PointSingularity& singularity) {
                        poles.add(uv);
                        report.beside_poles.add(singularity.beyond);
                      });
    report.beside_poles.add(box_beside_poles(tree_, threads));
  }

  /// Removes the triangles that have infinite corners, and lists these as poles: vertices are
  /// finite.
  void cut_infinite(Array<Triangle>& triangles, MeshReport& report) const {
    const auto& position = grid_.mesh.position;
    if (std::ranges::all_of(position, is_finite)) return;
    PlaceList poles(grid_.range, report.poles, report.pole_count);
    const auto is_cut = [&](const Triangle& t) {
      const auto infinite = std::ranges::find_if(
          t, [&](std::uint32_t corner) { return !is_finite(position[corner]); });
      if (infinite != t.end()) poles.add(grid_.mesh.uv[*infinite]);
      return infinite != t.end();
    };
    const auto rest = std::remove_if(triangles.begin(), triangles.end(), is_cut);
    triangles.resize(static_cast<std::size_t>(rest - triangles.begin()));
  }

  /// Lists essential points, then places where jumps cut the sides of leaves.
  void list_jumps(MeshReport& report) const {
    PlaceList jumps(grid_.range, report.jumps, report.jump_count);
    for_singularities(PointSingularity::Kind::Essential,
                      [&](const dvec2& uv, const PointSingularity&) {
                        if (jumps.add(uv) && report.without_limit.size() < kMaxListed)
                          report.without_limit.push_back(uv);
                      });
    LinesOfCuts lines;
    for_features(FeatureKind::Jump, [&](const Side& side, const EdgeFeature& cut) {
      cut.for_jumps(cut.first, [&](std::uint32_t before, std::uint32_t) {
        const dvec2& uv = grid_.mesh.uv[before];
        jumps.add(uv);
        lines.add(uv, grid_.mesh.uv[side[0]], grid_.mesh.uv[side[1]]);
      });
    });
    report.jump_lines = lines.from_end_to_end(grid_);
    for (const auto& [vertex, beside] : beside_lines()) {
      if (beside.diagonal() > *report.tolerance) jumps.add(grid_.mesh.uv[vertex]);
    }
  }

  /// Lists as singular points the places where cusps cut the sides of leaves.
  void list_cusps(MeshReport& report) const {
    const auto& n = grid_.mesh.normal;
    const double opposite = -std::cos(kCreaseDegrees * std::numbers::pi / 180);
    for_features(FeatureKind::Crease, [&](const Side&, const EdgeFeature& cut) {
      if (glm::dot(n[cut.beside_first], n[cut.beside_second]) < opposite)
        add_singular_point(grid_.mesh.uv[cut.beside_first], report);
    });
  }

  /// The share of the domain that is in no leaf, nor in a sub-polygon of a leaf with a boundary.
  double undefined_fraction(const Domain& d) const {
    CompensatedSum covered;
    for (const Leaf& leaf : mesh_.leaves) {
      const dvec2 size =
          tree_.vertices().parameters(leaf.high()) - tree_.vertices().parameters(leaf.low);
      if (!leaf.state.is_on_boundary() || has_only_thin_holes(leaf)) {
        covered.add(std::fabs(size.x * size.y));
        continue;
      }
      for (const Polygon& sub_polygon : sub_polygons(leaf, tree_))
        covered.add(std::fabs(area_of(sub_polygon)));
    }
    const double share = 1 - covered.value() / std::fabs((d.u1 - d.u0) * (d.v1 - d.v0));
    return share > kRoundingOfSums ? share : 0;
  }

  /// The largest distance of parts that are left out, because their triangles have no area, from
  /// the mesh. Such a part is a line or a point, but it may be long.
  void take_lost_parts(const LeafTriangles& triangles, const MeshRequest& request,
                       MeshReport& report) const {
    const std::vector<std::uint32_t> lost = lost_corners(triangles);
    // A needle to a pole ends at rounding alone, at no distance that could be measured.
    if (lost.empty() || report.pole_count > 0) return;
    const auto& position = grid_.mesh.position;
    const TriangleTree mesh(position, triangles.all, request.threads,
                            tree_.surface().tangents.count);
    for (const std::uint32_t corner : lost) {
      const dvec3& p = position[corner];
      if (!is_seen(request.clip, p)) continue;
      const double distance = mesh.distance(p);
      if (distance > std::max(report.max_error, *report.tolerance))
        report.worst_place = grid_.mesh.uv[corner];
      report.max_error = std::max(report.max_error, distance);
    }
  }

 private:
  /// The corners of whole leaves that lack triangles.
  std::vector<std::uint32_t> lost_corners(const LeafTriangles& triangles) const {
    std::vector<std::uint32_t> corners;
    for (std::size_t k = 0; k < mesh_.leaves.size(); ++k) {
      const Leaf& leaf = mesh_.leaves[k];
      if (!leaf.state.is_whole() || triangles.ranges[k].is_complete()) continue;
      corners.insert(corners.end(), leaf.samples.corner.begin(), leaf.samples.corner.end());
    }
    return corners;
  }

  /// Calls f(uv, singularity) for all of this kind: at vertices, then inside leaves.
  template <class F>
  void for_singularities(PointSingularity::Kind kind, F f) const {
    for (const auto& [vertex, singularity] : tree_.geometry().singularities()) {
      if (singularity.kind == kind) f(grid_.mesh.uv[vertex], singularity);
    }
    for (const auto& [uv, singularity] : mesher_.singularities()) {
      if (singularity.kind == kind) f(uv, singularity);
    }
  }

  /// The positions beside each vertex on a line where the surface is undefined, as abs(u)/u at
  /// u = 0, on both sides of the line.
  std::map<std::uint32_t, Bounds> beside_lines() const {
    std::map<std::uint32_t, Bounds> result;
    for_features(FeatureKind::Boundary, [&](const Side& side, const EdgeFeature& cut) {
      for (const std::uint32_t end : side) {
        if (tree_.geometry().singularity(end) == PointSingularity::Kind::Line &&
            is_same_place(end, cut.beside_first))
          result[end].add(grid_.mesh.position[cut.beside_first]);
      }
    });
    return result;
  }

  /// Whether the parameters of vertices are the same up to rounding. A boundary farther away does
  /// not belong to the line.
  bool is_same_place(std::uint32_t a, std::uint32_t b) const {
    const dvec2 apart = glm::abs(grid_.mesh.uv[a] - grid_.mesh.uv[b]);
    return glm::all(glm::lessThanEqual(apart, kSame * glm::abs(grid_.range)));
  }

  /// Calls f(side, feature) for each side of a leaf with a feature of this kind.
  template <class F>
  void for_features(FeatureKind kind, F f) const {
    if (!tree_.edges().has_features()) return;
    std::set<Side> seen;
    for (const Leaf& leaf : mesh_.leaves) {
      if (leaf.state.is_whole()) continue;
      for (const Side& side : sides_of(leaf, tree_)) {
        const auto feature = tree_.edges().feature(side[0], side[1]);
        if (feature && feature->kind == kind && seen.insert(side).second) f(side, *feature);
      }
    }
  }

  /// Signed, in parameters.
  double area_of(const Polygon& polygon) const {
    double area = 0;
    const dvec2& first = grid_.mesh.uv[polygon[0].corner];
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      const dvec2 a = grid_.mesh.uv[polygon[k].corner] - first;
      const dvec2 b = grid_.mesh.uv[polygon[k + 1].corner] - first;
      area += 0.5 * cross(a, b);
    }
    return area;
  }

  /// Whether a leaf is undefined only at points and lines.
  bool has_only_thin_holes(const Leaf& leaf) const {
    bool is_thin = true;
    for_sides(leaf, tree_, [&](std::uint32_t a, std::uint32_t) {
      is_thin = is_thin && (tree_.geometry().is_defined(a) ||
                            tree_.geometry().singularity(a) != PointSingularity::Kind::Region);
    });
    return is_thin;
  }

  const AdaptiveMesher& mesher_;
  const ValidatedMesh& mesh_;
  const CellTree& tree_;
  const Grid& grid_;
};

/// Removes the singular points outside of a box from a report.
void keep_singular_points_within(const Bounds& box, const Surface& surface, unsigned threads,
                                 MeshReport& report) {
  auto& listed = report.singular_points;
  std::vector<dvec2> uv;
  uv.reserve(listed.size());
  for (const SingularPoint& point : listed) uv.push_back(point.uv);
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  std::vector<SingularPoint> kept;
  for (std::size_t k = 0; k < listed.size(); ++k) {
    if (box.contains(points[k].position)) kept.push_back(listed[k]);
  }
  report.singular_point_count -= listed.size() - kept.size();
  listed = std::move(kept);
}

/// The mesh and its report; empty if no triangle has an area.
std::optional<MeshResult> finish(const Surface& surface, const MeshRequest& request,
                                 const MeshPlan& plan, AdaptiveMesher& mesher, MeshResult result) {
  MeshReport& report = result.report;
  const Finisher finisher(mesher);
  report.effort = mesher.tree().effort().total();
  finisher.list_poles(request.threads, report);
  if (mesher.stops_early()) {
    report.beside_poles.add(mesher.far_vertices());
    report.stopped_early = true;
    return result;
  }
  finisher.list_jumps(report);
  finisher.list_cusps(report);
  LeafTriangles& triangles = mesher.triangulate(report);
  mesher.reach_extremes();
  report_errors(surface, request, mesher, triangles, report);
  if (triangles.all.empty()) return std::nullopt;
  finisher.take_lost_parts(triangles, request, report);
  report.undefined_fraction = finisher.undefined_fraction(surface.domain);
  // A polygon that meets itself at a pole may have more triangles than its corners suggest. Flat
  // triangles outside of a clip box are not counted, so none are with a box.
  report.is_clipped = request.clip.has_value();
  report.flat_triangles = report.is_clipped ? 0
                                            : std::max(triangles.expected(), triangles.all.size()) -
                                                  triangles.all.size();
  name_singular(plan.singular, surface.domain, report);
  mesher.complete(triangles, report);
  Grid& grid = mesher.grid();
  finisher.cut_infinite(triangles.all, report);
  grid.mesh.triangles = std::move(triangles.all);
  grid.mesh.lines =
      leaf_lines(grid, mesher.tree(), mesher.mesh().leaves, plan.line_counts.u, plan.line_counts.v);
  const auto is_singular = [&](std::uint32_t corner) {
    return !mesher.tree().geometry().is_regular_corner(corner);
  };
  face_own_triangles(surface, request.threads, is_singular, grid.mesh);
  if (request.clip) {
    clip_mesh(*request.clip, grid.mesh);
    keep_singular_points_within(*request.clip, surface, request.threads, report);
  }
  keep_used_corners(grid.mesh);
  result.mesh = std::move(grid.mesh);
  return result;
}

}  // namespace

std::optional<MeshResult> mesh_within_tolerance(const Surface& surface,
                                                const MeshRequest& request) {
  std::optional<MeshPlan> plan = plan_mesh(surface, request);
  if (!plan) return std::nullopt;
  return mesh_within_tolerance(surface, request, std::move(*plan));
}

std::optional<MeshResult> mesh_within_tolerance(const Surface& surface, const MeshRequest& request,
                                                MeshPlan plan) {
  MeshResult result{{}, report_of(plan)};
  std::vector<Counterexample> counterexamples =
      find_counterexamples(plan.probe, plan.lines, tolerance_within(request.clip, plan.aim));
  if (plan.lines.u.size() * plan.lines.v.size() > request.leaves_at_a_time)
    set_large_arrays_apart();
  AdaptiveMesher mesher(surface, request, plan);
  mesher.run(std::move(counterexamples));
  return finish(surface, request, plan, mesher, std::move(result));
}

}  // namespace saddle
