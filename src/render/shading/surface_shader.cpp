// The preprocessor's work, done before the compiler sees the text: what a program of a scene holds
// can be read, and tested.
#include "render/shading/surface_shader.h"

#include <algorithm>
#include <cassert>
#include <sstream>

#include "render/shading/normal_shader.h"
#include "render/shading/shader_lights.h"
#include "render/shading/shaders.h"

namespace saddle {
namespace {

/// Longest run of lights of a kind that is written out; a longer one becomes a loop, which compiles
/// in a moment however many there are.
constexpr std::size_t kWrittenOut = 8;

std::vector<std::string> names_of(const ShaderNeeds& needs) {
  std::vector<std::string> names = {"LIGHT_COUNT"};
  const auto add = [&names](bool needed, const char* name) {
    if (needed) names.emplace_back(name);
  };
  const bool cone = has_cone(needs);
  const bool lit = !needs.lights.empty();
  for (const LightKind& kind : light_kinds()) {
    add(std::ranges::count(needs.lights, &kind) > 0, kind.name);
  }
  add(lit, "LIT");
  add(lit && needs.grey, "GREY");
  add(needs.attenuation, "ATTENUATION");
  add(cone, "CONE");
  add(needs.attenuation || cone, "FADES");
  add(cone && needs.focus, "FOCUS");
  add(lit && needs.ambient, "AMBIENT");
  add(lit && needs.specular, "SPECULAR");
  add(lit && needs.specular && needs.highlights, "HIGHLIGHTS");
  add(lit && (needs.specular || (cone && needs.focus)), "POWERS");
  add(needs.unlit, "UNLIT");
  add(needs.blinn, "BLINN");
  add(needs.emission, "EMISSION");
  add(needs.two_sided, "TWO_SIDED");
  add(needs.two_sided && needs.two_materials, "TWO_MATERIALS");
  add(needs.per_vertex, "PER_VERTEX");
  add(needs.orthographic, "ORTHOGRAPHIC");
  add(needs.colored, "COLORED");
  add(needs.normal_matrix, "NORMAL_MATRIX");
  add(needs.see_through, "SEE_THROUGH");
  add(needs.normal != nullptr, "EXACT");
  return names;
}

/// A call for each light.
std::string calls(const std::vector<const LightKind*>& lights) {
  std::string text;
  for (std::size_t begin = 0; begin < lights.size();) {
    std::size_t end = begin;
    while (end < lights.size() && lights[end] == lights[begin]) ++end;
    const std::string call = std::string("  ") + lights[begin]->function + "(";
    if (end - begin <= kWrittenOut) {
      for (std::size_t i = begin; i < end; ++i) text += call + std::to_string(i) + ");\n";
    } else {
      text += "  for (int i = " + std::to_string(begin) + "; i < " + std::to_string(end) +
              "; ++i)" + call + "i);\n";
    }
    begin = end;
  }
  return text;
}

std::string source(const char* name) {
  return std::string(shader_source(name));
}

void replace(std::string& text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
}

/// The lighting of a scene with these lights.
std::string lighting(const ShaderNeeds& needs, const std::vector<std::string>& names) {
  std::string text = keep_defined(source("lighting.glsl"), names);
  text.erase(0, text.find("\n\n") + 1);  // what the names mean is for the file's reader
  replace(text, "  LIGHTS\n", calls(needs.lights));
  const std::string type = needs.grey ? "float" : "vec3";
  replace(text, "#define RGB_OR_GREY " + type + "\n", "");
  replace(text, "RGB_OR_GREY", type);
  replace(text, "[LIGHT_COUNT]", "[" + std::to_string(needs.lights.size()) + "]");
  return text;
}

}  // namespace

ShaderText assemble_surface_shader(const ShaderNeeds& needs) {
  const std::vector<std::string> names = names_of(needs);
  ShaderText result{keep_defined(source("surface.vert.glsl"), names),
                    keep_defined(source("surface.frag.glsl"), names)};
  std::string& lit = needs.per_vertex ? result.vertex : result.fragment;
  const std::string normal = needs.normal == nullptr ? "" : normal_shader(*needs.normal);
  lit.insert(lit.find('\n') + 1, normal + lighting(needs, names));  // after #version
  return result;
}

}  // namespace saddle
