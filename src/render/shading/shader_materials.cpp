#include "render/shading/shader_materials.h"

#include <string>

namespace saddle {
namespace {

dvec3 rgb(const Color& color) {
  return {color.r, color.g, color.b};
}

bool is_black(const Color& color) {
  return color.r == 0 && color.g == 0 && color.b == 0;
}

const Color& ambient(const Material& material) {
  return material.ambient ? *material.ambient : material.diffuse;
}

bool same(const Color& a, const Color& b) {
  return rgb(a) == rgb(b);
}

bool same_but_for_colors(const Material& a, const Material& b) {
  return same(a.specular, b.specular) && a.shininess == b.shininess.value &&
         same(a.emission, b.emission);
}

bool same(const Material& a, const Material& b) {
  return same(a.diffuse, b.diffuse) && same(ambient(a), ambient(b)) && same_but_for_colors(a, b);
}

/// Sets the uniforms of one side's material that the program was made for.
void set_material(Program& program, const std::string& side, const Material& material,
                  const ShaderNeeds& needs) {
  const bool lit = !needs.lights.empty();
  const bool has_own_color = needs.colored || needs.textured == TextureUse::Picture;
  if (!has_own_color) program.set(side + "_diffuse", rgb(material.diffuse));
  if (lit && needs.specular) {
    program.set(side + "_specular", rgb(material.specular));
    program.set(side + "_shininess", material.shininess);
  }
  if (lit && needs.ambient && !has_own_color)
    program.set(side + "_ambient", rgb(ambient(material)));
  if (needs.emission) program.set(side + "_emission", rgb(material.emission));
}

}  // namespace

void add_material_needs(const SideMaterials& materials, bool emission, ShaderNeeds& needs) {
  const bool has_own_color = needs.colored || needs.textured == TextureUse::Picture;
  if (needs.unlit) {
    needs.two_materials =
        needs.two_sided && !has_own_color && !same(materials.front.diffuse, materials.back.diffuse);
    return;
  }
  needs.specular = !is_black(materials.front.specular) ||
                   (needs.two_sided && !is_black(materials.back.specular));
  needs.emission =
      emission && (!is_black(materials.front.emission) || !is_black(materials.back.emission));
  const bool is_same = has_own_color ? same_but_for_colors(materials.front, materials.back)
                                     : same(materials.front, materials.back);
  needs.two_materials = needs.two_sided && !is_same;
}

void set_materials(Program& program, const SideMaterials& materials, const ShaderNeeds& needs) {
  set_material(program, "front", materials.front, needs);
  if (needs.two_materials) set_material(program, "back", materials.back, needs);
}

}  // namespace saddle
