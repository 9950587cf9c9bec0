#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "base/format.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "render/gl/context.h"
#include "render/picture/picture_in_tiles.h"
#include "study/exact_image.h"
#include "study/methods.h"
#include "study/uniform_grids.h"

namespace saddle {
namespace {

const std::array<double, 7> kImageTolerances = {8, 4, 2, 1, 0.5, 0.25, 0.125};
constexpr double kUsual = 0.5;  // pixels
/// A mesh of 1024 x 1024 takes longer to draw than any that a picture needs.
const std::array<int, 6> kImageGrids = {16, 32, 64, 128, 256, 512};
const std::array<int, 4> kSamples = {1, 2, 3, 4};
/// A method whose picture takes longer is not asked for a better one.
constexpr double kImagePatience = 1500;  // milliseconds

/// The scene as the exact image has it.
Scene plain_scene(const Subject& subject) {
  Scene scene;
  scene.surfaces = {subject.spec};
  scene.surfaces[0].front = kFrontMaterial;
  scene.surfaces[0].back = kBackMaterial;
  scene.surfaces[0].shading.reset();
  scene.surfaces[0].specular.reset();
  scene.surfaces[0].samples.reset();
  scene.surfaces[0].in.clear();  // as it is, wherever the scene moves it
  scene.camera = subject.scene.camera;
  scene.definitions = subject.scene.definitions;  // for the formulas of exact normals
  scene.t = subject.scene.t;
  return scene;
}

class ImageStudy {
 public:
  ImageStudy(const Subject& subject, const StudyProgress& progress)
      : subject_(subject),
        grids_(uniform_grids(subject, kImageGrids)),
        progress_(progress, 3 * kImageTolerances.size() + grids_.size() + kSamples.size()),
        scene_(plain_scene(subject)),
        exact_(draw_exactly(subject)),
        context_(make_context(Backend::Any)) {}

  std::vector<Measurement> measure() {
    for (const auto& [shading, method] :
         {std::pair{Shading::Vertex, "per vertex"}, std::pair{Shading::Exact, "exact normal"},
          std::pair{Shading::Pixel, "per pixel"}}) {
      scene_.picture.shading = shading;
      compile_shaders();
      for (const double pixels : kImageTolerances) {
        const std::string setting = rounded(pixels, kSettingDigits) + " px";
        if (!add(method, setting, within(pixels), subject_.antialias)) break;
      }
    }
    const std::size_t first = result_.size();
    for (const GridSize& grid : grids_) {
      const auto mesh = [&] { return std::optional(uniform_mesh(subject_, grid)); };
      if (!add("uniform grid", setting_of(grid), mesh, subject_.antialias)) break;
    }
    mark_asked(subject_, std::span(result_).subspan(first));
    for (const int n : kSamples) {
      const std::string setting = std::to_string(n) + "x" + std::to_string(n);
      if (!add("supersampling", setting, within(kUsual), n)) break;
    }
    return std::move(result_);
  }

 private:
  using MakeMesh = std::function<std::optional<MeshResult>()>;

  /// From the tapes to the picture; what a run does once, context and shaders, is there.
  bool add(const char* method, const std::string& setting, const MakeMesh& make, int antialias) {
    progress_.next(method, setting);
    Image image;
    std::size_t triangles = 0;
    const auto draw = [&] {
      std::optional<MeshResult> mesh = make();
      if (!mesh) return;
      take_user_parameters(subject_.surface, mesh->mesh.uv);
      triangles = mesh->mesh.triangles.size();
      renderer_.set_surface(scene_, 0, mesh->mesh);
      image = draw_image(renderer_, scene_, subject_.camera,
                         {subject_.width, subject_.height, antialias});
    };
    const std::optional<Timing> time = time_unless_nothing(draw);
    if (!time) return true;
    if (triangles == 0) return false;
    result_.push_back({StudyPanel::Image,
                       method,
                       setting,
                       *time,
                       rms_error(image, exact_),
                       "rms",
                       {},
                       triangles});
    return time->median < kImagePatience;
  }

  void compile_shaders() {
    const std::optional<MeshResult> mesh = within(kImageTolerances.front())();
    if (!mesh) return;
    renderer_.set_surface(scene_, 0, mesh->mesh);
    draw_image(renderer_, scene_, subject_.camera, {64, 48, 1});
  }

  MakeMesh within(double pixels) const {
    MeshRequest options;
    const double length = pixels * subject_.pixel;
    options.tolerance = [length](const Probe&) { return Tolerance(length); };
    options.normal_tolerance = subject_.normal_tolerance;
    options.max_triangles = subject_.max_triangles;
    options.clip = subject_.clip;
    options.lines = {0, 0};
    options.threads = subject_.threads;
    return [this, options] { return try_mesh(subject_.surface, options); };
  }

  const Subject& subject_;
  std::vector<GridSize> grids_;
  PanelProgress progress_;
  Scene scene_;
  ExactImage exact_;
  std::unique_ptr<Context> context_;
  Renderer renderer_;  // after the context that it lives in
  std::vector<Measurement> result_;
};

}  // namespace

std::vector<Measurement> measure_images(const Subject& subject, const StudyProgress& progress) {
  return ImageStudy(subject, progress).measure();
}

}  // namespace saddle
