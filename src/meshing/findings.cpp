#include "meshing/findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "base/format.h"
#include "mesh/model/tolerances.h"
#include "meshing/place_groups.h"

namespace saddle {
namespace {

/// Triangles without area are usual at poles, a row or two of a grid; a larger share is a surface
/// that doubles cannot hold.
constexpr double kManyFlat = 0.1;

/// A share of the domain of 0.999 and more is told as all of it; one below 0.001 not in percent.
constexpr double kLeastPercent = 1e-3;

/// Gaps with room for a visible feature warn if they cover at most 1 % of the domain, and one has
/// room for 30 tolerances: bounds are that wide in a small part because of the surface there. Wide
/// bounds of a long formula leave room in several percent or nowhere.
constexpr double kSmallShare = 0.01;
constexpr double kLargeRoom = 30;

std::string number(double value) {
  return rounded(value, kToldDigits);
}

std::string place(const dvec2& uv, const Domain& domain) {
  const dvec2 clean = without_rounding(uv, domain, kRoundingOfSums);
  return domain.names[0] + " = " + number(clean.x) + ", " + domain.names[1] + " = " +
         number(clean.y);
}

std::string range(const std::string& name, double low, double high) {
  return range_text(name, low, high, kToldDigits);
}

/// The range between two faces of a box, either of which may be infinitely far.
std::string clipped_range(const char* name, double low, double high) {
  if (std::isfinite(low) && std::isfinite(high)) return full_range_text(name, low, high);
  if (std::isfinite(low)) return std::string(name) + " from " + number(low) + " up";
  if (std::isfinite(high)) return std::string(name) + " up to " + number(high);
  return "";
}

/// A mesh that is cut along a box does not show where the surface is defined beyond it.
std::string undefined_part(const MeshResult& result, const Domain& domain) {
  const std::string percent = number(100 * result.report.unexpected_fraction());
  const std::string what =
      result.report.exceeds_doubles ? "larger than doubles can hold" : "undefined";
  std::string share = (percent == "100" ? "almost all" : percent + " %") + " of the domain is " +
                      what + " and left out";
  if (result.report.region) return share + " inside of the region";
  if (result.report.is_clipped) return share;
  return share + ", " + where_defined(result.mesh, domain);
}

std::string plural(std::size_t count, const std::string& one, const std::string& many) {
  return count == 1 ? "1 " + one : std::to_string(count) + " " + many;
}

std::string others(std::size_t count) {
  return count > 1 ? " and " + plural(count - 1, "other point", "other points") : "";
}

/// An error that a search found, so that the true one may be larger.
std::string off_by(const MeshReport& report) {
  return " off by at least " + number(report.max_error) + " (the tolerance is " +
         number(report.tolerance.value_or(0)) + ")";
}

Finding::Place at(const dvec2& uv) {
  return {uv, uv};
}

}  // namespace

std::string where_defined(const Mesh& mesh, const Domain& domain) {
  dvec2 low = mesh.uv.front();
  dvec2 high = low;
  for (const dvec2& uv : mesh.uv) {
    low = glm::min(low, uv);
    high = glm::max(high, uv);
  }
  // An end that only rounding tells from 0, as of the bisection for the boundary of sqrt(u), is 0.
  const auto trimmed = [](double end, double width) {
    return std::abs(end) < kSame * std::abs(width) ? 0 : end;
  };
  for (dvec2* const end : {&low, &high}) {
    *end = {trimmed(end->x, domain.u1 - domain.u0), trimmed(end->y, domain.v1 - domain.v0)};
  }
  // All of a range, as far as its ends are printed.
  const auto is_whole = [](double from, double to, double first, double last) {
    return number(from) == number(std::min(first, last)) &&
           number(to) == number(std::max(first, last));
  };
  const bool whole_u = is_whole(low.x, high.x, domain.u0, domain.u1);
  const bool whole_v = is_whole(low.y, high.y, domain.v0, domain.v1);
  if (whole_u && whole_v) return "in places across the ranges";
  const std::string u = whole_u ? "" : range(domain.names[0], low.x, high.x);
  const std::string v = whole_v ? "" : range(domain.names[1], low.y, high.y);
  return "at least outside of " + u + (u.empty() || v.empty() ? "" : ", ") + v;
}

namespace {

using Kind = Finding::Kind;

/// Collects the findings about a mesh, in this order.
class MeshFindings {
 public:
  MeshFindings(const MeshResult& result, const Domain& domain, bool shares_limits)
      : result_(result), report_(result.report), domain_(domain), shares_limits_(shares_limits) {}

