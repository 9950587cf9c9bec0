#include "meshing/warnings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "base/format.h"

namespace saddle {
namespace {

/// Triangles without area are usual at poles, a row or two of a grid; a larger share is a surface
/// that doubles cannot hold.
constexpr double kManyFlat = 0.1;

/// Numbers below this share of their range are written as 0: errors of rounding.
constexpr double kNothing = 1e-12;

/// Four digits: enough to find the place, short enough to read.
std::string number(double value) {
  return rounded(value, 4);
}

/// A place in the domain. A bisection may end at 1e-20 where 0 is meant.
std::string place(const dvec2& uv, const Domain& domain) {
  const auto coordinate = [](double value, double from, double to) {
    return number(std::fabs(value) < kNothing * std::fabs(to - from) ? 0 : value);
  };
  return "u = " + coordinate(uv.x, domain.u0, domain.u1) +
         ", v = " + coordinate(uv.y, domain.v0, domain.v1);
}

std::string range(const char* name, double low, double high) {
  return std::string(name) + " = " + number(low) + ":" + number(high);
}

/// The range between two faces of a box, either of which may be infinitely far.
std::string clipped_range(const char* name, double low, double high) {
  if (std::isfinite(low) && std::isfinite(high)) return range(name, low, high);
  if (std::isfinite(low)) return std::string(name) + " from " + number(low) + " up";
  if (std::isfinite(high)) return std::string(name) + " up to " + number(high);
  return "";
}

/// A mesh that is cut along a box does not show where the surface is defined beyond it.
std::string undefined_warning(const MeshResult& grid_mesh, const Domain& domain) {
  const std::string percent = number(100 * grid_mesh.report.undefined_fraction);
  const std::string what =
      grid_mesh.report.exceeds_doubles ? "larger than doubles can hold" : "undefined";
  std::string share = (percent == "100" ? "almost all" : percent + " %") + " of the domain is " +
                      what + " and left out";
  if (grid_mesh.report.is_clipped) return share;
  return share + ", " + where_defined(grid_mesh.mesh, domain);
}

std::string plural(std::size_t count, const std::string& one, const std::string& many) {
  return count == 1 ? "1 " + one : std::to_string(count) + " " + many;
}

std::string others(std::size_t count) {
  return count > 1 ? " and " + plural(count - 1, "other point", "other points") : "";
}

std::string off_by(const MeshReport& report) {
  return " off by up to " + number(report.max_error) + " (the tolerance is " +
         number(report.tolerance.value_or(0)) + ")";
}

}  // namespace

std::string where_defined(const Mesh& mesh, const Domain& domain) {
  dvec2 low = mesh.uv.front();
  dvec2 high = low;
  for (const dvec2& uv : mesh.uv) {
    low = glm::min(low, uv);
    high = glm::max(high, uv);
  }
  // All of a range, as far as its ends are printed.
  const auto is_whole = [](double from, double to, double first, double last) {
    return number(from) == number(std::min(first, last)) &&
           number(to) == number(std::max(first, last));
  };
  const bool whole_u = is_whole(low.x, high.x, domain.u0, domain.u1);
  const bool whole_v = is_whole(low.y, high.y, domain.v0, domain.v1);
  if (whole_u && whole_v) return "in places across the ranges";
  const std::string u = whole_u ? "" : range("u", low.x, high.x);
  const std::string v = whole_v ? "" : range("v", low.y, high.y);
  return "at least outside of " + u + (u.empty() || v.empty() ? "" : ", ") + v;
}

namespace {

/// Collects the warnings about a mesh, in this order.
class MeshWarnings {
 public:
  MeshWarnings(const std::string& name, const MeshResult& grid_mesh, const Domain& domain)
      : name_(name), grid_mesh_(grid_mesh), report_(grid_mesh.report), domain_(domain) {}

  std::vector<std::string> all() {
    take_missing_parts();
    take_errors();
    take_cuts();
    take_clip();
    take_sides();
    take_singular_points();
    return std::move(warnings_);
  }

 private:
  void say(const std::string& text) { warnings_.push_back(name_ + ": " + text); }

  void take_missing_parts() {
    if (report_.undefined_fraction > 0 && !grid_mesh_.mesh.uv.empty()) {
      say(undefined_warning(grid_mesh_, domain_));
    }
    const std::size_t triangles = 2 * report_.cells;
    if (static_cast<double>(report_.flat_triangles) > kManyFlat * static_cast<double>(triangles)) {
      say(std::to_string(report_.flat_triangles) + " of " + std::to_string(triangles) +
          " triangles have no area in double precision and are left out");
    }
  }

