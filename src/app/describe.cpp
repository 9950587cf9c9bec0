#include "app/describe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include <glm/vector_relational.hpp>

#include "app/warnings.h"

namespace saddle {

namespace {

/// Six digits: what an area keeps at the least.
std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value + 0.0);  // + 0: no "-0"
  return text.data();
}

std::string percent(double share) {
  return number(100 * share) + " %";
}

std::string plural(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string range(const std::string& name, double low, double high) {
  if (low == high) return name + " = " + number(low);
  return name + " = " + number(low) + ":" + number(high);
}

/// Without what is 0 next to `size` but for rounding.
double clean(double x, double size) {
  return std::fabs(x) < 1e-12 * size ? 0 : x;
}

std::string vector(const dvec3& v, double size) {
  return "(" + number(clean(v.x, size)) + ", " + number(clean(v.y, size)) + ", " +
         number(clean(v.z, size)) + ")";
}

// --- places
// ---------------------------------------------------------------------------------------

/// Parameters this close, as a part of the range, are on one line.
constexpr double kSameLine = 1e-6;
/// And this close, of their size, they are the same but for rounding.
constexpr double kSameParameters = 1e-12;
/// Cuts this close, as a part of the range, are one place.
constexpr double kSamePlace = 1e-9;
/// So many places on a line of constant u or v are told as one.
constexpr std::size_t kLine = 12;
/// Places and lines that are told one by one.
constexpr std::size_t kTold = 6;

/// Places on a line of constant u or v, or a single one.
struct Group {
  Extremes u, v;
  std::vector<std::size_t> members;

  void add(std::size_t index, const dvec2& uv) {
    u.add(uv.x);
    v.add(uv.y);
    members.push_back(index);
  }
  std::string text() const { return range("u", u.low, u.high) + ", " + range("v", v.low, v.high); }
};

/// The most members whose parameter `axis` is within kSameLine of each other.
Group longest_line(const std::vector<dvec2>& places, const std::vector<std::size_t>& left, int axis,
                   double extent) {
  std::vector<std::size_t> sorted = left;
  std::ranges::sort(sorted, {}, [&](std::size_t k) { return places[k][axis]; });
  std::size_t best = 0;
  std::size_t best_begin = 0;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); ++begin) {
    while (end < sorted.size() &&
           places[sorted[end]][axis] - places[sorted[begin]][axis] <= kSameLine * extent) {
      ++end;
    }
    if (end - begin > best) {
      best = end - begin;
      best_begin = begin;
    }
  }
  Group group;
  double sum = 0;
  for (std::size_t k = best_begin; k < best_begin + best; ++k) {
    group.add(sorted[k], places[sorted[k]]);
    sum += places[sorted[k]][axis];
  }
  double middle = sum / static_cast<double>(std::max<std::size_t>(best, 1));
  if (std::fabs(middle) < kSameLine * extent) middle = 0;
  Extremes& line = axis == 0 ? group.u : group.v;
  line = {middle, middle};
  return group;
}

/// Lines first, the longest before the others; then single places, or all of these as one if they
/// are many.
std::vector<Group> grouped(const std::vector<dvec2>& places, const Domain& d) {
  std::vector<std::size_t> left(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) left[k] = k;
  std::vector<Group> groups;
  while (left.size() >= kLine) {
    const Group along_v = longest_line(places, left, 0, std::fabs(d.u1 - d.u0));
    const Group along_u = longest_line(places, left, 1, std::fabs(d.v1 - d.v0));
    const Group& longer = along_v.members.size() > along_u.members.size() ? along_v : along_u;
    if (longer.members.size() < kLine) break;
    std::erase_if(left, [&](std::size_t k) {
      return std::ranges::find(longer.members, k) != longer.members.end();
    });
    groups.push_back(longer);
  }
  if (left.size() > kTold) groups.emplace_back();
  for (const std::size_t k : left) {
    if (left.size() <= kTold) groups.emplace_back();
    groups.back().add(k, places[k]);
  }
  return groups;
}

/// "none", or what there is: first the count, then each line and place with what `more` adds.
std::string places(const std::vector<dvec2>& listed, std::size_t count, const Domain& domain,
                   const std::function<std::string(const Group&)>& more) {
  if (count == 0) return "none";
  std::string text = plural(count, "place");
  const std::vector<Group> groups = grouped(listed, domain);
  for (std::size_t k = 0; k < std::min(groups.size(), kTold); ++k) {
    text += (k == 0 ? ": " : "; ") + groups[k].text() + more(groups[k]);
  }
  if (groups.size() > kTold) text += "; and others";
  return text;
}

/// Places that bisections from many sides ended at, each once, and those beside 0 at 0.
std::vector<dvec2> distinct(const std::vector<dvec2>& places, const Domain& d) {
  const dvec2 near = kSamePlace * glm::abs(dvec2(d.u1 - d.u0, d.v1 - d.v0));
  std::vector<dvec2> result;
  for (dvec2 place : places) {
    for (int k = 0; k < 2; ++k) {
      if (std::fabs(place[k]) < near[k]) place[k] = 0;
    }
    const auto is_same = [&](const dvec2& other) {
      return glm::all(glm::lessThanEqual(glm::abs(place - other), near));
    };
    if (std::ranges::none_of(result, is_same)) result.push_back(place);
  }
  return result;
}