  std::vector<Finding> all() {
    take_missing_parts();
    take_errors();
    take_cuts();
    take_clip();
    take_sides();
    take_singular_points();
    take_proof_gaps();
    return std::move(findings_);
  }

 private:
  Finding& warn(Kind kind, std::string text) {
    findings_.push_back({kind, std::move(text), true});
    return findings_.back();
  }
  static void count(std::size_t number, const char* unit, Finding& finding) {
    finding.value = static_cast<double>(number);
    finding.unit = unit;
  }

  void take_missing_parts() {
    if (report_.unexpected_fraction() > 0 && !result_.mesh.uv.empty()) {
      warn(Kind::Undefined, undefined_part(result_, domain_)).share = report_.unexpected_fraction();
    }
    if (report_.flat_triangles == 0) return;
    const std::size_t triangles = report_.flat_triangles + result_.mesh.triangles.size();
    Finding& flat = warn(
        Kind::Flat, std::to_string(report_.flat_triangles) + " of " + std::to_string(triangles) +
                        " triangles have no area in double precision and are left out");
    flat.warns =
        static_cast<double>(report_.flat_triangles) > kManyFlat * static_cast<double>(triangles);
    count(report_.flat_triangles, "triangles", flat);
  }

  /// The option whose limit stopped refinement.
  const char* limit_option() const {
    if (report_.shortage == Shortage::Time) return "--max-time";
    return report_.shortage == Shortage::Memory ? "--max-memory" : "--max-triangles";
  }

  /// The number of triangles that the tolerance needs, if the mesh has fewer.
  std::string least_text() const {
    const double least = report_.least_triangles;
    if (!(least > static_cast<double>(result_.mesh.triangles.size()))) return "";
    const double unit = std::pow(10.0, std::max(std::floor(std::log10(least)) - 1, 0.0));
    return ", the tolerance needs " + formatted("%.0f", std::floor(least / unit) * unit) +
           " at least";
  }

  /// Why the mesh is off, and what helps; empty if it is within its tolerance.
  std::string error_text() const {
    const bool exceeds_tolerance = report_.tolerance && report_.max_error > *report_.tolerance;
    std::string off = off_by(report_);
    if (report_.worst_place) off += ", as at " + place(*report_.worst_place, domain_);
    std::string state = ", the mesh is" + off;
    // Refinement may be stopped while all errors that are known are within the tolerance.
    if (report_.tolerance && !exceeds_tolerance)
      state = ": errors above the tolerance, " + number(*report_.tolerance) + ", may hide";
    const auto stopped = [&state](const std::string& limit, const std::string& more) {
      return "the limit of " + limit + " stopped refinement" + state + "; " + more;
    };
    if (report_.shortage == Shortage::Time) return stopped("time", "--max-time allows more");
    if (report_.shortage == Shortage::Memory) return stopped("memory", "--max-memory allows more");
    const std::string fewer = shares_limits_ ? "fewer surfaces or " : "";
    if (report_.budget_spent)
      return stopped("work", fewer + "smaller ranges show more, --max-triangles allows more work");
    if (report_.reached_limit)
      return stopped("triangles", fewer + "--max-triangles allows more" + least_text());
    if (!exceeds_tolerance) return "";
    if (report_.rounding) {
      return "the mesh is" + off + ": its coordinates are so large that doubles round them by " +
             number(*report_.rounding) + "; subtract what they have in common";
    }
    if (report_.oscillates) {
      return "the surface oscillates faster than its tolerance shows, as at " +
             place(*report_.oscillates, domain_) + "; the mesh is" + off_by(report_) +
             " there; smaller ranges show more";
    }
    const auto is_lost = [this](const ProofGap& gap) {
      return gap.why == GapReason::Flat && report_.worst_place &&
             gap.contains(*report_.worst_place);
    };
    if (std::ranges::any_of(report_.proof_gaps, is_lost))
      return "the mesh is" + off + ": triangles there have no area in double precision";
    return "the mesh is" + off +
           ": a pole, a jump or detail that its cells miss; --samples takes more";
  }

