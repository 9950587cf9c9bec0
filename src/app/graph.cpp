// saddle FORMULAS or NAME: check the outputs, prepare, tessellate once, write everything, report.
#include <algorithm>
#include <iostream>
#include <iterator>
#include <optional>
#include <thread>

#include "app/build_scene.h"
#include "app/commands.h"
#include "app/outputs.h"
#include "app/reference.h"
#include "app/run_report.h"
#include "base/image_png.h"
#include "render/picture.h"

namespace saddle {
namespace {

Image draw(const CommandLine& line, const Scene& scene, std::span<const Mesh> meshes,
           RunReport& report) {
  Rendering rendering = render(scene, meshes, scene.picture, line.renderer);
  report.times.render = rendering.times;
  report.image = ImageReport{rendering.image.width, rendering.image.height, rendering.renderer,
                             std::move(rendering.shaders)};
  print_warnings(line, rendering.warnings);
  std::ranges::move(rendering.warnings, std::back_inserter(report.warnings));
  return std::move(rendering.image);
}

/// With --strict a warning ends the run; the report has it, other outputs are not written.
void check_strictness(const CommandLine& line, RunReport& report, Clock::time_point start) {
  if (!line.strict || report.warnings.empty()) return;
  report.times.total = since(start);
  send_report(line.report, report);
  fail_on_warnings(report);
}

Purpose purpose_of(const CommandLine& line, const std::vector<Output>& outputs) {
  const auto is_picture = [](const Output& output) { return output.format == Format::Png; };
  const auto is_mesh = [](const Output& output) { return output.format == Format::Ply; };
  Purpose purpose;
  purpose.picture = !line.reference.empty() || std::ranges::any_of(outputs, is_picture);
  purpose.mesh = !purpose.picture || std::ranges::any_of(outputs, is_mesh);
  return purpose;
}

}  // namespace

void run_graph(const CommandLine& line, Clock::time_point start) {
  const Scene scene = build_scene(line);
  const std::vector<Output> outputs = checked_outputs(line);
  std::optional<Image> reference;
  if (!line.reference.empty()) reference = read_png(line.reference).image;

  const Purpose purpose = purpose_of(line, outputs);
  std::jthread preloading;  // OpenGL takes as long to load as a surface to tessellate
  if (purpose.picture) preloading = std::jthread(preload_renderer, line.renderer);
  RunReport report;
  std::vector<Mesh> meshes;
  for (const SurfaceSpec& spec : scene.surfaces) {
    meshes.push_back(file(tessellate(scene, spec, purpose, line.threads), report));
  }
  print_warnings(line, report.warnings);
  check_strictness(line, report, start);
  Image image;
  if (purpose.picture) image = draw(line, scene, meshes, report);
  check_strictness(line, report, start);

  const auto writing = Clock::now();
  for (const Output& output : outputs) write_output(output, image, scene, meshes);
  report.times.encode = since(writing);
  report.times.total = since(start);
  send_report(line.report, report);
  if (line.verbose) std::cerr << summary(report);
  if (!reference) return;
  const std::string passed =
      check_against_reference(image, *reference, line.reference, line.threshold);
  if (line.verbose) std::cerr << passed << '\n';
}

}  // namespace saddle
