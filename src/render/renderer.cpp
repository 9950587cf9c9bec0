// The order of work: the surfaces, then their lines on top of them.
#include "render/renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <new>
#include <utility>

#include "base/error.h"
#include "render/shaders.h"
#include "render/surface_shader.h"

namespace saddle {
namespace {

constexpr dvec3 kLineColor{0.2, 0.2, 0.2};
constexpr dvec3 kMarkColor{0.3, 0.9, 0.5};

/// In units of the scene. From farther away a point light's direction is the
/// same everywhere to a float's precision, and the square of its distance must not overflow.
constexpr double kFarthestLight = 1e9;

dvec3 rgb(const Color& color) {
  return {color.r, color.g, color.b};
}

/// Positions in units of the scene; directions as unit vectors.
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

void clear(const Color& background) {
  glClearColor(static_cast<float>(background.r), static_cast<float>(background.g),
               static_cast<float>(background.b), static_cast<float>(background.a));
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void check_gl() {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  if (error == GL_OUT_OF_MEMORY) throw std::bad_alloc();
  throw Error(Status::Machine, "OpenGL reports error " + std::to_string(error), {},
              "this is a defect of saddle or of the OpenGL driver; please report it");
}

}  // namespace

/// From a mesh's own coordinates to eye coordinates in units of the scene.
struct Renderer::View {
  glm::dmat4 model_to_eye;  // a rotation, a translation and a factor
  glm::dmat4 model_to_clip;

  /// Everything relative to the camera's target, all in double.
  View(const FittedCamera& camera, const ModelFrame& frame, double unit)
      : model_to_eye(glm::dmat3(camera.world_to_eye) * (frame.size / unit)),
        model_to_clip(camera.eye_to_clip) {
    const dvec3 centre = glm::dmat3(camera.world_to_eye) * (frame.centre - camera.target) -
                         dvec3(0, 0, camera.distance);
    model_to_eye[3] = {centre / unit, 1};
    for (int column = 0; column < 3; ++column) model_to_clip[column] *= unit;
    // A factor of clip coordinates means nothing; w in units of the scene keeps to a float's range.
    if (model_to_clip[2][3] != 0) model_to_clip /= unit;
    model_to_clip = model_to_clip * model_to_eye;
  }
};

void Renderer::set_mesh(std::size_t surface, const Mesh& mesh) {
  assert(surface <= meshes_.size());
  GpuMesh uploaded(mesh);
  if (surface < meshes_.size()) {
    meshes_[surface] = std::move(uploaded);
  } else {
    meshes_.push_back(std::move(uploaded));
  }
}

void Renderer::keep_meshes(std::size_t count) {
  if (count >= meshes_.size()) return;
  meshes_.erase(meshes_.begin() + static_cast<std::ptrdiff_t>(count), meshes_.end());
}

void Renderer::draw(const Scene& scene, const FittedCamera& camera, const Viewport& viewport,
                    const Look& look) {
  assert(meshes_.size() == scene.surfaces.size());
  Bounds bounds;
  for (const GpuMesh& mesh : meshes_) bounds.add(mesh.bounds());
  const double unit = model_frame(bounds).size;
  const PixelRect& rect = viewport.rect;
  const glm::dmat4 to_rect = clip_to_rect(viewport.width, viewport.height, rect, viewport.margin);
  std::vector<View> views;
  for (const GpuMesh& mesh : meshes_) {
    views.emplace_back(camera, mesh.frame(), unit);
    views.back().model_to_clip = to_rect * views.back().model_to_clip;
  }

  const int n = viewport.per_side;
  glViewport(0, 0, n * (rect.width + 2 * viewport.margin), n * (rect.height + 2 * viewport.margin));
  clear(scene.background);
  glEnable(GL_DEPTH_TEST);
  draw_surfaces(scene, views, unit, n, look);
  if (look.lines) draw_lines(views, n);
  if (marks_) {
    View view(camera, marks_->frame(), unit);
    view.model_to_clip = to_rect * view.model_to_clip;
    draw_marks(view, n);
  }
  check_gl();
}

Program& Renderer::surface_program(const Scene& scene) {
  std::string fragment = assemble_shader(shader_source("surface.frag.glsl"), shader_needs(scene));
  const auto known = surface_programs_.find(fragment);
  if (known != surface_programs_.end()) return known->second;
  Program program(std::string(shader_source("surface.vert.glsl")), fragment);
  return surface_programs_.emplace(std::move(fragment), std::move(program)).first->second;
}

Program& Renderer::line_program() {
  if (!line_program_) {
    line_program_.emplace(std::string(shader_source("line.vert.glsl")),
                          std::string(shader_source("line.frag.glsl")));
  }
  return *line_program_;
}

bool Renderer::has_lines() const {
  return std::ranges::any_of(meshes_, &GpuMesh::has_lines);
}

/// Faces are pushed back by the depth they have across half a line's width, at which a sample of
/// the line may lie from the line itself, and half a sample more.
void Renderer::draw_surfaces(const Scene& scene, const std::vector<View>& views, double unit,
                             int line_width, const Look& look) {
  Program& program = surface_program(scene);
  program.use();
  set_lights(program, scene.lights, unit);
  if (has_lines()) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.5F * static_cast<float>(line_width + 1), 1);
  }
  if (look.wireframe) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glLineWidth(static_cast<float>(line_width));
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    program.set("model_to_clip", views[i].model_to_clip);
    program.set("model_to_eye", views[i].model_to_eye);
    set_materials(program, scene.surfaces[i]);
    program.check_all_set();
    meshes_[i].draw_triangles();
  }
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

/// `line_width` in samples.
void Renderer::draw_lines(const std::vector<View>& views, int line_width) {
  if (!has_lines()) return;
  Program& program = line_program();
  program.use();
  program.set("line_color", kLineColor);
  glLineWidth(static_cast<float>(line_width));
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (!meshes_[i].has_lines()) continue;
    program.set("model_to_clip", views[i].model_to_clip);
    program.check_all_set();
    meshes_[i].draw_lines();
  }
}

/// They may stand out of the box that the camera's near and far planes enclose.
void Renderer::draw_marks(const View& view, int line_width) {
  Program& program = line_program();
  program.use();
  program.set("line_color", kMarkColor);
  program.set("model_to_clip", view.model_to_clip);
  program.check_all_set();
  glLineWidth(static_cast<float>(line_width));
  glEnable(GL_DEPTH_CLAMP);
  marks_->draw_lines();
  glDisable(GL_DEPTH_CLAMP);
}

}  // namespace saddle
