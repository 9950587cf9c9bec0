// The order of work: context, upload, then tile by tile the surfaces, their lines on top of them,
// and the mean of the samples.
#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cmath>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "render/average.h"
#include "render/context.h"
#include "render/gpu_mesh.h"
#include "render/program.h"
#include "render/shaders.h"
#include "render/surface_shader.h"
#include "render/target.h"
#include "render/tiled_renderer.h"
#include "render/tiles.h"
#include "scene/camera.h"

namespace saddle {
namespace {

constexpr dvec3 kLineColor{0.2, 0.2, 0.2};

static_assert(kMaxAntialias <= kMostSamplesPerSide);

/// In model units, where the surface has size 1. From farther away a point light's direction is the
/// same everywhere to a float's precision, and the square of its distance must not overflow.
constexpr double kFarthestLight = 1e9;

dvec3 rgb(const Color& color) {
  return {color.r, color.g, color.b};
}

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

struct View {
  glm::dmat4 model_to_eye;  ///< eye coordinates in model units: a rotation and a translation
  glm::dmat4 model_to_clip;
};

/// Everything relative to the camera's target and in units of the model, all in double.
View make_view(const FittedCamera& camera, const ModelFrame& frame) {
  const dvec3 centre = glm::dmat3(camera.world_to_eye) * (frame.centre - camera.target) -
                       dvec3(0, 0, camera.distance);
  View view{glm::dmat4(glm::dmat3(camera.world_to_eye)), camera.eye_to_clip};
  view.model_to_eye[3] = {centre / frame.size, 1};
  for (int column = 0; column < 3; ++column) view.model_to_clip[column] *= frame.size;
  // A factor of clip coordinates means nothing; w in units of the model keeps to a float's range.
  if (view.model_to_clip[2][3] != 0) view.model_to_clip /= frame.size;
  view.model_to_clip = view.model_to_clip * view.model_to_eye;
  return view;
}

/// Positions in model units; directions as unit vectors.
dvec3 light_position(const Light& light, double unit) {
  const dvec3 position = light.position;
  const double length = std::hypot(position.x, position.y, position.z);
  if (light.directional) return length > 0 ? position / length : position;
  return length > kFarthestLight * unit ? position / length * kFarthestLight : position / unit;
}

void set_lights(Program& program, const std::vector<Light>& lights, double unit) {
  std::vector<dvec3> positions;
  std::vector<dvec3> colors;
  for (const Light& light : lights) {
    if (!shines(light)) continue;
    positions.push_back(light_position(light, unit));
    colors.push_back(rgb(light.color));
  }
  if (positions.empty()) return;
  program.set("light_position", positions);
  program.set("light_color", colors);
}

void set_materials(Program& program, const SurfaceSpec& surface) {
  program.set("front_diffuse", rgb(surface.front.diffuse));
  program.set("front_specular", rgb(surface.front.specular));
  program.set("front_shininess", surface.front.shininess);
  program.set("back_diffuse", rgb(surface.back.diffuse));
  program.set("back_specular", rgb(surface.back.specular));
  program.set("back_shininess", surface.back.shininess);
}

/// Meshes and programs on the GPU.
class Drawing {
 public:
  Drawing(const Scene& scene, std::span<const Mesh> meshes, const ModelFrame& frame)
      : scene_(scene), surface_program_(make_surface_program(scene)) {
    bool lines = false;
    for (const Mesh& mesh : meshes) {
      meshes_.emplace_back(mesh, frame);
      lines = lines || meshes_.back().has_lines();
    }
    if (lines) {
      line_program_.emplace(std::string(shader_source("line.vert.glsl")),
                            std::string(shader_source("line.frag.glsl")));
    }
    surface_program_.use();
    set_lights(surface_program_, scene.lights, frame.size);
  }

  /// No sample is see-through.
  bool opaque() const { return scene_.background.a >= 1; }

  /// `line_width` in samples.
  void draw(const glm::dmat4& model_to_clip, const glm::dmat4& model_to_eye, int line_width) {
    const Color& background = scene_.background;
    glClearColor(static_cast<float>(background.r), static_cast<float>(background.g),
                 static_cast<float>(background.b), static_cast<float>(background.a));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    draw_surfaces(model_to_clip, model_to_eye, line_width);
    if (line_program_) draw_lines(model_to_clip, line_width);
  }

 private:
  static Program make_surface_program(const Scene& scene) {
    return {std::string(shader_source("surface.vert.glsl")),
            assemble_shader(shader_source("surface.frag.glsl"), shader_needs(scene))};
  }

