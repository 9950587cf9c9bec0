// The report, written with nlohmann's JSON, keys in a fixed order.
#include "app/report/report.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/command_line/help.h"
#include "app/report/words.h"
#include "base/format.h"

namespace saddle {
namespace {

using Json = nlohmann::ordered_json;

Json finite_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json vector(const dvec3& v) {
  return {finite_or_null(v.x), finite_or_null(v.y), finite_or_null(v.z)};
}

Json closing(const std::string& how) {
  return how.empty() ? Json(nullptr) : Json(how);
}

Json places(const std::vector<dvec2>& uvs) {
  Json list = Json::array();
  for (const dvec2& uv : uvs)
    list.push_back({{"u", finite_or_null(uv.x)}, {"v", finite_or_null(uv.y)}});
  return list;
}

/// Triangles over the least possible.
Json efficiency(const SurfaceReport& s) {
  if (!(s.mesh.least_triangles >= 1)) return nullptr;  // developable, but for rounding
  return finite_or_null(static_cast<double>(s.triangles) / s.mesh.least_triangles);
}

Json ends(double low, double high) {
  return {finite_or_null(low), finite_or_null(high)};
}

Json doubts(const std::vector<ProofGap>& places) {
  Json list = Json::array();
  for (const ProofGap& place : places) {
    list.push_back({{"reason", name_of(place.why)},
                    {"u", ends(place.low.x, place.high.x)},
                    {"v", ends(place.low.y, place.high.y)}});
  }
  return list;
}

Json extremes(const Extremes& e) {
  return e.empty() ? Json(nullptr) : ends(e.low, e.high);
}

Json place_or_null(const std::optional<dvec2>& uv) {
  return uv ? Json{{"u", finite_or_null(uv->x)}, {"v", finite_or_null(uv->y)}} : Json(nullptr);
}

/// Adds the extremes of a curvature, bounds of all its values, and the places without bounds.
void add_curvature(const std::string& name, const ValueRange& range, Json& json) {
  json[name] = extremes(range);
  json[name + "_bounds"] = extremes(range.bounds);
  json[name + "_unbounded"] =
      Json::array({place_or_null(range.falls_toward), place_or_null(range.grows_toward)});
}

/// Adds a number and how far off it may be.
void add_estimate(const std::string& name, const Estimate& estimate, Json& json) {
  json[name] = finite_or_null(estimate.value);
  json[name + "_error"] = finite_or_null(estimate.error);
}

/// `normal` is the one limit of the normal, `normals` are the limits from all sides; `isolated`: on
/// no curve of such points.
Json singular_places(const std::vector<SingularPlace>& places) {
  Json list = Json::array();
  for (const SingularPlace& place : places) {
    Json normals = Json::array();
    for (const dvec3& normal : place.normals) normals.push_back(vector(normal));
    list.push_back({{"u", finite_or_null(place.uv.x)},
                    {"v", finite_or_null(place.uv.y)},
                    {"isolated", place.is_alone},
                    {"position", vector(place.position)},
                    {"normal", normals.size() == 1 ? normals[0] : Json(nullptr)},
                    {"normals", normals}});
  }
  return list;
}

/// The points of space at which the surface is singular, each once.
Json singular_points(const std::vector<SingularInSpace>& points) {
  Json list = Json::array();
  for (const SingularInSpace& point : points) {
    list.push_back({{"u", finite_or_null(point.uv.x)},
                    {"v", finite_or_null(point.uv.y)},
                    {"position", vector(point.position)},
                    {"isolated", point.is_isolated}});
  }
  return list;
}

/// Adds the normals of its places to each singular point.
void add_normals(const SurfaceReport& s, Json& points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::vector<dvec3> normals;
    for (const std::size_t place : s.mesh.singular_in_space[k].places) {
      for (const dvec3& normal : s.facts->singular[place].normals) {
        const auto is_same = [&normal](const dvec3& other) {
          return degrees_between(normal, other) <= words::kSameDegrees;
        };
        if (std::ranges::none_of(normals, is_same)) normals.push_back(normal);
      }
    }
    points[k]["normal"] = normals.size() == 1 ? vector(normals[0]) : Json(nullptr);
    Json& list = points[k]["normals"] = Json::array();
    for (const dvec3& normal : normals) list.push_back(vector(normal));
  }
}

/// The edges of the domain that are folded, each by its u or v.
Json folded_edges(const SurfaceReport& s) {
  const Domain& d = s.facts->domain;
  Json list = Json::array();
  for (std::size_t k = 0; k < 2; ++k) {
    if (s.mesh.folded_u[k]) list.push_back({{"u", finite_or_null(k == 0 ? d.u0 : d.u1)}});
    if (s.mesh.folded_v[k]) list.push_back({{"v", finite_or_null(k == 0 ? d.v0 : d.v1)}});
  }
  return list;
}

/// Adds the results of `saddle check` to a surface's report.
void add_facts(const SurfaceReport& s, Json& json) {
  const Facts& facts = *s.facts;
  const Topology& t = facts.topology;
  json["singular_places"] = singular_places(facts.singular);
  add_normals(s, json["singular_points"]);
  json["domain"] = {{"u", ends(facts.domain.u0, facts.domain.u1)},
                    {"v", ends(facts.domain.v0, facts.domain.v1)}};
  json["undefined_fraction"] =
      finite_or_null(s.mesh.region ? s.mesh.region->undefined
                                   : std::max(s.mesh.undefined_fraction, facts.defined.no));
  json["undefined_at"] = place_or_null(facts.defined.undefined_at);
  json["proved_defined_fraction"] = finite_or_null(facts.defined.yes);
  json["proved_undefined_fraction"] = finite_or_null(facts.defined.no);
  json["exceeds_doubles"] = s.mesh.exceeds_doubles;
  json["folded"] = folded_edges(s);
  json["euler_number"] = t.euler_number;
  json["components"] = t.components;
  json["closed"] =
      facts.closed == Closed::Unknown ? Json(nullptr) : Json(facts.closed == Closed::Yes);
  json["open_edges"] = t.open_edges;
  json["boundary_loops"] = t.boundary_loops;
  json["extents"] =
      Json::array({vector(facts.measures.extents.low), vector(facts.measures.extents.high)});
  json["extents_bounds"] = Json::array(
      {vector(facts.measures.extents_bounds.low), vector(facts.measures.extents_bounds.high)});
  add_estimate("area", facts.measures.area, json);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  add_estimate("volume", encloses_volume(facts) ? facts.measures.volume : Estimate{kNone, kNone},
               json);
  add_curvature("gauss_curvature", facts.measures.gauss, json);
  add_curvature("mean_curvature", facts.measures.mean, json);
  json["least_triangles"] = finite_or_null(s.mesh.least_triangles);
}

Json solid(const SolidReport& s) {
  return {{"closed", s.facts.closed},
          {"shells", s.facts.shells},
          {"volume", finite_or_null(s.facts.volume)},
          {"self_intersections", s.facts.crossings.pairs},
          {"thickness", finite_or_null(s.thickness)},
          {"largest_thickness", finite_or_null(s.largest_thickness)},
          {"at", place_or_null(s.at)}};
}

Json surface(const SurfaceReport& s) {
  std::vector<dvec2> singular;
  for (const SingularPoint& point : s.mesh.singular_points) singular.push_back(point.uv);
  Json json = {{"name", s.name},
               {"cells", s.mesh.cells},
               {"triangles", s.triangles},
               {"vertices", s.vertices},
               {"evaluations", s.mesh.evaluations},
               {"bounds", Json::array({vector(s.bounds.low), vector(s.bounds.high)})},
               {"tolerance", s.mesh.tolerance ? finite_or_null(*s.mesh.tolerance) : Json(nullptr)},
               {"max_error", finite_or_null(s.mesh.max_error)},
               {"max_error_is", s.mesh.error_is_bound ? "bound" : "search"},
               {"max_normal_error", finite_or_null(s.mesh.max_normal_error)},
               {"undefined_fraction", finite_or_null(s.mesh.unexpected_fraction())},
               {"outside_fraction", finite_or_null(s.mesh.region ? s.mesh.region->outside : 0)},
               {"efficiency", efficiency(s)},
               {"singular_points", singular_points(s.mesh.singular_in_space)},
               {"singular_points_count", s.mesh.singular_in_space.size()},
               {"singular_places", places(singular)},
               {"singular_places_count", s.mesh.singular_point_count},
               {"poles", places(s.mesh.poles)},
               {"poles_count", s.mesh.pole_count},
               {"jumps", places(s.mesh.jumps)},
               {"jumps_count", s.mesh.jump_count},
               {"closed_u", closing(s.mesh.closed_u)},
               {"closed_v", closing(s.mesh.closed_v)},
               {"orientable", s.mesh.orientable},
               {"certified", s.mesh.certified},
               {"proved_fraction", finite_or_null(s.mesh.proved_fraction)},
               {"uncertified", doubts(s.mesh.proof_gaps)}};
  if (s.solid) json["solid"] = solid(*s.solid);
  if (s.culls_backs) json["culls_backs"] = *s.culls_backs;
  if (s.facts) add_facts(s, json);
  return json;
}

/// A curve, its tube or line.
Json curve(const SurfaceReport& s) {
  const CurveMesh& c = *s.curve;
  return {{"name", s.name},
          {"triangles", s.triangles},
          {"vertices", s.vertices},
          {"evaluations", c.evaluations},
          {"bounds", Json::array({vector(s.bounds.low), vector(s.bounds.high)})},
          {"length", finite_or_null(c.length)},
          {"closed", c.closed},
          {"tolerance", finite_or_null(c.tolerance)},
          {"max_error", finite_or_null(c.max_error)},
          {"proved_fraction", finite_or_null(c.proved_fraction)},
          {"undefined_fraction", finite_or_null(c.undefined_fraction)},
          {"poles", c.poles},
          {"jumps", c.jumps}};
}

/// A point, its ball or dot.
Json point(const SurfaceReport& s) {
  return {{"name", s.name}, {"position", vector(*s.place)}, {"triangles", s.triangles}};
}

/// `surface`: empty for one about the scene.
Json finding(const std::string& surface, const Finding& f) {
  Json json = {{"kind", name_of(f.kind)}, {"surface", surface.empty() ? Json() : Json(surface)}};
  if (f.value) {
    json["value"] = finite_or_null(*f.value);
    json["unit"] = f.unit;
  }
  if (f.place) {
    json["u"] = ends(f.place->low.x, f.place->high.x);
    json["v"] = ends(f.place->low.y, f.place->high.y);
  }
  if (f.share) json["share"] = finite_or_null(*f.share);
  json["text"] = f.text;
  return json;
}

Json times(const RunTimes& t) {
  Json result = {{"parse", finite_or_null(t.parse)},
                 {"compile", finite_or_null(t.compile)},
                 {"tessellate", finite_or_null(t.tessellate)}};
  if (t.render) {
    result["context"] = finite_or_null(t.render->context);
    result["upload"] = finite_or_null(t.render->upload);
    result["draw"] = finite_or_null(t.render->draw);
  }
  result["encode"] = finite_or_null(t.encode);
  if (t.frame > 0) result["frame"] = finite_or_null(t.frame);
  result["total"] = finite_or_null(t.total);
  return result;
}

/// The most memory that this process has had in use. The kernel resets VmHWM when a program starts;
/// ru_maxrss includes the process that started it.
std::int64_t own_peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::int64_t size = 0;
    if (word == "VmHWM:" && status >> size) return size;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

/// The most memory of any process of the run: this one, or ffmpeg once it has ended.
std::int64_t peak_memory_bytes() {
  constexpr std::int64_t kKibibyte = 1024;  // the unit of these numbers on Linux
  rusage others{};
  getrusage(RUSAGE_CHILDREN, &others);
  return std::max(own_peak_memory(), std::int64_t{others.ru_maxrss}) * kKibibyte;
}

}  // namespace

