#include "app/report/run_report.h"

#include <utility>

#include "app/report/formula_warnings.h"
#include "base/error.h"
#include "base/file.h"
#include "base/standard_streams.h"
#include "scene/model/texture.h"
#include "scene/options/unused_definitions.h"

namespace saddle {

SurfaceReport report_of(const std::string& name, Tessellation& tessellation) {
  const Mesh& mesh = tessellation.mesh;
  SurfaceReport report;
  report.name = name;
  report.triangles = mesh.triangles.size();
  report.vertices = mesh.position.size();
  report.bounds = mesh.bounds;
  report.mesh = std::move(tessellation.report);
  report.findings = std::move(tessellation.findings);
  report.solid = tessellation.solid;
  report.curve = std::move(tessellation.curve);
  report.place = tessellation.place;
  return report;
}

void add_times(const Tessellation& tessellation, RunTimes& times) {
  times.parse += tessellation.parse_ms;
  times.compile += tessellation.compile_ms;
  times.tessellate += tessellation.tessellate_ms;
}

std::vector<std::string> warnings_of(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const std::string& name : unused_definitions(scene)) {
    warnings.push_back(name + " is defined, but nothing that is drawn depends on it");
  }
  for (std::string& warning : reversed_clamps(scene)) warnings.push_back(std::move(warning));
  for (const SurfaceSpec& spec : scene.surfaces) {
    if (!spec.texture.picture) continue;
    if (!is_opaque(spec.texture.picture->image)) {
      warnings.push_back(spec.name + ": the texture's transparent pixels are drawn as opaque ones");
    }
    if (spec.texture.picture->file.size() > kMostEmbeddedBytes) {
      warnings.push_back(spec.name +
                         ": the texture has more than 1 MiB: saved scenes and pictures "
                         "name its file, and look for it beside them");
    }
  }
  return warnings;
}

void print_warnings(const CommandLine& line, std::span<const std::string> warnings) {
  if (line.run.quiet) return;
  for (const std::string& warning : warnings) {
    tell("saddle: warning: " + warning);
  }
}

void send_report(const std::string& path, const RunReport& report) {
  const auto write = [&report](std::ostream& out) { write_report(out, report); };
  if (path == "-") {
    write_standard_output(write);
  } else if (!path.empty()) {
    write_file_whole(path, write);
  }
}

void fail_on_warnings(const RunReport& report) {
  const std::size_t count = report.warnings.size();
  if (count == 0) return;
  throw Error(Status::Input,
              "--strict: " + (count == 1 ? "a warning" : std::to_string(count) + " warnings"), {},
              "the first: " + report.warnings.front());
}

}  // namespace saddle
