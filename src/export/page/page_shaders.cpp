#include "export/page/page_shaders.h"

#include <algorithm>
#include <string>
#include <utility>

#include "export/page/page_text.h"
#include "render/shading/shader_materials.h"
#include "render/shading/shaders.h"
#include "render/shading/surface_shader.h"

namespace saddle {
namespace {

/// An expression may have any value: one that switches nothing off stands for it.
void make_lively(Number& number, double value) {
  if (!number.text.empty()) number.value = value;
}

void make_lively(Vector& v) {
  make_lively(v.x, 0.3);
  make_lively(v.y, 0.4);
  make_lively(v.z, 0.5);
}

void make_lively(Color& color) {
  make_lively(color.r, 0.3);
  make_lively(color.g, 0.4);
  make_lively(color.b, 0.5);
}

Light lively(Light light) {
  make_lively(light.enabled, 1);
  make_lively(light.position);
  make_lively(light.color);
  make_lively(light.ambient);
  if (light.specular) make_lively(*light.specular);
  make_lively(light.attenuation.constant, 0.5);
  make_lively(light.attenuation.linear, 0.5);
  make_lively(light.attenuation.quadratic, 0.5);
  if (light.spot) make_lively(light.spot->exponent, 1);
  return light;
}

SurfaceSpec lively(SurfaceSpec spec) {
  for (Material* const material : {&spec.front, &spec.back}) {
    make_lively(material->diffuse);
    make_lively(material->specular);
    make_lively(material->emission);
    if (material->ambient) make_lively(*material->ambient);
  }
  make_lively(spec.back.diffuse.r, 0.6);  // another one than the front's
  make_lively(spec.opacity, 0.5);
  return spec;
}

/// A light with its uniforms, as the shaders' text depends on them; none that is dark.
std::vector<std::pair<Light, ShaderLight>> shining(const Scene& scene, const FittedCamera& camera) {
  std::vector<std::pair<Light, ShaderLight>> result;
  for (const Light& light : scene.lights) {
    Scene alone = scene;
    alone.lights = {lively(light)};
    for (const ShaderLight& uniforms : shader_lights(alone, camera, 1)) {
      result.emplace_back(light, uniforms);
    }
  }
  std::ranges::stable_sort(result, {}, [](const auto& both) { return both.second.kind; });
  return result;
}

/// As WebGL has it: another first line, which the page adds.
std::string for_page(const std::string& text) {
  const std::string result = squeezed(without_comments(text));
  return result.starts_with("#version") ? result.substr(result.find('\n') + 1) : result;
}

ShaderText for_page(const ShaderText& text) {
  return {for_page(text.vertex), for_page(text.fragment)};
}

/// All sides are seen, as the reader may turn the surface.
ShaderNeeds needs_of(const PageScene& page, std::size_t surface, const ShaderNeeds& lit) {
  const Scene& scene = page.scene;
  const SurfaceSpec spec = lively(scene.surfaces[surface]);
  const Shading shading = shading_of(scene, spec);
  ShaderNeeds needs;
  needs.unlit = shading == Shading::Unlit;
  if (!needs.unlit) needs = lit;
  needs.orthographic = scene.camera.ortho;
  needs.blinn = specular_of(scene, spec) == Specular::Blinn;
  needs.per_vertex = shading == Shading::Vertex;
  needs.see_through = spec.opacity < 1;
  needs.normal_matrix = !spec.in.empty() || dvec3(scene.scale.factors) != dvec3(1);
  needs.colored = !page.meshes[surface].color.empty() && !spec.color.empty();
  if (spec.texture && !page.meshes[surface].triangles.empty()) {
    needs.textured = spec.texture.picture ? TextureUse::Picture : TextureUse::Checker;
  }
  add_material_needs({spec.front, spec.back}, true, needs);
  return needs;
}

}  // namespace

std::vector<Light> page_lights(const Scene& scene) {
  std::vector<Light> lights;
  for (auto& [light, uniforms] :
       shining(scene, fit_camera(scene.camera, {dvec3(-1), dvec3(1)}, 1))) {
    lights.push_back(std::move(light));
  }
  return lights;
}

PageShaders page_shaders(const PageScene& page) {
  PageShaders result;
  const auto source = [](const char* name) { return std::string(shader_source(name)); };
  result.programs.push_back(for_page({source("stroke.vert.glsl"), source("stroke.frag.glsl")}));
  std::vector<ShaderLight> lights;
  for (const auto& [light, uniforms] : shining(page.scene, page.camera)) lights.push_back(uniforms);
  ShaderNeeds lit;
  add_light_needs(lights, lit);
  result.grey = lit.grey;
  std::vector<ShaderNeeds> known;
  for (std::size_t i = 0; i < page.scene.surfaces.size(); ++i) {
    const ShaderNeeds needs = needs_of(page, i, lit);
    auto found = std::ranges::find(known, needs);
    if (found == known.end()) {
      known.push_back(needs);
      found = known.end() - 1;
      result.programs.push_back(for_page(assemble_surface_shader(needs)));
    }
    result.of_surface.push_back(static_cast<std::size_t>(found - known.begin()) + 1);
  }
  return result;
}

}  // namespace saddle
