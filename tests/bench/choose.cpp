// Meshes of the gallery's surfaces by each method: what was counted, what it took, and which one
// the program chooses. Lines of comma-separated values for tests/bench/costs.py.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/mesher/choose.h"
#include "mesh/mesher/grid_within.h"
#include "mesh/model/mesh_report.h"
#include "mesh/sizing/cost_model.h"
#include "mesh/sizing/grid_sizing.h"
#include "meshing/tolerance.h"
#include "render/gl/context.h"
#include "render/picture/picture_in_tiles.h"
#include "scene/model/gallery.h"
#include "scene/model/prepare.h"
#include "scene/options/resolve.h"

namespace {

using namespace saddle;

/// Tolerances beside the usual half pixel.
constexpr double kFactors[] = {4, 1, 0.25};
constexpr int kEnough = 3;
constexpr double kEnoughTime = 15;  // milliseconds
constexpr double kMostTime = 200;
/// A grid is tried with cells smaller by such factors until it keeps the tolerance.
constexpr double kStep = 1.2;
constexpr double kMostCells = 3e5;

/// Of the processor, in milliseconds: other work hardly matters.
double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// The least of several times.
double time_of(const std::function<void()>& work) {
  double least = 1e300;
  double sum = 0;
  for (int k = 0; sum < kMostTime && (k < kEnough || sum < kEnoughTime); ++k) {
    const double begin = now();
    work();
    const double passed = now() - begin;
    least = std::min(least, passed);
    sum += passed;
  }
  return least;
}

class Study {
 public:
  Study(std::string name, const Scene& scene, double factor)
      : name_(std::move(name)),
        scene_(scene),
        factor_(factor),
        surface_(prepare_surface(scene, scene.surfaces[0], Order::Second).surface),
        operations_(count_operations(surface_)) {
    options_.clip = scene.clip.box;
    options_.tolerance = [&](const Probe& probe) {
      const Purpose purpose{.picture = true};
      const Tolerance usual =
          tolerance_of(scene_, scene_.surfaces[0], purpose, probe, options_.clip);
      return usual.times(factor_);
    };
    options_.normal_tolerance = scene.mesh.normal_tolerance;
    options_.threads = 1;
  }

  void run(Renderer& renderer) {
    std::optional<MeshPlan> plan;
    const double planning = time_of([&] { plan = plan_mesh(surface_, options_); });
    if (!plan) return;
    print("halving", planning, renderer,
          [&] { return mesh_within_tolerance(surface_, options_, *plan); });
    if (!options_.clip && plan->tolerance.is_same_everywhere())
      try_grids(*plan, planning, renderer);
    print("chosen", 0, renderer, [&] { return mesh_at_least_cost(surface_, options_); });
  }

 private:
  void try_grids(const MeshPlan& plan, double planning, Renderer& renderer) {
    for (double scale = 1;; scale /= kStep) {
      const FixedLines lines =
          place_lines(plan.probe, plan.fixed, plan.sizing, 1 / std::sqrt(scale));
      if (static_cast<double>(lines.u.size() * lines.v.size()) > kMostCells) return;
      const GridTrial trial = try_grid(surface_, options_, plan, lines);
      if (trial.mesh) {
        print("grid", planning, renderer,
              [&] { return try_grid(surface_, options_, plan, lines).mesh; });
        return;
      }
      if (trial.excess == 0) return;
    }
  }

  void print(const char* method, double planning, Renderer& renderer,
             const std::function<std::optional<MeshResult>()>& make) {
    std::optional<MeshResult> mesh;
    const double passed = planning + time_of([&] { mesh = make(); });
    if (!mesh) return;
    const MeshReport& report = mesh->report;
    const MeshWork& work = report.work;
    const double drawing = time_to_draw(renderer, mesh->mesh);
    std::printf("%s,%g,%s,%d,%zu,%zu,%zu,%.6g,%.6g,%.6g,%zu,%.5g,%.5g,%.5g,%.4g\n", name_.c_str(),
                factor_, method, report.choice ? static_cast<int>(report.choice->why) : -1,
                work.grid_samples, work.leaf_samples, work.boxes, operations_.of_grid,
                operations_.of_point, operations_.of_box, mesh->mesh.triangles.size(), planning,
                passed, drawing, report.max_error / report.tolerance.value_or(1));
    std::fflush(stdout);
  }

  double time_to_draw(Renderer& renderer, const Mesh& mesh) const {
    const FittedCamera camera = fit_to_meshes(scene_, std::span(&mesh, 1),
                                              dvec2(scene_.picture.width, scene_.picture.height));
    renderer.set_mesh(0, mesh);
    draw_image(renderer, scene_, camera, scene_.picture);
    return time_of([&] {
      renderer.set_mesh(0, mesh);
      draw_image(renderer, scene_, camera, scene_.picture);
    });
  }

  std::string name_;
  const Scene& scene_;
  double factor_;
  Surface surface_;
  Operations operations_;
  MeshRequest options_;
};

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> asked(argv + 1, argv + argc);
  const auto context = make_context(Backend::Any);
  Renderer renderer;
  std::puts(
      "surface,factor,method,why,grid_samples,leaf_samples,boxes,of_grid,of_point,of_box,"
      "triangles,planning,mesh_ms,draw_ms,error");
  for (const GalleryEntry& entry : gallery()) {
    if (!asked.empty() && std::ranges::find(asked, entry.name) == asked.end()) continue;
    const Scene scene = resolve(gallery_scene(entry));
    for (const double factor : kFactors)
      Study(std::string(entry.name), scene, factor).run(renderer);
  }
  return 0;
}
