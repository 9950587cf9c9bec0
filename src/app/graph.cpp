// saddle FORMULAS or NAME: check the outputs, prepare, tessellate once, write everything, report.
#include <algorithm>
#include <iostream>
#include <numeric>
#include <optional>
#include <thread>

#include "app/build_scene.h"
#include "app/commands.h"
#include "app/outputs.h"
#include "app/reference.h"
#include "app/report.h"
#include "app/standard_output.h"
#include "app/tolerance.h"
#include "app/warnings.h"
#include "base/file.h"
#include "base/image_png.h"
#include "mesh/clip.h"
#include "mesh/grid_mesh.h"
#include "mesh/tidy.h"
#include "render/renderer.h"
#include "scene/prepare.h"
#include "scene/scene_file.h"

namespace saddle {
namespace {

/// Without --samples a cell is about this large in the picture to begin with: for most surfaces of
/// the gallery that is within kPictureTolerance, and the grid is halved until it is.
constexpr int kPixelsPerCell = 8;
/// The error of a smooth surface falls to a quarter when cells are halved; where it does not fall
/// to this share, at a kink or the edge of a hole, finer cells do not help.
constexpr double kWorthHalving = 0.5;
/// A coarse grid may miss most of a wave, and so of its own error: one halving proves nothing.
constexpr int kHalvingsInVain = 2;
/// At most this many cells each way: two million triangles.
constexpr int kMaxDefaultCells = 1000;

/// Cells in one direction: a multiple of the intervals between grid lines, so that grid lines are
/// mesh lines, unless there are more of them than cells. An even one, so that the middle of the
/// range is a mesh line too: there symmetric surfaces have their apexes, cusps and kinks.
int default_cells(int larger_side, int lines) {
  const int wanted =
      std::min((larger_side + kPixelsPerCell - 1) / kPixelsPerCell, kMaxDefaultCells);
  const int intervals = std::lcm(std::max(lines - 1, 1), 2);
  const int rounded = (wanted + intervals - 1) / intervals * intervals;
  return rounded <= kMaxDefaultCells ? rounded : wanted;
}

GridOptions first_grid(const CommandLine& line, const SurfaceSpec& spec) {
  const int larger_side = std::max(line.width, line.height);
  GridOptions options;
  options.lines_u = spec.grid_u;
  options.lines_v = spec.grid_v;
  options.cells_u = line.samples ? line.samples->u : default_cells(larger_side, spec.grid_u);
  options.cells_v = line.samples ? line.samples->v : default_cells(larger_side, spec.grid_v);
  options.threads = line.threads;
  return options;
}

/// The grid that --samples asks for, or the coarsest of the defaults that keeps the tolerance.
GridMesh mesh_uniformly(const CommandLine& line, const Surface& surface, const SurfaceSpec& spec,
                        double tolerance) {
  GridOptions options = first_grid(line, spec);
  GridMesh result = mesh_on_grid(surface, options);
  int in_vain = 0;  // halvings in a row
  while (!line.samples && in_vain < kHalvingsInVain &&
         result.report.max_error > tolerance * result.mesh.bounds.diagonal() &&
         2 * std::max(options.cells_u, options.cells_v) <= kMaxDefaultCells) {
    options.cells_u *= 2;
    options.cells_v *= 2;
    GridMesh finer = mesh_on_grid(surface, options);
    finer.report.evaluations += result.report.evaluations;
    const bool helped = finer.report.max_error <= kWorthHalving * result.report.max_error;
    result = std::move(finer);
    in_vain = helped ? 0 : in_vain + 1;
  }
  return result;
}

/// The mesh that --samples asks for, or the one with the fewest triangles that keeps the tolerance.
GridMesh mesh_as_asked(const CommandLine& line, const Scene& scene, const SurfaceSpec& spec,
                       const Purpose& purpose, const Surface& surface) {
  if (!line.samples) {
    AdaptiveOptions options;
    options.clip = line.clip;
    Bounds box;
    options.tolerance = [&](const Probe& probe) {
      box = clip_box(probe);
      return tolerance_of(line, scene, purpose, probe, options.clip);
    };
    options.normal_tolerance = line.normal_tolerance;
    options.max_triangles = static_cast<std::size_t>(line.max_triangles);
    options.lines_u = spec.grid_u;
    options.lines_v = spec.grid_v;
    options.threads = line.threads;
    auto mesh = mesh_within_tolerance(surface, options);
    if (mesh && mesh->report.pole_count > 0 && line.clip_poles) {
      options.clip = box;  // which only a mesh tells that it needs
      if (auto clipped = mesh_within_tolerance(surface, options)) mesh = std::move(clipped);
      mesh->report.clip = box;
    }
    if (mesh) return std::move(*mesh);
  }
  const double share = tolerance_share(line, purpose);
  GridMesh mesh = mesh_uniformly(line, surface, spec, share);
  if (line.clip) {
    clip_mesh(*line.clip, mesh.mesh);
    keep_used_corners(mesh.mesh);
  }
  if (!line.samples) mesh.report.tolerance = share * mesh.mesh.bounds.diagonal();
  return mesh;
}

double since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Tessellates a surface and files what there is to say about it.
Mesh mesh_surface(const CommandLine& line, const Scene& scene, const SurfaceSpec& spec,
                  const Purpose& purpose, RunReport& report) {
  const PreparedSurface prepared =
      prepare_surface(scene, spec, line.samples ? Order::First : Order::Second);
  const auto begin = Clock::now();
  GridMesh result = mesh_as_asked(line, scene, spec, purpose, prepared.surface);
  report.times.parse += prepared.parse_ms;
  report.times.compile += prepared.compile_ms;
  report.times.tessellate += since(begin);
  for (std::string& warning : mesh_warnings(spec.name, result, prepared.surface.domain)) {
    report.warnings.push_back(std::move(warning));
  }
  report.surfaces.push_back({spec.name, result.mesh.triangles.size(), result.mesh.position.size(),
                             result.mesh.bounds, std::move(result.report)});
  return std::move(result.mesh);
}

Image draw(const CommandLine& line, const Scene& scene, std::span<const Mesh> meshes,
           RunReport& report) {
  Rendering rendering = render(scene, meshes, {line.width, line.height, line.antialias});
  report.times.render = rendering.times;
  report.image = ImageReport{rendering.image.width, rendering.image.height, rendering.renderer};
  return std::move(rendering.image);
}

void print_warnings(const RunReport& report) {
  for (const std::string& warning : report.warnings) {
    std::cerr << "saddle: warning: " << warning << '\n';
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
  if (purpose.picture) preloading = std::jthread(preload_renderer);
  RunReport report;
  std::vector<Mesh> meshes;
  for (const SurfaceSpec& spec : scene.surfaces) {
    meshes.push_back(mesh_surface(line, scene, spec, purpose, report));
  }
  if (!line.quiet) print_warnings(report);
  Image image;
  if (purpose.picture) image = draw(line, scene, meshes, report);

  const auto writing = Clock::now();
  const std::string scene_text = write_scene(scene);
  for (const Output& output : outputs) write_output(output, image, scene_text, meshes);
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
