// The order of work: the surfaces that hide, once for as many lights as a program holds; lines on
// top of them; then those that are see-through, in the same way for each of their layers.
#include "render/picture/renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <new>
#include <utility>

#include <glm/common.hpp>

#include "base/error.h"
#include "render/picture/tiles.h"
#include "render/shading/normal_shader.h"
#include "render/shading/shader_materials.h"
#include "render/shading/shaders.h"
#include "render/shading/surface_shader.h"
#include "scene/model/strokes.h"
#include "scene/model/texture.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

/// Lights beyond this number slow a program down, as each pixel takes all of them, but do not make
/// it any longer.
constexpr std::size_t kMostLightsAtOnce = 512;

/// Share of a mesh's corners at which floats must know the normal. Where they do not at most of
/// them, they do at the others by chance.
constexpr double kLeastTrust = 0.5;

void clear(const Color& background) {
  const auto channel = [](double value) { return static_cast<float>(value); };
  glClearColor(channel(background.r), channel(background.g), channel(background.b),
               channel(background.a));
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

void Renderer::set_mesh(std::size_t surface, const Mesh& mesh) {
  assert(surface <= meshes_.size());
  GpuMesh uploaded(mesh);
  if (surface < meshes_.size()) {
    meshes_[surface] = std::move(uploaded);
  } else {
    meshes_.push_back(std::move(uploaded));
  }
  normals_.resize(meshes_.size());
  normals_[surface] = {};
  stroke_drawer_.set_mesh(surface, mesh);
}

void Renderer::set_surface(const Scene& scene, std::size_t surface, const Mesh& mesh) {
  set_mesh(surface, mesh);
  const SurfaceSpec& spec = scene.surfaces[surface];
  if (spec.texture && !mesh.triangles.empty()) {
    meshes_[surface].set_texture_places(texture_places(scene, spec, mesh.uv));
  }
  const bool exact = shading_of(scene, spec) == Shading::Exact;
  if (!exact || mesh.triangles.empty()) return;
  ShaderNormal formula = shader_normal(scene, scene.surfaces[surface]);
  if (mesh.solid) formula.obstacle = "the formula has no normal of the walls of a solid";
  if (!formula.obstacle) {
    Program& trust = program(trust_shader(formula), "trust_in_formula");
    trust.use();
    if (!formula.constants.empty()) trust.set("constant", formula.constants);
    trust.check_all_set();
    const double share = meshes_[surface].measure_trust(trust, mesh.uv);
    if (share < kLeastTrust) formula.obstacle = "a shader's floats have too few digits for it";
  }
  if (formula.obstacle) {
    normals_[surface].warning =
        scene.surfaces[surface].name +
        ": shaded with interpolated normals, not exact ones: " + *formula.obstacle;
  } else {
    normals_[surface].formula = std::move(formula);
  }
}

void Renderer::keep_meshes(std::size_t count) {
  if (count >= meshes_.size()) return;
  meshes_.erase(meshes_.begin() + static_cast<std::ptrdiff_t>(count), meshes_.end());
  normals_.resize(count);
  stroke_drawer_.keep_meshes(count);
}

std::vector<PlacedMesh> Renderer::items_of(const Scene& scene, const FittedCamera& camera,
                                           double unit, const Look& look) const {
  std::vector<PlacedMesh> items;
  for (const Instance& instance : instances(scene)) {
    PlacedMesh item(instance, meshes_[instance.surface], camera, unit);
    item.opacity = scene.surfaces[instance.surface].opacity;
    if (item.opacity < 1 || look.wireframe) item.two_sided = true;
    if (item.is_visible() && meshes_[item.surface].triangle_count() > 0) items.push_back(item);
  }
  return items;
}

void Renderer::note_culled(std::span<const PlacedMesh> items) {
  culled_.clear();
  for (const PlacedMesh& item : items) {
    const auto [known, is_first] = culled_.try_emplace(item.surface, !item.two_sided);
    if (!is_first) known->second &= !item.two_sided;
  }
}

Renderer::LineWidths Renderer::line_widths(const Scene& scene, const Viewport& viewport) const {
  LineWidths widths;
  widths.grid = samples_across(widest_surface_line(scene, viewport.size()), viewport);
  widths.widest = widths.grid;
  if (has_contours()) {  // they are half a pixel beside the mesh
    const double contours = widest_contour(scene, viewport.size()) + 1;
    widths.widest = std::max(widths.grid, samples_across(contours, viewport));
  }
  return widths;
}

bool Renderer::draw(const Scene& scene, const FittedCamera& camera, const Viewport& viewport,
                    const Look& look) {
  assert(meshes_.size() == scene.surfaces.size());
  Bounds bounds;
  for (const Instance& instance : instances(scene)) {
    bounds.add(transformed(meshes_[instance.surface].bounds(), instance.to_world));
  }
  const double unit = model_frame(bounds).size;
  const PixelRect& rect = viewport.rect;
  const glm::dmat4 to_rect = clip_to_rect(viewport.width, viewport.height, rect, viewport.margin);
  std::vector<PlacedMesh> items = items_of(scene, camera, unit, look);
  note_culled(items);
  for (PlacedMesh& item : items) item.model_to_clip = to_rect * item.model_to_clip;
  const std::vector<ShaderLight> lights = shader_lights(scene, camera, unit);
  scales_ = scales_of(scene);
  const LineWidths widths = line_widths(scene, viewport);
  glViewport(0, 0, viewport.samples_across(), viewport.samples_down());
  std::vector<PlacedMesh> hiding;
  std::vector<PlacedMesh> see_through;
  for (const PlacedMesh& item : items) {
    if (item.opacity == 1) hiding.push_back(item);
    if (item.opacity > 0 && item.opacity < 1) see_through.push_back(item);
  }
  if (scene.box) bounds.add(*scene.box);
  Annotations annotations;
  if (!look.bare) {
    annotations = annotate(scene, camera, bounds, scales_, viewport.size(),
                           stroke_drawer_.labels(scene, camera, viewport.size()));
  }
  unknown_letters_ = annotations.unknown;
  const dvec3 ink = ink_of(scene);
  Color background = scene.background;
  // Letters blend into what is there: on nothing at all that must not darken them.
  const bool is_bare = background.a == 0 && see_through.empty() && !annotations.empty();
  if (is_bare) background = {ink.r, ink.g, ink.b, 0};
  glEnable(GL_DEPTH_TEST);
  if (!look.interruption.is_over) {
    ++pictures_drawn_;
    clear(background);
    draw_surfaces(scene, hiding, lights, widths, look);
    if (!look.bare) draw_lines(scene, items, {camera, viewport, unit}, look);
    if (marks_) {
      PlacedMesh item({}, *marks_, camera, unit);
      item.model_to_clip = to_rect * item.model_to_clip;
      line_drawer_.draw_marks(*marks_, item, viewport);
    }
    if (!annotations.edges.empty()) line_drawer_.draw_box(annotations.edges, camera, viewport, ink);
  }
  const auto shade = [&] { draw_surfaces(scene, see_through, lights, widths, look); };
  const bool is_whole = draw_see_through(see_through, shade, viewport, widths, look);
  if (is_whole && !annotations.empty()) {
    Program& program = line_drawer_.program();
    program.use();
    program.set("line_color", ink);
    if (!overlay_) overlay_.emplace();
    overlay_->draw(annotations, viewport, {ink, rim_of_letters(scene)}, program, colormaps_);
  }
  glUseProgram(0);  // a program that a caller remembers as used may be deleted
  if (is_whole) forget_old_programs();
  check_gl();
  return is_whole;
}

/// Grid lines, level lines, curves and dots.
void Renderer::draw_lines(const Scene& scene, std::span<const PlacedMesh> items,
                          const StrokeDrawer::Screen& screen, const Look& look) {
  if (look.lines) line_drawer_.draw_lines(scene, items, meshes_, screen.viewport);
  if (has_contours()) line_drawer_.draw_contours(scene, items, meshes_, screen.viewport);
  if (stroke_drawer_.has_strokes()) {
    stroke_drawer_.draw(scene, meshes_, screen, line_drawer_.stroke_program());
  }
}

/// `shade` draws the items. False: it has paused.
bool Renderer::draw_see_through(std::span<const PlacedMesh> items,
                                const std::function<void()>& shade, const Viewport& viewport,
                                const LineWidths& widths, const Look& look) {
  if (items.empty()) return true;
  const double least = std::ranges::min(items, {}, &PlacedMesh::opacity).opacity;
  std::size_t triangles = 0;
  for (const PlacedMesh& item : items) triangles += meshes_[item.surface].triangle_count();
  const auto peel = [&](Program& program) { draw_depths(items, program, widths, look); };
  const auto cut_after = layers(viewport).draw({peel, shade, least, triangles, look.interruption});
  if (!cut_after) return false;
  if (*cut_after > 0 && (layers_drawn_ == 0 || *cut_after < layers_drawn_)) {
    layers_drawn_ = *cut_after;
  }
  return true;
}

Layers& Renderer::layers(const Viewport& viewport) {
  if (!layers_) layers_.emplace();
  layers_->fit(viewport.samples_across(), viewport.samples_down());
  return *layers_;
}

std::vector<std::string> Renderer::warnings() const {
  std::vector<std::string> all;
  for (const Normals& normals : normals_) {
    if (normals.warning) all.push_back(*normals.warning);
  }
  if (!unknown_letters_.empty()) {
    all.push_back("the font of pictures has no letters for " + unknown_letters_ +
                  ": boxes stand for them");
  }
  if (line_drawer_.has_thinner_lines()) {
    all.emplace_back("the OpenGL driver draws no lines as wide as these: they are thinner");
  }
  if (layers_drawn_ > 0) {
    all.push_back("more than " + std::to_string(layers_drawn_) +
                  " see-through layers lie behind each other: those farther away are not drawn; "
                  "--max-triangles with fewer triangles allows more layers");
  }
  return all;
}

bool Renderer::has_lines() const {
  return std::ranges::any_of(meshes_, &GpuMesh::has_lines) || stroke_drawer_.has_strokes();
}

bool Renderer::has_contours() const {
  return std::ranges::any_of(meshes_, &GpuMesh::has_contours);
}

std::size_t Renderer::lights_at_once() {
  if (lights_at_once_ == 0) {
    GLint vertex = 0;
    GLint fragment = 0;
    glGetIntegerv(GL_MAX_VERTEX_UNIFORM_COMPONENTS, &vertex);
    glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &fragment);
    lights_at_once_ =
        std::min(saddle::lights_at_once(std::min(vertex, fragment)), kMostLightsAtOnce);
  }
  return lights_at_once_;
}

