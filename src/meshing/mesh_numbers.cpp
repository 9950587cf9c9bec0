#include "meshing/mesh_numbers.h"

#include <cmath>
#include <cstddef>
#include <string>

#include "base/format.h"
#include "mesh/model/tolerances.h"
#include "meshing/place_groups.h"
#include "scene/model/ticks.h"

namespace saddle {
namespace {

/// Numbers that differ by less are equal: curvatures are compared with that of a sphere around the
/// surface.
double rounding_of(const std::string& expression, double diagonal) {
  if (expression == "mean") return kSame / diagonal;
  return expression == "gauss" ? kSame / (diagonal * diagonal) : 0;
}

/// The shortest length that matters in what the mesh is for.
double least_length(const Scene& scene, const Purpose& purpose, const MeshResult& mesh) {
  const double share = tolerance_share(scene, purpose) * mesh.mesh.bounds.diagonal();
  return mesh.report.tolerance.value_or(share);
}

std::optional<Bounds> clip_of(const Scene& scene, const MeshResult& mesh) {
  return scene.clip.box ? scene.clip.box : mesh.report.clip;
}

std::string list(const std::vector<double>& levels) {
  std::string text;
  for (const double level : levels) text += (text.empty() ? "" : ", ") + number(level);
  return text;
}

}  // namespace

ColorReport color_as_asked(const Scene& scene, const SurfaceSpec& spec, const Purpose& purpose,
                           const Surface& surface, MeshResult& mesh, unsigned threads) {
  const bool has_ends = spec.color_ends && !spec.color_ends->symmetric;
  ColorOptions options;
  options.least_edge = least_length(scene, purpose, mesh);
  options.rounding = rounding_of(spec.color, mesh.mesh.bounds.diagonal());
  options.range = spec.color_range;
  if (has_ends) options.range = ColorRange{spec.color_ends->low, spec.color_ends->high};
  options.clip = clip_of(scene, mesh);
  options.max_triangles = most_triangles(scene, spec);
  options.threads = threads;
  const ColorReport report = color_mesh(surface, options, mesh.mesh);
  // Moments between those that an animation's range is of may go farther: all bars are alike.
  if (spec.color_range && !has_ends) mesh.mesh.color_range = *spec.color_range;
  return report;
}

std::vector<double> levels_in(const ContourSpec& contour, const ColorRange& range) {
  std::vector<double> levels;
  for (const Number& level : contour.levels) levels.push_back(level);
  if (!levels.empty()) return levels;
  const double margin = kSame * (range.high - range.low);
  for (const Tick& tick : ticks(range.low, range.high, kRoundLevels).ticks) {
    const bool is_inside = tick.value > range.low + margin && tick.value < range.high - margin;
    if (is_inside || range.low == range.high) levels.push_back(tick.value);
  }
  return levels;
}

std::vector<ContourReport> contour_as_asked(const Scene& scene, const SurfaceSpec& spec,
                                            const Purpose& purpose, const PreparedSurface& prepared,
                                            MeshResult& mesh, unsigned threads) {
  std::vector<ContourReport> reports;
  for (std::size_t i = 0; i < spec.contours.size(); ++i) {
    const ContourSpec& contour = spec.contours[i];
    Surface surface = prepared.surface;
    surface.color = prepared.contours[i];
    ContourOptions options;
    options.tolerance = least_length(scene, purpose, mesh);
    options.mesh_error = mesh.report.max_error;
    options.rounding = rounding_of(contour.expression, mesh.mesh.bounds.diagonal());
    options.levels = [&](const ColorRange& drawn) {
      return levels_in(contour, contour.range.value_or(drawn));
    };
    options.clip = clip_of(scene, mesh);
    options.max_triangles = most_triangles(scene, spec);
    options.threads = threads;
    reports.push_back(add_contours(surface, options, mesh.mesh));
  }
  return reports;
}

std::vector<Finding> color_findings(const Mesh& mesh, const ColorReport& report) {
  std::vector<Finding> findings;
  if (report.undefined_share > 0) {
    findings.push_back({Finding::Kind::ColorUndefined,
                        "the colour is undefined on " + number(100 * report.undefined_share) +
                            " % of the surface, which is grey",
                        true});
    findings.back().share = report.undefined_share;
  }
  if (report.is_clamped) {
    findings.push_back({Finding::Kind::ColorInfinite,
                        "the colour goes to infinity; its range is cut to " +
                            number(mesh.color_range.low) + ":" + number(mesh.color_range.high),
                        true});
  }
  if (report.reached_limit) {
    findings.push_back({Finding::Kind::ColorCoarse,
                        "the limit of triangles stopped refinement for the colour, which is "
                        "blurred; --max-triangles allows more",
                        true});
  }
  return findings;
}

std::vector<Finding> contour_findings(const SurfaceSpec& spec,
                                      std::span<const ContourReport> reports) {
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const std::string lines = "the contours of " + spec.contours[i].expression;
    const ContourReport& report = reports[i];
    if (!report.on_areas.empty()) {
      findings.push_back(
          {Finding::Kind::ContoursOnArea,
           lines + ": it is " + list(report.on_areas) + " on a whole area, which has no line",
           true});
    } else if (report.lines == 0 && !spec.contours[i].range) {  // other moments may have lines
      const auto end = [&](double number_at_end) {              // without the rounding of a zero
        const bool is_zero =
            std::abs(number_at_end) < kSame * (report.range->high - report.range->low);
        return number(is_zero ? 0 : number_at_end);
      };
      const std::string range =
          !report.range ? "it is nowhere a finite number"
          : report.range->low == report.range->high
              ? "it is " + number(report.range->low) + " everywhere"
              : "it runs from " + end(report.range->low) + " to " + end(report.range->high);
      const std::string none =
          report.levels.empty() ? "no level" : "none at " + list(report.levels);
      findings.push_back({Finding::Kind::ContoursNone, lines + ": " + none + "; " + range, true});
    }
    if (report.reached_limit) {
      findings.push_back({Finding::Kind::ContoursCoarse,
                          lines + " may lack parts: the limit of triangles stopped the search; "
                                  "--max-triangles allows more",
                          true});
    }
  }
  return findings;
}

}  // namespace saddle