  void take_errors() {
    const bool exceeds_tolerance = report_.tolerance && report_.max_error > *report_.tolerance;
    const std::string off =
        off_by(report_) +
        (report_.worst_place ? ", as at " + place(*report_.worst_place, domain_) : std::string());
    if (report_.budget_spent) {
      say("the limit of work stopped refinement, the mesh is" + off +
          "; smaller ranges show more, --max-triangles allows more work");
    } else if (report_.reached_limit) {
      say("the limit of triangles stopped refinement, the mesh is" + off +
          "; --max-triangles allows more");
    } else if (exceeds_tolerance && report_.oscillates) {
      say("the surface oscillates faster than its tolerance shows, as at " +
          place(*report_.oscillates, domain_) + "; the mesh is" + off_by(report_) +
          " there; smaller ranges show more");
    } else if (exceeds_tolerance) {
      say("the mesh is" + off +
          ": a pole, a jump or detail that its cells miss; --samples takes more");
    }
    if (report_.coarse_normals) {
      say("normals turn faster than its triangles show, by up to " +
          number(report_.max_normal_error) + " degrees, as at " +
          place(*report_.coarse_normals, domain_) + "; --max-triangles allows more");
    }
  }

  void take_cuts() {
    const auto cut = [this](const char* what, std::size_t count, std::span<const dvec2> places) {
      if (places.empty()) return;
      say(std::string(what) + ": it was cut in " + plural(count, "place", "places") +
          (count == 1 ? " (at " : " (the first at ") + place(places.front(), domain_) + ")");
    };
    cut("the surface goes to infinity", report_.pole_count, report_.poles);
    const std::size_t torn = report_.without_limit.size();
    cut("the surface jumps", report_.jump_count - torn, std::span(report_.jumps).subspan(torn));
    if (!report_.without_limit.empty()) {
      say("the surface has no limit at " + place(report_.without_limit.front(), domain_) +
          others(report_.without_limit.size()) +
          ": each way there leads to another place; left out");
    }
  }

  void take_clip() {
    if (!report_.clip) return;
    std::string ranges;
    for (int k = 0; k < 3; ++k) {
      const std::string faces =
          clipped_range(std::array{"x", "y", "z"}[static_cast<std::size_t>(k)],
                        report_.clip->low[k], report_.clip->high[k]);
      if (!faces.empty()) ranges += (ranges.empty() ? "" : ", ") + faces;
    }
    if (ranges.empty()) return;
    const std::string why = report_.pole_count > 0 ? "" : "x, y and z are out of proportion: ";
    say(why + "clipped to " + ranges + "; --clip off shows all of it");
  }

  void take_sides() {
    if (!report_.orientable) say("the surface is one-sided: front and back meet along a line");
    if (runs_backwards(domain_)) say("a range runs backwards, which swaps front and back");
  }

  void take_singular_points() {
    const auto& points = report_.singular_points;
    const auto no_limit = [](const SingularPoint& p) { return !p.has_limit; };
    const auto first = std::ranges::find_if(points, no_limit);
    if (first == points.end()) return;
    const auto count = static_cast<std::size_t>(std::ranges::count_if(points, no_limit));
    const bool all_listed = points.size() == report_.singular_point_count;
    say((all_listed ? "" : "at least ") +
        plural(count, "singular point has no normal", "singular points have no normal") +
        " (the first at " + place(first->uv, domain_) + "): the faces' are drawn there");
  }

  const std::string& name_;
  const MeshResult& grid_mesh_;
  const MeshReport& report_;
  const Domain& domain_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> mesh_warnings(const std::string& name, const MeshResult& grid_mesh,
                                       const Domain& domain) {
  return MeshWarnings(name, grid_mesh, domain).all();
}

std::vector<std::string> color_warnings(const std::string& name, const Mesh& mesh,
                                        const ColorReport& report) {
  std::vector<std::string> warnings;
  if (report.undefined_share > 0) {
    warnings.push_back(name + ": the colour is undefined on " +
                       number(100 * report.undefined_share) + " % of the surface, which is grey");
  }
  if (report.is_clamped) {
    warnings.push_back(name + ": the colour goes to infinity; its range is cut to " +
                       number(mesh.color_range.low) + ":" + number(mesh.color_range.high));
  }
  if (report.reached_limit) {
    warnings.push_back(name +
                       ": the limit of triangles stopped refinement for the colour, which is "
                       "blurred; --max-triangles allows more");
  }
  return warnings;
}

}  // namespace saddle