std::vector<ColorScale> Renderer::scales_of(const Scene& scene) const {
  std::vector<std::optional<ColorRange>> ranges;
  for (const GpuMesh& mesh : meshes_) ranges.push_back(mesh.color_range());
  return color_scales(scene, ranges);
}

/// From the mesh's own range, in which its numbers are uploaded, to the scale that it shares.
void Renderer::set_color(Program& program, const Scene& scene, std::size_t surface) {
  const ColorScale& scale = scale_of(scene.surfaces[surface], scales_);
  const ColorRange& range = *meshes_[surface].color_range();
  const double first = place_on(scale, range.low);
  program.set("color_offset", first);
  program.set("color_scale", place_on(scale, range.high) - first);
  program.set_texture("colormap", 0);
  colormaps_.bind(scale.colormap);
}

void Renderer::set_texture(Program& program, const SurfaceSpec& surface) {
  program.set("texture_scale", dvec3(texture_scale(surface), 1));
  if (!surface.texture.picture) return;
  program.set_texture("picture", 0);
  pictures_.bind(surface.texture);
}

/// Faces are pushed back by the depth they have across half a line's width, at which a sample of
/// the line may be, and half a sample more.
void Renderer::start_faces(const LineWidths& widths, const Look& look) const {
  if (has_lines() || has_contours()) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.5F * static_cast<float>(widths.widest + 1), 1);
  }
  if (!look.wireframe) return;
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  set_line_width(widths.grid);
}