std::string cuts(const std::vector<dvec2>& listed, std::size_t count, const Domain& domain) {
  const std::vector<dvec2> told = distinct(listed, domain);
  const bool are_all_listed = count == listed.size();
  return places(told, are_all_listed ? told.size() : count, domain,
                [](const Group&) { return std::string(); });
}

/// Where the group is on the surface, if that is one point, and the normal there.
std::string point_and_normal(const std::vector<SingularPlace>& all, const Group& group,
                             double diagonal) {
  constexpr double kSamePoint = 1e-9;
  constexpr double kSameDegrees = 1e-3;
  const SingularPlace& first = all[group.members.front()];
  bool one_point = true;
  bool one_normal = true;
  std::size_t without = 0;
  for (const std::size_t k : group.members) {
    one_point &= glm::distance(all[k].position, first.position) <= kSamePoint * diagonal;
    one_normal &= all[k].normals.size() == 1 && first.normals.size() == 1 &&
                  degrees_between(all[k].normals[0], first.normals[0]) <= kSameDegrees;
    without += all[k].normals.empty() ? 1 : 0;
  }
  std::string text;
  if (one_point) text += " is the point " + vector(first.position, diagonal);
  const std::string verb = one_point ? " with" : " has";
  if (one_normal) return text + verb + " the normal " + vector(first.normals[0], 1);
  if (without == group.members.size()) return text + verb + " no normal";
  if (without > 0) return text + verb + " limits of the normal but for " + plural(without, "place");
  return text + verb + " a normal on each side";
}

// --- lines of the text
// ----------------------------------------------------------------------------

std::string domain(const Facts& facts) {
  const Domain& d = facts.domain;
  return range("u", d.u0, d.u1) + ", " +
         (facts.range_v.empty() ? range("v", d.v0, d.v1) : "v = " + facts.range_v);
}

std::string defined(const SurfaceReport& s, const Mesh& mesh) {
  const DefinedShare& proved = s.facts->defined;
  if (proved.everywhere) return "everywhere (proved)";
  const std::string bounds = "proved: " + percent(proved.no) + " undefined, " +
                             percent(proved.yes) + " defined, the rest undecided";
  if (s.mesh.undefined_fraction == 0) return "everywhere that was looked at (" + bounds + ")";
  return "not on " + percent(s.mesh.undefined_fraction) + " of the domain, " +
         where_defined(mesh, s.facts->domain) + " (" + bounds + ")";
}

std::string edges(const std::string& name, double first, double last, const std::string& how) {
  const std::string both = name + " = " + number(first) + " and " + name + " = " + number(last);
  if (how == "reversed") return both + " join reversed";
  if (how == "shifted") return both + " join shifted by half";
  return both + " join";
}

std::string seams(const SurfaceReport& s) {
  const Domain& d = s.facts->domain;
  std::string text;
  if (!s.mesh.closed_u.empty()) text += edges("u", d.u0, d.u1, s.mesh.closed_u);
  if (!s.mesh.closed_v.empty()) {
    text += (text.empty() ? "" : "; ") + edges("v", d.v0, d.v1, s.mesh.closed_v);
  }
  const auto add_fold = [&text](const std::string& edge) {
    text += (text.empty() ? "" : "; ") + edge + " is folded: its halves join";
  };
  for (std::size_t k = 0; k < 2; ++k) {
    if (s.mesh.folded_u[k]) add_fold("u = " + number(k == 0 ? d.u0 : d.u1));
    if (s.mesh.folded_v[k]) add_fold("v = " + number(k == 0 ? d.v0 : d.v1));
  }
  return text.empty() ? "none" : text;
}

/// A closed surface by its Euler number, which is none of a surface that touches itself in points.
std::string closed_kind(long euler_number, bool orientable) {
  if (!orientable) {
    return euler_number == 1 ? "projective plane" : euler_number == 0 ? "Klein bottle" : "";
  }
  if (euler_number == 2) return "sphere";
  if (euler_number == 0) return "torus";
  if (euler_number > 0 || euler_number % 2 != 0) return "";
  return "sphere with " + std::to_string(1 - euler_number / 2) + " handles";
}

/// What a connected surface is called: a closed one, or one with holes.
std::string kind(const Topology& t) {
  if (t.components != 1 || t.shared_edges > 0) return "";
  const auto holes = static_cast<long>(t.boundary_loops);
  const std::string filled = closed_kind(t.euler_number + holes, t.orientable);
  if (filled.empty()) return "";
  if (filled == "sphere" && holes == 1) return " (a disc)";
  if (filled == "sphere" && holes == 2) return " (a band)";
  if (filled == "projective plane" && holes == 1) return " (a Moebius band)";
  return " (a " + filled + (holes > 0 ? " with " + plural(t.boundary_loops, "hole") : "") + ")";
}

