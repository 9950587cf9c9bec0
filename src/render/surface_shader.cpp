#include "render/surface_shader.h"

#include <cassert>

namespace saddle {
namespace {

bool is_black(const Color& color) {
  return color.r == 0 && color.g == 0 && color.b == 0;
}

bool same(const Color& a, const Color& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

bool same(const Material& a, const Material& b) {
  return same(a.diffuse, b.diffuse) && same(a.specular, b.specular) && a.shininess == b.shininess;
}

}  // namespace

bool shines(const Light& light) {
  return !is_black(light.color);
}

ShaderNeeds shader_needs(const Scene& scene) {
  ShaderNeeds needs;
  needs.orthographic = scene.camera.ortho;
  for (const Light& light : scene.lights) {
    if (shines(light)) needs.directional.push_back(light.directional);
  }
  for (const SurfaceSpec& surface : scene.surfaces) {
    needs.specular |= !is_black(surface.front.specular) || !is_black(surface.back.specular);
    needs.two_materials |= !same(surface.front, surface.back);
  }
  return needs;
}

std::string assemble_shader(std::string_view source, const ShaderNeeds& needs) {
  const std::size_t first_line = source.find('\n') + 1;
  assert(source.starts_with("#version") && first_line != 0);
  std::string text(source.substr(0, first_line));
  text += "#define LIGHT_COUNT " + std::to_string(needs.directional.size()) + "\n#define LIGHTS";
  for (std::size_t i = 0; i < needs.directional.size(); ++i) {
    text += (needs.directional[i] ? " DIRECTIONAL(" : " POINT(") + std::to_string(i) + ")";
  }
  text += "\n";
  if (needs.specular) text += "#define SPECULAR\n";
  if (needs.two_materials) text += "#define TWO_MATERIALS\n";
  if (needs.orthographic) text += "#define ORTHOGRAPHIC\n";
  text += "#line 2\n";  // the compiler's messages name the file's own lines
  text += source.substr(first_line);
  return text;
}

}  // namespace saddle
