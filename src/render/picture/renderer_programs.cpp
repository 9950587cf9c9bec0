// The programs of a renderer: compiled once, and kept as long as scenes may need them.
#include <algorithm>
#include <string>
#include <utility>

#include "render/picture/renderer.h"
#include "render/shading/surface_shader.h"

namespace saddle {

/// A window in which formulas are typed asks for ever new ones: those go that were not wanted for
/// the longest time. None goes that the picture at hand has used.
void Renderer::forget_old_programs() {
  while (programs_.size() > kMostPrograms) {
    const auto oldest = std::ranges::min_element(
        programs_, {}, [](const auto& known) { return known.second.used; });
    if (oldest->second.used == pictures_drawn_) return;
    std::erase_if(surface_programs_, [&](const SurfaceProgram& noted) {
      return noted.text.vertex + noted.text.fragment == oldest->first;
    });
    programs_.erase(oldest);
  }
}

Program& Renderer::program(const ShaderText& text, const std::string& captured) {
  const std::string both = text.vertex + text.fragment;
  auto known = programs_.find(both);
  if (known == programs_.end()) {
    Program compiled(text.vertex, text.fragment, captured);
    known = programs_.emplace(both, KeptProgram{std::move(compiled)}).first;
  }
  known->second.used = pictures_drawn_;
  return known->second.program;
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
