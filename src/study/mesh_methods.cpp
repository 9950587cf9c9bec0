#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/format.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "study/mesh_distance.h"
#include "study/methods.h"
#include "study/uniform_grids.h"

namespace saddle {
namespace {

const std::array<int, 7> kGrids = {8, 16, 32, 64, 128, 256, 512};
/// In pixels, from plainly visible to invisible.
const std::array<double, 9> kMeshTolerances = {8, 4, 2, 1, 0.5, 0.25, 0.125, 0.0625, 0.03125};
/// Fewer are no limit worth drawing.
constexpr double kSomeTriangles = 2;
/// A method whose mesh takes longer is not asked for a finer one.
constexpr double kMeshPatience = 1500;  // milliseconds

class MeshStudy {
 public:
  MeshStudy(const Subject& subject, const StudyProgress& progress)
      : subject_(subject),
        grids_(uniform_grids(subject, kGrids)),
        progress_(progress, grids_.size() + 3 * kMeshTolerances.size()),
        distance_(subject) {}

  std::vector<Measurement> measure() {
    for (const GridSize& grid : grids_) {
      const auto make = [&] { return std::optional(uniform_mesh(subject_, grid)); };
      if (!add("uniform", setting_of(grid), {}, make)) break;
    }
    mark_asked(subject_, result_);
    add_over_tolerances("adaptive", [&](const MeshRequest& options) {
      MeshRequest quick = options;
      quick.certify = false;
      return try_mesh(subject_.surface, quick);
    });
    add_over_tolerances("adaptive certified", [&](const MeshRequest& options) {
      return try_mesh(subject_.surface, options);
    });
    add_limit();
    return std::move(result_);
  }

 private:
  /// A method that promises a tolerance.
  template <class F>
  void add_over_tolerances(const char* method, F mesh) {
    for (const double pixels : kMeshTolerances) {
      const MeshRequest options = within(pixels);
      const auto make = [&] { return mesh(options); };
      if (!add(method, rounded(pixels, kSettingDigits) + " px", pixels, make)) return;
    }
  }

  /// False if the method has taken too long, or has no mesh.
  template <class F>
  bool add(const char* method, const std::string& setting, std::optional<double> promise, F make) {
    progress_.next(method, setting);
    std::optional<MeshResult> mesh;
    const std::optional<Timing> time = time_unless_nothing([&] { mesh = make(); });
    if (!time) return true;
    if (!mesh) return false;
    least_ = std::max(least_, promise ? mesh->report.least_triangles * *promise : 0);
    const double error = distance_(mesh->mesh) / subject_.pixel;
    result_.push_back({StudyPanel::Mesh, method, setting, *time, error, "px", promise,
                       mesh->mesh.triangles.size()});
    return time->median < kMeshPatience;
  }

  MeshRequest within(double pixels) const {
    MeshRequest options;
    const double length = pixels * subject_.pixel;
    options.tolerance = [length](const Probe&) { return Tolerance(length); };
    options.max_triangles = subject_.max_triangles;
    options.clip = subject_.clip;
    options.lines = {0, 0};
    options.threads = subject_.threads;
    return options;
  }

  /// Adds the time of a mesher that makes the least number of triangles, each at the least cost of
  /// those measured.
  void add_limit() {
    if (least_ / kMeshTolerances.back() < kSomeTriangles) return;  // developable, but for rounding
    double cheapest = HUGE_VAL;                                    // milliseconds for a triangle
    for (const Measurement& m : result_) {
      if (m.triangles == 0) continue;
      cheapest = std::min(cheapest, m.time.median / static_cast<double>(m.triangles));
    }
    for (const double pixels : kMeshTolerances) {
      const double triangles = least_ / pixels;
      const double time = cheapest * triangles;
      Measurement m{StudyPanel::Mesh,
                    "least triangles",
                    rounded(pixels, kSettingDigits) + " px",
                    {time, time, time},
                    pixels,
                    "px",
                    {}};
      m.triangles = static_cast<std::size_t>(std::ceil(triangles));
      m.is_limit = true;
      result_.push_back(m);
    }
  }

  const Subject& subject_;
  std::vector<GridSize> grids_;
  PanelProgress progress_;
  MeshDistance distance_;
  double least_ = 0;  ///< triangles at a tolerance of one pixel, at least
  std::vector<Measurement> result_;
};

}  // namespace

std::vector<Measurement> measure_meshes(const Subject& subject, const StudyProgress& progress) {
  return MeshStudy(subject, progress).measure();
}

}  // namespace saddle