  void take_errors() {
    if (const std::string text = error_text(); !text.empty()) {
      Finding& off = warn(Kind::OffTolerance, text);
      off.value = report_.max_error;
      off.unit = "length";
      if (const auto uv = report_.worst_place ? report_.worst_place : report_.oscillates)
        off.place = at(*uv);
    }
    if (report_.coarse_normals) {
      Finding& turn =
          warn(Kind::NormalsTurn, "normals turn faster than its triangles show, by up to " +
                                      number(report_.max_normal_error) + " degrees, as at " +
                                      place(*report_.coarse_normals, domain_) + "; " +
                                      limit_option() + " allows more");
      turn.value = report_.max_normal_error;
      turn.unit = "degrees";
      turn.place = at(*report_.coarse_normals);
    }
  }

  /// How often the mesh was cut is no property of the surface: only the places are told.
  void take_cut(Kind kind, const char* what, std::size_t number, std::span<const dvec2> places,
                const ParameterLines& lines) {
    if (places.empty()) return;
    const ToldCuts cuts(places, lines, domain_);
    Finding& cut = warn(kind, std::string(what) + " and is cut there: " +
                                  cuts.text(number > places.size(), kToldDigits));
    const auto [low, high] = cuts.box();
    cut.place = {low, high};
  }

  void take_cuts() {
    take_cut(Kind::Pole, "the surface goes to infinity", report_.pole_count, report_.poles,
             report_.pole_lines);
    const auto& torn = report_.without_limit;
    take_cut(Kind::Jump, "the surface jumps", report_.jump_count - torn.size(),
             std::span(report_.jumps).subspan(torn.size()), report_.jump_lines);
    if (torn.empty()) return;
    Finding& no_limit =
        warn(Kind::NoLimit, "the surface has no limit at " + place(torn.front(), domain_) +
                                others(torn.size()) +
                                ": each way there leads to another place; left out");
    count(torn.size(), "points", no_limit);
    no_limit.place = at(torn.front());
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
    warn(Kind::Clipped, why + "clipped to " + ranges + "; --clip off shows all of it");
  }

  void take_sides() {
    if (!report_.orientable)
      warn(Kind::OneSided, "the surface is one-sided: front and back meet along a line");
    if (runs_backwards(domain_))
      warn(Kind::Backwards, "a range runs backwards, which swaps front and back");
  }

  void take_singular_points() {
    const auto& places = report_.singular_points;
    const auto no_limit = [](const SingularPoint& p) { return !p.has_limit; };
    const auto first = std::ranges::find_if(places, no_limit);
    if (first == places.end()) return;
    // Many places may be one point of space, as at the apex of a cone.
    const auto has_no_normal = [&](const SingularInSpace& point) {
      return std::ranges::any_of(point.places, [&](std::size_t k) { return !places[k].has_limit; });
    };
    const auto number =
        static_cast<std::size_t>(std::ranges::count_if(report_.singular_in_space, has_no_normal));
    const bool all_listed = places.size() == report_.singular_point_count;
    Finding& singular =
        warn(Kind::NoNormal,
             (all_listed ? "" : "at least ") +
                 plural(number, "singular point has no normal", "singular points have no normal") +
                 " (the first at " + place(first->uv, domain_) + "): the faces' are drawn there");
    count(number, "points", singular);
    singular.place = at(first->uv);
  }

