#include "render/picture/picture.h"

#include <array>
#include <cassert>
#include <chrono>
#include <new>

#include "base/error.h"
#include "render/gl/average.h"
#include "render/gl/context.h"
#include "render/gl/gpu_mesh.h"
#include "render/gl/target.h"
#include "render/picture/picture_in_tiles.h"
#include "render/picture/renderer.h"
#include "scene/model/camera.h"

namespace saddle {
namespace {

static_assert(kMaxAntialias <= kMostSamplesPerSide);

/// Milliseconds since the last lap.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> passed = now - start_;
    start_ = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

struct PictureMaker::Gpu {
  std::unique_ptr<Context> context;
  Renderer renderer;

  explicit Gpu(Backend backend) : context(make_context(backend)) {}
};

PictureMaker::PictureMaker(Backend backend) {
  Stopwatch stopwatch;
  gpu_ = std::make_unique<Gpu>(backend);
  times_.context = stopwatch.lap();
}

/// No thread may have entered it.
PictureMaker::~PictureMaker() {
  try {
    enter();
  } catch (const Error&) {
    // OpenGL's objects end with their context.
  }
}

void PictureMaker::leave() {
  gpu_->context->leave();
}

void PictureMaker::enter() {
  gpu_->context->enter();
}

/// A grid line is drawn, of a surface that is not seen: OpenGL compiles a program where it is first
/// used, and parts of itself with it.
void PictureMaker::warm_up() {
  Stopwatch stopwatch;
  constexpr std::array<std::array<dvec3, 2>, 1> kLine{{{dvec3(-1, 0, 0), dvec3(1, 0, 0)}}};
  constexpr int kSide = 16;
  Scene scene;
  scene.surfaces.resize(1);
  scene.surfaces[0].opacity = 0;
  const Mesh line = mesh_of_lines(kLine);
  gpu_->renderer.set_mesh(0, line);
  const FittedCamera camera = fit_camera(scene.camera, line.bounds, 1);
  const Target target(kSide, kSide);
  gpu_->renderer.draw(scene, camera, {kSide, kSide, {0, 0, kSide, kSide}});
  gpu_->renderer.keep_meshes(0);
  times_.context += stopwatch.lap();
}

std::string PictureMaker::renderer() const {
  return gpu_->context->name();
}

const std::vector<SurfaceProgram>& PictureMaker::surface_programs() const {
  return gpu_->renderer.surface_programs();
}

const std::map<std::size_t, bool>& PictureMaker::culled() const {
  return gpu_->renderer.culled();
}

std::vector<std::string> PictureMaker::warnings() const {
  return gpu_->renderer.warnings();
}

void PictureMaker::set_surface(const Scene& scene, std::size_t surface, const Mesh& mesh) {
  Stopwatch stopwatch;
  gpu_->renderer.set_surface(scene, surface, mesh);
  times_.upload += stopwatch.lap();
}

Image PictureMaker::draw(const Scene& scene, std::span<const Mesh> meshes,
                         const PictureSettings& options) {
  return draw_in_tiles(scene, meshes, options, kTileSamples);
}

Image PictureMaker::draw_in_tiles(const Scene& scene, std::span<const Mesh> meshes,
                                  const PictureSettings& options, int tile_samples) {
  assert(meshes.size() == scene.surfaces.size());
  assert(options.width > 0 && options.height > 0);
  assert(options.antialias >= 1 && options.antialias <= kMaxAntialias);
  Stopwatch stopwatch;
  const dvec2 size(options.width, options.height);
  try {
    Image image = draw_image(gpu_->renderer, scene, fit_to_meshes(scene, meshes, size), options,
                             tile_samples);
    times_.draw += stopwatch.lap();
    return image;
  } catch (const std::bad_alloc&) {
    throw Error(Status::Machine,
                "not enough memory for a picture of " + std::to_string(options.width) + "x" +
                    std::to_string(options.height) + " pixels",
                {}, "try a smaller --size, --antialias 1 or coarser --samples");
  }
}

Rendering render_in_tiles(const Scene& scene, std::span<const Mesh> meshes,
                          const PictureSettings& options, int tile_samples, Backend backend) {
  PictureMaker maker(backend);
  for (std::size_t i = 0; i < meshes.size(); ++i) maker.set_surface(scene, i, meshes[i]);
  Rendering result;
  result.image = maker.draw_in_tiles(scene, meshes, options, tile_samples);
  result.times = maker.times();
  result.renderer = maker.renderer();
  for (const SurfaceProgram& program : maker.surface_programs()) {
    result.shaders += program.text.vertex + program.text.fragment;
  }
  result.warnings = maker.warnings();
  return result;
}

Image render_surfaces(const Scene& scene, std::span<const Mesh> meshes, const FittedCamera& camera,
                      const PictureSettings& options, Backend backend) {
  const std::unique_ptr<Context> context = make_context(backend);
  Renderer renderer;
  for (std::size_t i = 0; i < meshes.size(); ++i) renderer.set_surface(scene, i, meshes[i]);
  return draw_image(renderer, scene, camera, options, kTileSamples, {.bare = true});
}

Rendering render(const Scene& scene, std::span<const Mesh> meshes, const PictureSettings& options,
                 Backend backend) {
  return render_in_tiles(scene, meshes, options, kTileSamples, backend);
}

std::unique_ptr<PictureMaker> start_picture_maker(Backend backend) {
  auto maker = std::make_unique<PictureMaker>(backend);
  maker->warm_up();
  maker->leave();
  return maker;
}

}  // namespace saddle
