// saddle check: what is true of a surface, in words and as a report; nothing is drawn.
#include <algorithm>
#include <iterator>
#include <optional>
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
#include "meshing/tessellate.h"
#include "scene/model/strokes.h"
#include "study/check_surface.h"

namespace saddle {

void run_check(const CommandLine& line, Clock::time_point start) {
  const Scene scene = build_scene(line);
  RunReport report;
  report.warnings = warnings_of(scene);
  std::vector<std::string> words;
  std::optional<Progress> progress(std::in_place, !line.run.quiet);
  Activity surfaces(scene.surfaces.size() > 1 ? "surface" : "", scene.surfaces.size());
  for (const SurfaceSpec& spec : scene.surfaces) {
    CheckedSurface checked = check_surface(scene, spec, line.run.threads);
    add_times(checked.tessellation, report.times);
    std::ranges::move(checked.tessellation.warnings, std::back_inserter(report.warnings));
    SurfaceReport& surface =
        report.surfaces.emplace_back(report_of(spec.name, checked.tessellation));
    surface.facts = std::move(checked.facts);
    std::ranges::move(describe(surface, checked.tessellation.mesh), std::back_inserter(words));
    surfaces.advance();
  }
  const Scene drawn = with_strokes(scene);
  for (const SurfaceSpec& spec : drawn.surfaces) {
    if (!spec.is_stroke()) continue;
    Tessellation made = tessellate(drawn, spec, {.picture = true}, line.run.threads);
    add_times(made, report.times);
    std::ranges::move(made.warnings, std::back_inserter(report.warnings));
    report.surfaces.push_back(report_of(spec.name, made));
    std::ranges::move(describe_stroke(report.surfaces.back()), std::back_inserter(words));
  }
  progress.reset();
  print_warnings(line, report.warnings);
  report.times.total = milliseconds_since(start);
  if (line.run.report != "-") print_lines(words);
  send_report(line.run.report, report);
  if (line.run.strict) fail_on_warnings(report);
}

}  // namespace saddle
