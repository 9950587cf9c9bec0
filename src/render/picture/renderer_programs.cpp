// The programs of a renderer: compiled once, and kept as long as scenes may need them.
#include <algorithm>
#include <string>

#include "render/picture/renderer.h"
#include "render/shading/surface_shader.h"

namespace saddle {

/// A window in which formulas are typed asks for ever new ones: those of old scenes go.
void Renderer::forget_old_programs() {
  if (programs_.size() <= kMostPrograms + kProgramsOfSurface * meshes_.size()) return;
  programs_.clear();
  surface_programs_.clear();
}

Program& Renderer::program(const ShaderText& text, const std::string& captured) {
  const std::string both = text.vertex + text.fragment;
  const auto known = programs_.find(both);
  if (known != programs_.end()) return known->second;
  return programs_.emplace(both, Program(text.vertex, text.fragment, captured)).first->second;
}

/// The program for a surface, which is noted.
Program& Renderer::surface_program(const ShaderNeeds& needs, const std::string& surface) {
  const ShaderText text = assemble_surface_shader(needs);
  const auto is_it = [&](const SurfaceProgram& known) {
    return known.text.vertex == text.vertex && known.text.fragment == text.fragment;
  };
  auto known = std::ranges::find_if(surface_programs_, is_it);
  if (known == surface_programs_.end()) {
    surface_programs_.push_back({text, {}, parts_left_out(needs)});
    known = surface_programs_.end() - 1;
  }
  if (std::ranges::find(known->surfaces, surface) == known->surfaces.end()) {
    known->surfaces.push_back(surface);
  }
  return program(text);
}

}  // namespace saddle