  /// One finding for the gaps of each reason, which are neighbours in the list.
  void take_proof_gaps() {
    const std::span<const ProofGap> gaps = report_.proof_gaps;
    for (std::size_t first = 0; first < gaps.size();) {
      std::size_t end = first + 1;
      while (end < gaps.size() && gaps[end].why == gaps[first].why) ++end;
      take_proof_gap(gaps.subspan(first, end - first));
      first = end;
    }
  }

  void take_proof_gap(std::span<const ProofGap> gaps) {
    ProofGap all = gaps.front();
    for (const ProofGap& gap : gaps.subspan(1)) all = united(all, gap);
    const std::string share = all.share >= 1 - kLeastPercent ? "the domain" : share_text(all.share);
    std::string text =
        share + " is not proved, as at " + place(all.worst, domain_) + ": " + words_for(all.why);
    const bool may_hide = all.visible > 0 && follows_from_bounds(all.why);
    if (may_hide) text = hidden(all) + ": " + share + " is not proved; " + words_for(all.why);
    Finding unproved{Kind::Unproved, std::move(text), hides_visible(all)};
    if (may_hide) {
      unproved.value = all.width;
      unproved.unit = "parameters";
    }
    unproved.place = {all.low, all.high};
    if (all.share > 0) unproved.share = all.share;
    findings_.push_back(std::move(unproved));
  }

  static std::string share_text(double share) {
    return (share >= kLeastPercent ? number(100 * share) + " %" : number(share)) + " of the domain";
  }

  std::string hidden(const ProofGap& gap) const {
    const std::string high =
        std::isfinite(gap.room) ? "up to " + number(gap.room) + " high and " : "";
    return "a feature " + high + "narrower than " + number(gap.width) + " could be missing near " +
           place(gap.worst, domain_);
  }

  bool hides_visible(const ProofGap& gap) const {
    return follows_from_bounds(gap.why) && gap.visible > 0 && visible_share() <= kSmallShare &&
           gap.room > kLargeRoom * report_.tolerance.value_or(0);
  }

  double visible_share() const {
    double share = 0;
    for (const ProofGap& gap : report_.proof_gaps) {
      if (follows_from_bounds(gap.why)) share += gap.visible;
    }
    return share;
  }

  const MeshResult& result_;
  const MeshReport& report_;
  const Domain& domain_;
  bool shares_limits_;
  std::vector<Finding> findings_;
};

}  // namespace

std::string name_of(Kind kind) {
  static constexpr std::array kNames = {"undefined",
                                        "flat",
                                        "off-tolerance",
                                        "normals-turn",
                                        "pole",
                                        "jump",
                                        "no-limit",
                                        "clipped",
                                        "one-sided",
                                        "backwards",
                                        "no-normal",
                                        "color-undefined",
                                        "color-infinite",
                                        "color-coarse",
                                        "contours-none",
                                        "contours-on-area",
                                        "contours-coarse",
                                        "too-thick",
                                        "solid-crosses",
                                        "unproved",
                                        "nothing",
                                        "no-light",
                                        "cone-lost"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<Finding> mesh_findings(const MeshResult& mesh, const Domain& domain,
                                   bool shares_limits) {
  return MeshFindings(mesh, domain, shares_limits).all();
}

std::vector<std::string> warnings_of(const std::string& name, std::span<const Finding> findings) {
  std::vector<std::string> warnings;
  for (const Finding& finding : findings) {
    if (finding.warns) warnings.push_back(name + ": " + finding.text);
  }
  return warnings;
}

}  // namespace saddle
