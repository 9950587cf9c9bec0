// saddle chart: speed against accuracy for a scene's surfaces, as a chart or a table.
#include <algorithm>
#include <cctype>
#include <filesystem>

#include "app/commands/commands.h"
#include "app/report/progress.h"
#include "app/run/build_scene.h"
#include "base/activity.h"
#include "base/error.h"
#include "base/file.h"
#include "base/standard_streams.h"
#include "mesh/model/mesh_report.h"
#include "meshing/tessellate.h"
#include "render/picture/picture_in_tiles.h"
#include "study/chart.h"
#include "study/study.h"

namespace saddle {
namespace {

/// Meshes of a study have no more: it has many to make.
constexpr std::size_t kMostChartTriangles = 400'000;

enum class ChartFile { Csv, Svg, Png };

struct ChartOutput {
  std::string path;  ///< "-": standard output
  ChartFile kind = ChartFile::Csv;
};

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

ChartOutput checked_output(const std::string& path, const std::string& format) {
  constexpr const char* kKnown = "known: .svg .png .csv";
  std::string ending = std::filesystem::path(path).extension().string();
  ending = path == "-" || ending.empty() ? format : ending.substr(1);
  const std::string name = lower_case(ending);
  if (name == "csv") return {path, ChartFile::Csv};
  if (name == "svg") return {path, ChartFile::Svg};
  if (name == "png") return {path, ChartFile::Png};
  if (ending.empty()) {
    throw Error(Status::Input, "nothing says which kind of chart " + path + " is",
                {"--output", path, {0, path.size()}},
                std::string(kKnown) + "; for - add --format csv");
  }
  throw Error(Status::Input, "a chart is no '." + ending + "'",
              {"--output", path, {path.size() - std::min(path.size(), ending.size()), path.size()}},
              kKnown);
}

std::vector<ChartOutput> checked_chart_outputs(const CommandLine& line) {
  if (line.run.outputs.empty()) {
    throw Error(Status::Input, "nothing says where the chart goes", {},
                "name an output: -o chart.svg, .png or .csv");
  }
  if (std::ranges::count(line.run.outputs, "-") > 1) {
    throw Error(Status::Input, "only one thing can go to standard output", {},
                "give the others a file");
  }
  std::vector<ChartOutput> outputs;
  for (const std::string& path : line.run.outputs) {
    outputs.push_back(checked_output(path, line.run.format));
    if (path != "-") check_writable(path);
    if (path == "-" && outputs.back().kind == ChartFile::Png && standard_output_is_terminal()) {
      throw Error(Status::Input, "pictures are not written to a terminal",
                  {"--output", "-", {0, 1}}, "redirect standard output, or name a file");
    }
  }
  return outputs;
}

/// Curves and points have no meshes to compare.
std::vector<SurfaceSpec> surfaces_of(const Scene& scene) {
  std::vector<SurfaceSpec> surfaces = scene.surfaces;
  std::erase_if(surfaces, [](const SurfaceSpec& spec) { return spec.is_stroke(); });
  if (!surfaces.empty()) return surfaces;
  throw Error(Status::Input, "a chart is of surfaces, and the scene has none", {},
              "for example saddle chart torus -o chart.svg");
}

/// Adds the picture's length of a pixel, camera and clip box to the subject of a study: those of
/// the mesh that a picture would be drawn from.
void add_picture(const CommandLine& line, Subject& subject) {
  const Scene& scene = subject.scene;
  Scene one_pixel = scene;
  one_pixel.mesh.tolerance = ToleranceValue{1, true};
  one_pixel.mesh.samples.reset();
  SurfaceSpec spec = subject.spec;
  spec.samples.reset();
  const Tessellation mesh = tessellate(one_pixel, spec, {true, false}, line.run.threads);
  const MeshReport& report = mesh.report;
  subject.threads = line.run.threads;
  subject.width = scene.picture.width;
  subject.height = scene.picture.height;
  subject.antialias = scene.picture.antialias;
  subject.max_triangles = std::min<std::size_t>(
      scene.mesh.max_triangles.value_or(kMostChartTriangles), kMostChartTriangles);
  subject.normal_tolerance = scene.mesh.normal_tolerance;
  subject.samples = samples_of(scene, subject.spec);
  subject.pixel = report.tolerance.value_or(mesh.mesh.bounds.diagonal() / subject.width);
  subject.clip = report.clip ? report.clip : scene.clip.box;
  one_pixel.surfaces = {spec};
  one_pixel.surfaces[0].in.clear();  // as it is, wherever the scene moves it
  subject.camera =
      fit_to_meshes(one_pixel, std::span(&mesh.mesh, 1), dvec2(subject.width, subject.height));
}

/// Each surface is measured by itself, in a picture of its own.
std::vector<Measurement> measurements_of(const Scene& scene, const CommandLine& line) {
  const Progress progress(!line.run.quiet);
  Activity measuring("measuring");
  const std::vector<SurfaceSpec> surfaces = surfaces_of(scene);
  std::vector<std::vector<Measurement>> all;
  for (const SurfaceSpec& spec : surfaces) {
    Subject subject(scene, spec);
    add_picture(line, subject);
    const auto done = static_cast<double>(all.size());
    const auto count = static_cast<double>(surfaces.size());
    const std::string name = surfaces.size() > 1 ? spec.name + ": " : "";
    const Activity method("");  // its meshes and pictures tell their own shares
    all.push_back(study(subject, [&](double share, const std::string& what) {
      measuring.set_share((done + share) / count);
      measuring.set_detail(name + what);
    }));
  }
  return together(all);
}

void write(const ChartOutput& output, std::span<const Measurement> measurements,
           const std::string& title) {
  const std::string picture =
      output.kind == ChartFile::Csv
          ? std::string()
          : draw_chart(measurements, title,
                       output.kind == ChartFile::Svg ? ChartFormat::Svg : ChartFormat::Png);
  const auto to = [&](std::ostream& out) {
    if (output.kind == ChartFile::Csv) {
      write_csv(out, measurements);
    } else {
      out.write(picture.data(), static_cast<std::streamsize>(picture.size()));
    }
  };
  if (output.path == "-") {
    write_standard_output(to);
  } else {
    write_file_whole(output.path, to);
  }
}

/// The surface's name, or its formulas.
std::string title_of(const Scene& scene, const CommandLine& line) {
  std::string title;
  for (const std::string& argument : line.arguments())
    title += (title.empty() ? "" : "  ") + argument;
  constexpr std::size_t kLongest = 110;
  if (title.size() > kLongest) title = title.substr(0, kLongest) + " ...";
  return title.empty() ? scene.title : title;
}

}  // namespace

void run_chart(const CommandLine& line) {
  const std::vector<ChartOutput> outputs = checked_chart_outputs(line);
  const bool draws = std::ranges::any_of(
      outputs, [](const ChartOutput& output) { return output.kind != ChartFile::Csv; });
  if (draws) check_gnuplot();
  Scene scene = build_scene(line);
  scene.axes = false;  // the exact image is of the surface alone, as it is
  scene.scale = {.automatic = false};
  for (SurfaceSpec& spec : scene.surfaces) spec.color.clear();
  const std::vector<Measurement> measurements = measurements_of(scene, line);
  for (const ChartOutput& output : outputs) write(output, measurements, title_of(scene, line));
}

}  // namespace saddle