bool encloses_volume(const Facts& facts) {
  return facts.closed != Closed::No && facts.topology.orientable;
}

void write_report(std::ostream& out, const RunReport& report) {
  Json json = {{"version", version()}, {"surfaces", Json::array()}};
  for (const SurfaceReport& s : report.surfaces) {
    Json& list = json[s.curve ? "curves" : s.place ? "points" : "surfaces"];
    list.push_back(s.curve ? curve(s) : s.place ? point(s) : surface(s));
    if (report.frames > 0) list.back()["meshes"] = s.meshes;
  }
  if (report.image) {
    json["image"] = {{"width", report.image->width},
                     {"height", report.image->height},
                     {"renderer", report.image->renderer},
                     {"meshes", report.image->meshes},
                     {"instances", report.image->instances}};
  }
  if (report.frames > 0) json["frames"] = report.frames;
  json["times"] = times(report.times);
  json["peak_memory_bytes"] = peak_memory_bytes();
  json["warnings"] = report.warnings;
  json["findings"] = Json::array();
  for (const SurfaceReport& s : report.surfaces) {
    for (const Finding& f : s.findings) json["findings"].push_back(finding(s.name, f));
  }
  for (const SceneFinding& f : report.findings) {
    json["findings"].push_back(finding(f.surface, f.finding));
  }
  // Bytes that are not UTF-8 become replacement characters.
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

std::vector<std::string> summary(const RunReport& report) {
  std::vector<std::string> lines;
  for (const SurfaceReport& s : report.surfaces) {
    lines.push_back(s.name + ": " + std::to_string(s.mesh.cells) + " cells, " +
                    std::to_string(s.triangles) + " triangles, " + std::to_string(s.vertices) +
                    " vertices, " + std::to_string(s.mesh.evaluations) + " evaluations" +
                    (!s.culls_backs   ? ""
                     : *s.culls_backs ? ", back faces are culled"
                                      : ", back faces are drawn"));
  }
  if (report.image) {
    lines.push_back("image: " + std::to_string(report.image->width) + "x" +
                    std::to_string(report.image->height) + " by " + report.image->renderer + ", " +
                    std::to_string(report.image->meshes) + " meshes in " +
                    std::to_string(report.image->instances) + " places");
  }
  if (report.frames > 0) lines.push_back("frames: " + std::to_string(report.frames));
  std::string& milliseconds = lines.emplace_back("milliseconds:");
  const Json all = times(report.times);
  for (const auto& [name, value] : all.items()) {
    milliseconds += formatted(" %s %.1f", name.c_str(), value.get<double>());
  }
  return lines;
}

}  // namespace saddle
