// saddle check: what is true of a surface, in words and as a report; nothing is drawn.
#include "app/build_scene.h"
#include "app/commands.h"
#include "app/describe.h"
#include "app/run_report.h"
#include "app/standard_output.h"

namespace saddle {

void run_check(const CommandLine& line, Clock::time_point start) {
  const Scene scene = build_scene(line);
  RunReport report;
  std::string words;
  for (const SurfaceSpec& spec : scene.surfaces) {
    const Mesh mesh =
        file(tessellate(scene, spec, {.mesh = true, .facts = true}, line.threads), report);
    words += describe(report.surfaces.back(), mesh);
  }
  print_warnings(line, report.warnings);
  report.times.total = since(start);
  if (line.report != "-") print(words);
  send_report(line.report, report);
  if (line.strict) fail_on_warnings(report);
}

}  // namespace saddle