void Renderer::end_faces() {
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void Renderer::draw_depths(std::span<const PlacedMesh> items, Program& program,
                           const LineWidths& widths, const Look& look) {
  start_faces(widths, look);
  for (const PlacedMesh& item : items) {
    program.set("model_to_clip", item.model_to_clip);
    program.check_all_set();
    meshes_[item.surface].draw_triangles();
  }
  end_faces();
}

/// Passes after the first add light to the nearest surfaces.
void Renderer::draw_surfaces(const Scene& scene, std::span<const PlacedMesh> items, Lights lights,
                             const LineWidths& widths, const Look& look) {
  start_faces(widths, look);
  const std::size_t most = lights_at_once();
  draw_pass(scene, items, lights.first(std::min(most, lights.size())), true);
  if (lights.size() > most) {
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    for (std::size_t begin = most; begin < lights.size(); begin += most) {
      draw_pass(scene, items, lights.subspan(begin, std::min(most, lights.size() - begin)), false);
    }
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
  }
  end_faces();
}

/// `needs`: those of the lights. Adds those of a part.
ShaderNeeds Renderer::needs_of(const Scene& scene, const DrawnPart& part, ShaderNeeds needs,
                               bool first) const {
  const PlacedMesh& item = *part.item;
  const SurfaceSpec& surface = scene.surfaces[item.surface];
  const Shading shading = shading_of(scene, surface);
  needs.blinn = specular_of(scene, surface) == Specular::Blinn;
  needs.per_vertex = shading == Shading::Vertex;
  needs.two_sided = item.two_sided;
  needs.see_through = item.opacity < 1;
  needs.normal_matrix = !item.is_similar;
  const auto& formula = normals_[item.surface].formula;
  needs.normal = shading == Shading::Exact && formula ? &*formula : nullptr;
  if (surface.texture && meshes_[item.surface].has_texture_places()) {
    needs.textured = surface.texture.picture ? TextureUse::Picture : TextureUse::Checker;
  }
  needs.colored = meshes_[item.surface].color_range() && !surface.color.empty();
  add_material_needs(part.materials, first, needs);
  return needs;
}

void Renderer::draw_pass(const Scene& scene, std::span<const PlacedMesh> items, Lights lights,
                         bool first) {
  const ShaderNeeds unlit{.unlit = true, .orthographic = scene.camera.ortho};
  ShaderNeeds lit{.orthographic = scene.camera.ortho};
  add_light_needs(lights, lit);
  Program* program = nullptr;
  ShaderNeeds made_for;
  for (const DrawnPart& part : parts_of(scene, items, meshes_)) {
    const PlacedMesh& item = *part.item;
    const SurfaceSpec& surface = scene.surfaces[item.surface];
    const bool is_unlit = shading_of(scene, surface) == Shading::Unlit;
    if (is_unlit && !first) continue;
    const ShaderNeeds needs = needs_of(scene, part, is_unlit ? unlit : lit, first);
    if (program == nullptr || needs != made_for) {
      program = &surface_program(needs, surface.name);
      program->use();
      set_lights(*program, is_unlit ? Lights() : lights, needs);
      made_for = needs;
    }
    program->set("model_to_clip", item.model_to_clip);
    program->set("model_to_eye", item.model_to_eye);
    if (needs.normal_matrix) program->set("normal_to_eye", item.normal_to_eye);
    if (needs.normal != nullptr && !needs.normal->constants.empty()) {
      program->set("constant", needs.normal->constants);
    }
    if (needs.see_through) program->set("opacity", item.opacity);
    if (needs.colored) set_color(*program, scene, item.surface);
    if (needs.textured != TextureUse::None) set_texture(*program, surface);
    set_materials(*program, part.materials, needs);
    program->check_all_set();
    glFrontFace(item.mirrored ? GL_CW : GL_CCW);
    item.two_sided ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
    meshes_[item.surface].draw_triangles(part.first, part.count);
  }
  glFrontFace(GL_CCW);
  glDisable(GL_CULL_FACE);
}

}  // namespace saddle