std::string shape(const Topology& t) {
  std::string text = "Euler number " + std::to_string(t.euler_number) + kind(t) + ", ";
  if (t.components != 1) text += plural(t.components, "part") + ", ";
  if (t.is_closed()) return text + "closed";
  text += t.boundary_loops == 1 ? "one edge" : std::to_string(t.boundary_loops) + " edges";
  if (t.shared_edges > 0)
    text += ", " + plural(t.shared_edges, "line piece") + " where sheets meet";
  return text;
}

std::string extents(const Bounds& b) {
  const auto side = [&](const char* name, int k) {
    return range(name, clean(b.low[k], b.diagonal()), clean(b.high[k], b.diagonal()));
  };
  return side("x", 0) + ", " + side("y", 1) + ", " + side("z", 2);
}

std::string curvatures(const Measures& m) {
  if (m.gauss.empty() || m.mean.empty()) return "none: no regular point was found";
  return "Gauss " + number(m.gauss.low) + " to " + number(m.gauss.high) + ", mean " +
         number(m.mean.low) + " to " + number(m.mean.high);
}

/// Gauss curvatures that are 0 but for rounding, times the diagonal's square.
constexpr double kFlatSurface = 1e-9;

std::string mesh(const SurfaceReport& s) {
  const double flat = kFlatSurface / (s.bounds.diagonal() * s.bounds.diagonal());
  std::string text = plural(s.triangles, "triangle");
  if (s.mesh.tolerance) {
    text += " for a tolerance of " + number(*s.mesh.tolerance) + " (measured " +
            number(s.mesh.max_error) + ")";
  }
  const double least = s.mesh.least_triangles;
  if (!(least >= 1)) {
    const bool is_flat = s.facts->measures.gauss.low > -flat && s.facts->measures.gauss.high < flat;
    return text + (is_flat ? "; what unrolls into a plane has no least number" : "");
  }
  std::array<char, 32> times{};
  std::snprintf(times.data(), times.size(), "%.3g", static_cast<double>(s.triangles) / least);
  return text + ": " + times.data() + " times the least possible, about " +
         number(std::ceil(least)) + "; half the tolerance takes twice as many";
}

/// The first place of each reason, and how many others it has.
std::string proof(const MeshReport& report, const Domain& d) {
  if (report.certified) return "nothing hides between the samples (proved)";
  std::string text;
  bool is_everywhere = false;
  for (std::size_t k = 0; k < report.doubts.size();) {
    const DoubtfulPlace& place = report.doubts[k];
    std::size_t next = k;
    for (; next < report.doubts.size() && report.doubts[next].why == place.why; ++next) {
      const DoubtfulPlace& other = report.doubts[next];
      is_everywhere =
          is_everywhere || (other.contains({d.u0, d.v0}) && other.contains({d.u1, d.v1}));
    }
    text += (k > 0 ? "; " : "") + words_for(place.why) + ": " +
            range("u", place.low.x, place.high.x) + ", " + range("v", place.low.y, place.high.y);
    if (next > k + 1) text += " and " + plural(next - k - 1, "other place");
    k = next;
  }
  if (is_everywhere) return "samples only: " + text;
  return "nothing hides between the samples (proved), but for places where " + text;
}

}  // namespace

std::string describe(const SurfaceReport& s, const Mesh& triangles) {
  const Facts& facts = *s.facts;
  std::string text = s.name + "\n";
  const auto line = [&text](const std::string& what, const std::string& said) {
    text += "  " + what + std::string(12 - what.size(), ' ') + said + "\n";
  };
  // Where v depends on u and its ends meet, many places of the surface have the same u and v.
  std::vector<dvec2> singular;
  std::vector<SingularPlace> distinct;
  for (const SingularPlace& place : facts.singular) {
    const auto is_same = [&](const dvec2& uv) {
      return glm::distance(uv, place.uv) <= kSameParameters * glm::length(place.uv);
    };
    if (std::ranges::any_of(singular, is_same)) continue;
    singular.push_back(place.uv);
    distinct.push_back(place);
  }
  line("domain", domain(facts));
  line("defined", defined(s, triangles));
  line("poles", cuts(s.mesh.poles, s.mesh.pole_count, facts.domain));
  line("jumps", cuts(s.mesh.jumps, s.mesh.jump_count, facts.domain));
  line("singular", places(singular, std::min(s.mesh.singular_point_count, singular.size()),
                          facts.domain, [&](const Group& group) {
                            return point_and_normal(distinct, group, s.bounds.diagonal());
                          }));
  line("seams", seams(s));
  line("sides", facts.topology.orientable ? "two" : "one: the surface is not orientable");
  line("shape", shape(facts.topology));
  line("extents", extents(facts.measures.extents));
  line("area", number(facts.measures.area));
  if (encloses_volume(facts)) line("volume", number(facts.measures.volume));
  line("curvature", curvatures(facts.measures));
  line("mesh", mesh(s));
  line("proof", proof(s.mesh, facts.domain));
  return text;
}

}  // namespace saddle