  /// Faces are pushed back by the depth they have across half a line's width, at which a sample of
  /// the line may lie from the line itself, and half a sample more.
  void draw_surfaces(const glm::dmat4& model_to_clip, const glm::dmat4& model_to_eye,
                     int line_width) {
    surface_program_.use();
    surface_program_.set("model_to_clip", model_to_clip);
    surface_program_.set("model_to_eye", model_to_eye);
    if (line_program_) {
      glEnable(GL_POLYGON_OFFSET_FILL);
      glPolygonOffset(0.5F * static_cast<float>(line_width + 1), 1);
    }
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      set_materials(surface_program_, scene_.surfaces[i]);
      surface_program_.check_all_set();
      meshes_[i].draw_triangles();
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
  }

  void draw_lines(const glm::dmat4& model_to_clip, int line_width) {
    line_program_->use();
    line_program_->set("model_to_clip", model_to_clip);
    line_program_->set("line_color", kLineColor);
    line_program_->check_all_set();
    glLineWidth(static_cast<float>(line_width));
    for (const GpuMesh& mesh : meshes_) {
      if (mesh.has_lines()) mesh.draw_lines();
    }
  }

  const Scene& scene_;
  Program surface_program_;
  std::optional<Program> line_program_;
  std::vector<GpuMesh> meshes_;
};

void check_gl() {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  if (error == GL_OUT_OF_MEMORY) throw std::bad_alloc();
  throw Error(Status::Machine, "OpenGL reports error " + std::to_string(error), {},
              "this is a defect of saddle or of the OpenGL driver; please report it");
}

void draw_tile(Drawing& drawing, const View& view, const Target& target, const PixelRect& rect,
               const RenderOptions& options, Image& image) {
  const int n = options.antialias;
  glViewport(0, 0, n * (rect.width + 2 * kTileMargin), n * (rect.height + 2 * kTileMargin));
  const glm::dmat4 to_rect = clip_to_rect(options.width, options.height, rect, kTileMargin);
  drawing.draw(to_rect * view.model_to_clip, view.model_to_eye, n);
  target.read(kTileMargin * n, kTileMargin * n, n, drawing.opaque(), rect, image);
  check_gl();
}

/// The distance of the farthest corner; much less than the box's for a torus, say.
double radius_around(const dvec3& target, std::span<const Mesh> meshes) {
  double radius = 0;
  for (const Mesh& mesh : meshes) {
    for (const dvec3& p : mesh.position) {
      radius = std::max(radius, std::hypot(p.x - target.x, p.y - target.y, p.z - target.z));
    }
  }
  return radius;
}

Rendering draw_picture(const Scene& scene, std::span<const Mesh> meshes,
                       const RenderOptions& options, int tile_samples) {
  Bounds bounds;
  for (const Mesh& mesh : meshes) bounds.add(mesh.bounds);
  if (bounds.empty()) bounds.add(dvec3(0));  // nothing but background
  const double aspect = static_cast<double>(options.width) / options.height;
  const double radius = radius_around(camera_target(scene.camera, bounds), meshes);
  const FittedCamera camera = fit_camera(scene.camera, bounds, aspect, radius);

  Stopwatch stopwatch;
  Rendering result;
  const int n = options.antialias;
  const Tiling tiling = split_picture(options.width, options.height, n, tile_samples);
  const auto context = make_osmesa_context();
  const Target target(n * (tiling.tile_width + 2 * kTileMargin),
                      n * (tiling.tile_height + 2 * kTileMargin));
  result.renderer = context->name();
  result.times.context = stopwatch.lap();

  const ModelFrame frame = model_frame(bounds);
  Drawing drawing(scene, meshes, frame);
  result.times.upload = stopwatch.lap();

  result.image = Image(options.width, options.height);
  const View view = make_view(camera, frame);
  for (const PixelRect& tile : tiling.tiles) {
    draw_tile(drawing, view, target, tile, options, result.image);
  }
  result.times.draw = stopwatch.lap();
  return result;
}

}  // namespace

Rendering render_in_tiles(const Scene& scene, std::span<const Mesh> meshes,
                          const RenderOptions& options, int tile_samples) {
  assert(meshes.size() == scene.surfaces.size());
  assert(options.width > 0 && options.height > 0);
  assert(options.antialias >= 1 && options.antialias <= kMaxAntialias);
  try {
    return draw_picture(scene, meshes, options, tile_samples);
  } catch (const std::bad_alloc&) {
    throw Error(Status::Machine,
                "not enough memory for a picture of " + std::to_string(options.width) + "x" +
                    std::to_string(options.height) + " pixels",
                {}, "try a smaller --size, --antialias 1 or coarser --samples");
  }
}

Rendering render(const Scene& scene, std::span<const Mesh> meshes, const RenderOptions& options) {
  return render_in_tiles(scene, meshes, options, kTileSamples);
}

void preload_renderer() noexcept {
  preload_osmesa();
}

}  // namespace saddle
