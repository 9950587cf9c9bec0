#include "app/report/describe.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/report/words.h"
#include "base/format.h"
#include "mesh/model/mesh_report.h"
#include "meshing/findings.h"

namespace saddle {

namespace {

std::string percent(double share) {
  return words::number(100 * share) + " %";
}

/// Without what is 0 next to `size` but for rounding.
double clean(double x, double size) {
  return std::fabs(x) < 1e-12 * size ? 0 : x;
}

std::string domain(const Facts& facts) {
  const Domain& d = facts.domain;
  const auto& [u, v] = d.names;
  return words::range(u, d.u0, d.u1) + ", " +
         (facts.range_v.empty() ? words::range(v, d.v0, d.v1) : v + " = " + facts.range_v);
}

std::string defined(const SurfaceReport& s, const Mesh& mesh) {
  const DefinedShare& proved = s.facts->defined;
  if (s.mesh.region) {
    const double undefined = s.mesh.region->undefined;
    return undefined == 0 ? "everywhere in the region that was looked at"
                          : "not on " + percent(undefined) + " of the domain inside of the region";
  }
  // A mesh that is cut along a box does not show where the surface is defined beyond it.
  const std::string where = percent(s.mesh.undefined_fraction) + " of the domain" +
                            (s.mesh.is_clipped ? "" : ", " + where_defined(mesh, s.facts->domain));
  const std::string large = "larger than doubles can hold on " + where;
  if (proved.everywhere) {
    return std::string("everywhere (proved)") + (s.mesh.exceeds_doubles ? ", but " + large : "");
  }
  const std::string bounds = " (proved: " + percent(proved.no) + " undefined, " +
                             percent(proved.yes) + " defined, the rest undecided)";
  const bool is_hidden = s.mesh.undefined_fraction == 0 && proved.undefined_at;
  if (is_hidden) return "not " + words::near(*proved.undefined_at, s.facts->domain) + bounds;
  if (s.mesh.undefined_fraction == 0) return "everywhere that was looked at" + bounds;
  return (s.mesh.exceeds_doubles ? large : "not on " + where) + bounds;
}

std::string edges(const std::string& name, double first, double last, const std::string& how,
                  const Shift& shift) {
  const std::string both =
      name + " = " + words::number(first) + " and " + name + " = " + words::number(last);
  if (how == "reversed") return both + " join reversed";
  if (how == "shifted") {
    return both + " join shifted by " + std::to_string(shift.parts) + "/" +
           std::to_string(shift.of) + " of their length";
  }
  return both + " join";
}

std::string seams(const SurfaceReport& s) {
  const Domain& d = s.facts->domain;
  const auto& [u, v] = d.names;
  std::string text;
  if (!s.mesh.closed_u.empty()) text += edges(u, d.u0, d.u1, s.mesh.closed_u, s.mesh.shift_u);
  if (!s.mesh.closed_v.empty()) {
    text += (text.empty() ? "" : "; ") + edges(v, d.v0, d.v1, s.mesh.closed_v, s.mesh.shift_v);
  }
  const auto add_fold = [&text](const std::string& edge) {
    text += (text.empty() ? "" : "; ") + edge + " is folded: its halves join";
  };
  for (std::size_t k = 0; k < 2; ++k) {
    if (s.mesh.folded_u[k]) add_fold(u + " = " + words::number(k == 0 ? d.u0 : d.u1));
    if (s.mesh.folded_v[k]) add_fold(v + " = " + words::number(k == 0 ? d.v0 : d.v1));
  }
  return text.empty() ? "none" : text;
}

/// The name of a closed surface by its Euler number; empty for one that touches itself in points.
std::string closed_kind(long euler_number, bool orientable) {
  if (!orientable) {
    return euler_number == 1 ? "projective plane" : euler_number == 0 ? "Klein bottle" : "";
  }
  if (euler_number == 2) return "sphere";
  if (euler_number == 0) return "torus";
  if (euler_number > 0 || euler_number % 2 != 0) return "";
  return "sphere with " + std::to_string(1 - euler_number / 2) + " handles";
}

/// The name of a connected surface, closed or with holes.
std::string kind(const Topology& t) {
  if (t.components != 1 || t.shared_edges > 0 || t.pinched_points > 0) return "";
  const auto holes = static_cast<long>(t.boundary_loops);
  const std::string filled = closed_kind(t.euler_number + holes, t.orientable);
  if (filled.empty()) return "";
  if (filled == "sphere" && holes == 1) return " (a disc)";
  if (filled == "sphere" && holes == 2) return " (a band)";
  if (filled == "projective plane" && holes == 1) return " (a Moebius band)";
  return " (a " + filled + (holes > 0 ? " with " + words::plural(t.boundary_loops, "hole") : "") +
         ")";
}

/// How a surface is closed whose mesh is, after the mesh's Euler number.
std::string closed(const Facts& facts) {
  if (facts.closed == Closed::Yes) return "closed";
  if (facts.closed == Closed::No) {
    return "not closed: the mesh covers a hole " +
           words::near(*facts.defined.undefined_at, facts.domain);
  }
  std::string text = "closed as far as it was sampled";
  if (facts.defined.undecided_at) {
    text += "; a hole is not excluded " + words::near(*facts.defined.undecided_at, facts.domain);
  } else {
    text += "; jumps are not excluded";
  }
  return text;
}

std::string shape(const Facts& facts) {
  const Topology& t = facts.topology;
  const bool covers_hole = t.is_closed() && facts.closed == Closed::No;
  std::string text = "Euler number " + std::to_string(t.euler_number) +
                     (covers_hole ? " of the mesh" : kind(t)) + ", ";
  if (t.components != 1) text += words::plural(t.components, "part") + ", ";
  if (t.pinched_points > 0) {
    text += words::plural(t.pinched_points, "point") + " where sheets touch, ";
  }
  if (t.is_closed()) return text + closed(facts);
  text += t.boundary_loops == 1 ? "one edge" : std::to_string(t.boundary_loops) + " edges";
  if (t.shared_edges > 0)
    text += ", " + words::plural(t.shared_edges, "line piece") + " where sheets meet";
  return text;
}

std::string extents(const Bounds& b) {
  const auto side = [&](const char* name, int k) {
    return words::range(name, clean(b.low[k], b.diagonal()), clean(b.high[k], b.diagonal()));
  };
  return side("x", 0) + ", " + side("y", 1) + ", " + side("z", 2);
}

/// The part of the largest principal curvatures that is rounding. Curvatures beyond the second
/// constant, times the diagonal, belong to few places and do not affect the others' rounding.
constexpr double kRoundingOfCurvature = 1e-12;
constexpr double kUsualCurvature = 100;

std::string curvatures(const Facts& facts) {
  const ValueRange& gauss = facts.measures.gauss;
  const ValueRange& mean = facts.measures.mean;
  if (gauss.empty() || mean.empty()) return "none: no regular point was found";
  const auto size = [](const ValueRange& range) {
    const double low = std::isfinite(range.low) ? std::fabs(range.low) : 0;
    return std::isfinite(range.high) ? std::max(low, std::fabs(range.high)) : low;
  };
  const double largest = std::min(std::max(size(mean), std::sqrt(size(gauss))),
                                  kUsualCurvature / facts.measures.extents.diagonal());
  const double rounding = kRoundingOfCurvature * largest;
  const double square = rounding * largest;
  const std::string found = "Gauss " + words::found(gauss, square, facts.domain) + ", mean " +
                            words::found(mean, rounding, facts.domain);
  const std::string of_gauss = words::proved(gauss, square);
  const std::string of_mean = words::proved(mean, rounding);
  if (of_gauss.empty() && of_mean.empty()) return found + " (found by a search, not proved)";
  std::string proved;
  if (!of_gauss.empty()) proved = "Gauss " + of_gauss;
  if (!of_mean.empty()) proved += (proved.empty() ? "mean " : ", mean ") + of_mean;
  return found + " (found by a search; proved: " + proved + ")";
}

/// Gauss curvatures that are 0 but for rounding, times the diagonal's square.
constexpr double kFlatSurface = 1e-9;

std::string mesh(const SurfaceReport& s) {
  const double flat = kFlatSurface / (s.bounds.diagonal() * s.bounds.diagonal());
  std::string text = words::plural(s.triangles, "triangle");
  if (s.mesh.tolerance) {
    text += " for a tolerance of " + words::number(*s.mesh.tolerance) +
            (s.mesh.error_is_bound ? " (proved: at most " : " (a search found ") +
            words::number(s.mesh.max_error) + ")";
  }
  const double least = s.mesh.least_triangles;
  if (!(least >= 1)) {
    const bool is_flat = s.facts->measures.gauss.low > -flat && s.facts->measures.gauss.high < flat;
    return text + (is_flat ? "; what unrolls into a plane has no least number" : "");
  }
  const std::string times = rounded(static_cast<double>(s.triangles) / least, 3);
  return text + ": " + times + " times the least possible, about " +
         words::number(std::ceil(least)) + "; half the tolerance takes twice as many";
}

/// A share of less than 0.01 % of the domain is not told as proved.
constexpr double kHundredthPercent = 1e-4;

/// The share that is proved; of each reason against it the first place, and how many others it has.
std::string proof(const MeshReport& report, const Domain& domain) {
  if (report.certified) return "within 4 tolerances of the mesh everywhere (proved)";
  std::string text;
  for (std::size_t k = 0; k < report.proof_gaps.size();) {
    const ProofGap& place = report.proof_gaps[k];
    std::size_t next = k + 1;
    while (next < report.proof_gaps.size() && report.proof_gaps[next].why == place.why) ++next;
    text += (k > 0 ? "; " : "") + words_for(place.why) + ": " +
            words::range(domain.names[0], place.low.x, place.high.x) + ", " +
            words::range(domain.names[1], place.low.y, place.high.y);
    if (next > k + 1) text += " and " + words::plural(next - k - 1, "other place");
    k = next;
  }
  const double proved = std::floor(report.proved_fraction / kHundredthPercent) * kHundredthPercent;
  if (proved == 0) return "samples only: " + text;
  return "on " + words::number(100 * proved) +
         " % of the domain within 4 tolerances of the mesh (proved), but for places where " + text;
}

/// The solid that it is with its thickness.
std::string thick(const SolidReport& s) {
  std::string text = words::number(s.thickness) + " thick, " + (s.facts.closed ? "closed" : "open");
  text += s.facts.shells == 1 ? ", 1 shell" : ", " + std::to_string(s.facts.shells) + " shells";
  text += ", volume " + words::number(s.facts.volume);
  if (std::isfinite(s.largest_thickness)) {
    text += "; folds where thicker than " + words::number(s.largest_thickness);
  }
  return text;
}

std::string sides(const Facts& facts) {
  if (!facts.topology.orientable) return "one: the surface is not orientable";
  return facts.turns_over ? "two, but front and back change places within it" : "two";
}

}  // namespace

std::vector<std::string> describe(const SurfaceReport& s, const Mesh& triangles) {
  const Facts& facts = *s.facts;
  std::vector<std::string> lines = {s.name};
  const auto line = [&lines](const std::string& what, const std::string& said) {
    lines.push_back("  " + what + std::string(12 - what.size(), ' ') + said);
  };
  line("domain", domain(facts));
  if (s.mesh.region) {
    line("region", facts.where + ": " + percent(1 - s.mesh.region->outside) + " of the domain");
  }
  line("defined", defined(s, triangles));
  line("poles", words::cuts(s.mesh.poles, s.mesh.pole_count, s.mesh.pole_lines, facts.domain));
  line("jumps", words::jumps(s.mesh, facts.domain));
  line("singular", words::singular(facts, s.bounds.diagonal()));
  line("seams", seams(s));
  line("sides", sides(facts));
  line("shape", shape(facts));
  line("extents", extents(facts.measures.extents));
  const double size = s.bounds.diagonal();
  line("area", words::measure(facts.measures.area, size, 2));
  if (encloses_volume(facts)) line("volume", words::measure(facts.measures.volume, size, 3));
  line("curvature", curvatures(facts));
  if (s.solid) line("solid", thick(*s.solid));
  line("mesh", mesh(s));
  line("proof", proof(s.mesh, facts.domain));
  for (const Finding& finding : s.findings) line("finding", finding.text);
  return lines;
}

std::vector<std::string> describe_stroke(const SurfaceReport& report) {
  std::vector<std::string> lines = {report.name};
  if (report.place) {
    const dvec3& p = *report.place;
    lines.push_back("  point at " + words::number(p.x) + ", " + words::number(p.y) + ", " +
                    words::number(p.z));
    return lines;
  }
  const CurveMesh& curve = *report.curve;
  lines.push_back("  curve of length " + words::number(curve.length) +
                  (curve.closed ? ", closed" : ""));
  if (curve.undefined_fraction > 0) {
    lines.push_back("  undefined over " + percent(curve.undefined_fraction) + " of the range of s");
  }
  lines.push_back("  " + percent(curve.proved_fraction) + " of it proved to be within " +
                  words::number(curve.tolerance) + " of its chords");
  for (const Finding& finding : report.findings) lines.push_back("  " + finding.text);
  return lines;
}

}  // namespace saddle
