// saddle check: what is true of a surface, in words and as a report; nothing is drawn.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/commands.h"
#include "app/report/describe.h"
#include "app/report/progress.h"
#include "app/report/run_report.h"
#include "app/run/build_scene.h"
#include "base/activity.h"
#include "base/standard_streams.h"
#include "meshing/solids.h"
#include "meshing/tessellate.h"
#include "scene/model/strokes.h"
#include "study/check_surface.h"

namespace saddle {
namespace {

/// Adds what is true of the solids of surfaces with a thickness. The meshes stay sheets: what else
/// is told is about these.
void add_solids(const Scene& scene, std::vector<CheckedSurface>& surfaces,
                std::vector<Tessellation>& strokes, unsigned threads) {
  std::vector<Tessellation*> made;
  std::vector<Mesh> sheets;
  for (CheckedSurface& surface : surfaces) {
    made.push_back(&surface.tessellation);
    sheets.push_back(surface.tessellation.mesh);
  }
  for (Tessellation& stroke : strokes) made.push_back(&stroke);
  thicken_scene(scene, made, true, threads);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    surfaces[i].tessellation.mesh = std::move(sheets[i]);
  }
}

struct Checked {
  std::vector<CheckedSurface> surfaces;
  std::vector<Tessellation> strokes;
};

/// `drawn`: the scene with surfaces that stand for its curves and points.
Checked check_all(const Scene& scene, const Scene& drawn, const CommandLine& line) {
  const unsigned threads = line.run.threads;
  const Progress progress(!line.run.quiet);
  Activity surfaces(drawn.surfaces.size() > 1 ? "surface" : "", drawn.surfaces.size());
  Checked all;
  for (const SurfaceSpec& spec : drawn.surfaces) {
    if (spec.is_stroke()) {
      all.strokes.push_back(tessellate(drawn, spec, {.picture = true}, threads));
    } else {
      all.surfaces.push_back(check_surface(scene, spec, threads));
    }
    surfaces.advance();
  }
  add_solids(drawn, all.surfaces, all.strokes, threads);
  return all;
}

}  // namespace

void run_check(const CommandLine& line, Clock::time_point start) {
  const Scene scene = build_scene(line);
  RunReport report;
  report.warnings = warnings_of(scene);
  std::vector<std::string> words;
  const Scene drawn = with_strokes(scene);
  auto [all, strokes] = check_all(scene, drawn, line);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SurfaceSpec& spec = scene.surfaces[i];
    CheckedSurface& checked = all[i];
    add_times(checked.tessellation, report.times);
    std::ranges::move(checked.tessellation.warnings, std::back_inserter(report.warnings));
    SurfaceReport& surface =
        report.surfaces.emplace_back(report_of(spec.name, checked.tessellation));
    surface.facts = std::move(checked.facts);
    std::ranges::move(describe(surface, checked.tessellation.mesh), std::back_inserter(words));
  }
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const SurfaceSpec& spec = drawn.surfaces[all.size() + i];
    Tessellation& made = strokes[i];
    add_times(made, report.times);
    std::ranges::move(made.warnings, std::back_inserter(report.warnings));
    report.surfaces.push_back(report_of(spec.name, made));
    std::ranges::move(describe_stroke(report.surfaces.back()), std::back_inserter(words));
  }
  print_warnings(line, report.warnings);
  report.times.total = milliseconds_since(start);
  if (line.run.report != "-") print_lines(words);
  send_report(line.run.report, report);
  if (line.run.strict) fail_on_warnings(report);
}

}  // namespace saddle
