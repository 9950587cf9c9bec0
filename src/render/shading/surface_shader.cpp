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
  add(needs.textured != TextureUse::None, "TEXTURED");
  add(needs.textured == TextureUse::Picture, "PICTURE");
  add(needs.textured == TextureUse::Checker, "CHECKER");
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
  replace(text, "#define MATT color\n", "");
  replace(text, "MATT is `matt`\n// with a texture, else `color`.",
          "Diffuse light is apart\n// with a texture.");
  replace(text, "MATT", needs.textured == TextureUse::None ? "color" : "matt");
  replace(text, "[LIGHT_COUNT]", "[" + std::to_string(needs.lights.size()) + "]");
  return text;
}

}  // namespace

std::vector<std::string> parts_left_out(const ShaderNeeds& needs) {
  std::vector<std::string> parts;
  const auto add = [&parts](bool left_out, const char* text) {
    if (left_out) parts.emplace_back(text);
  };
  const bool lit = !needs.lights.empty();
  const bool cone = has_cone(needs);
  add(needs.unlit, "unlit: no lights, no highlights, no emission");
  add(!needs.unlit && !lit, "no light is on: no lighting");
  add(lit && needs.lights.size() <= kWrittenOut, "few lights: no loop over them");
  add(lit && needs.grey, "no light has a hue: a number for each in place of a colour");
  add(lit && !cone, "no spot light: no cone test");
  add(cone && !needs.focus, "no spot light has an exponent: no power of its cosine");
  add(lit && !needs.attenuation, "no light is weaker from afar: no distance and no attenuation");
  add(lit && !needs.ambient, "no light has an ambient part: no ambient term");
  add(lit && !needs.specular, "the material mirrors nothing: no specular term");
  add(lit && needs.specular && !needs.highlights,
      "no light has another colour for highlights: one colour for each");
  add(!needs.unlit && !needs.emission, "the material does not shine by itself: no emission");
  add(!needs.two_sided, "the back cannot be seen: no second side, back faces are culled");
  add(needs.two_sided && !needs.two_materials, "both sides look alike: one material");
  add(!needs.colored, "the materials' colours: no lookup in a colour map");
  add(needs.textured == TextureUse::None, "no texture: no lookup in a picture");
  add(!needs.normal_matrix, "turned, moved and scaled evenly: no matrix for normals");
  add(needs.per_vertex, "lit per vertex: no light in the fragment shader");
  add(!needs.per_vertex && needs.normal == nullptr,
      "normals are interpolated: no formula for them in the fragment shader");
  add(!needs.see_through, "it hides what is behind it: no opacity");
  add(needs.orthographic, "parallel projection: one direction to the eye");
  return parts;
}

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
