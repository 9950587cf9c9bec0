// saddle check: what is true of a surface, in words and as a report; nothing is drawn.
#include "app/build_scene.h"
#include "app/commands.h"
#include "app/describe.h"
#include "app/report.h"
#include "app/run_report.h"
#include "app/standard_output.h"
#include "app/tessellate.h"
#include "scene/prepare.h"

namespace saddle {

void run_check(const CommandLine& line, Clock::time_point start) {
  const Scene scene = build_scene(line);
  RunReport report;
  std::string words;
  for (const SurfaceSpec& spec : scene.surfaces) {
    const Mesh mesh =
        file(tessellate(scene, spec, {.picture = false, .mesh = true}, line.threads), report);
    SurfaceReport& surface = report.surfaces.back();
    surface.facts = gather_facts(prepare_surface(scene, spec, Order::Second).surface, mesh,
                                 surface.mesh, scene.clip.box.has_value(), line.threads);
    words += describe(surface, mesh);
  }
  print_warnings(line, report);
  report.times.total = since(start);
  if (line.report != "-") print(words);
  send_report(line.report, report);
  if (line.strict) fail_on_warnings(report);
}

}  // namespace saddle
