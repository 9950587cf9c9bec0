#include "render/overlay/overlay_drawer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/vec4.hpp>

#include "render/gl/gpu_mesh.h"
#include "render/shading/shaders.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

/// Lines of text that are kept for the next picture.
constexpr std::size_t kMostTexts = 512;

/// Samples of the framebuffer, from its lower left, of a place in the picture.
dvec2 sample_of(const dvec2& pixel, const Viewport& v) {
  return dvec2(pixel.x - v.rect.x + v.margin, v.rect.y + v.rect.height + v.margin - pixel.y) *
         v.per_side;
}

dvec3 clip_of(const dvec2& sample, const Viewport& v) {
  const dvec2 size(v.rect.width + 2 * v.margin, v.rect.height + 2 * v.margin);
  return {2.0 * sample / (size * v.per_side) - 1.0, 0};
}

Program make_program(const char* fragment) {
  return {std::string(shader_source("overlay.vert.glsl")), std::string(shader_source(fragment))};
}

/// The rectangle between two samples.
void draw_rectangle(Program& program, const dvec2& low, const dvec2& high, const Viewport& v) {
  program.set("low", clip_of(low, v));
  program.set("high", clip_of(high, v));
  program.check_all_set();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace

glm::dmat4 OverlayDrawer::pixels_to_clip(const Viewport& v) {
  const dvec3 origin = clip_of(sample_of({0, 0}, v), v);
  const dvec3 one = clip_of(sample_of({1, 1}, v), v) - origin;
  glm::dmat4 m(1);
  m[0][0] = one.x;
  m[1][1] = one.y;
  m[3] = {origin.x, origin.y, 0, 1};
  return m;
}

void OverlayDrawer::draw(const Annotations& annotations, const Viewport& viewport,
                         const TextColors& colors, Program& lines, ColormapTextures& colormaps) {
  glDisable(GL_DEPTH_TEST);
  if (!corners_) corners_ = make_name<GlVertexArray>(glGenVertexArrays);
  draw_bars(annotations, viewport, colormaps);
  draw_strokes(annotations, viewport, lines);
  if (colors.rim) draw_texts(annotations, viewport, *colors.rim, &Letters::rim);
  draw_texts(annotations, viewport, colors.ink, &Letters::ink);
  glEnable(GL_DEPTH_TEST);
}

void OverlayDrawer::draw_bars(const Annotations& annotations, const Viewport& viewport,
                              ColormapTextures& colormaps) {
  if (annotations.bars.empty()) return;
  if (!bar_program_) bar_program_.emplace(make_program("color_bar.frag.glsl"));
  bar_program_->use();
  bar_program_->set_texture("colormap", 0);
  glBindVertexArray(corners_->get());
  for (const ColorBar& bar : annotations.bars) {
    colormaps.bind(bar.colormap);
    const dvec2 low = sample_of(bar.upper_left + dvec2(0, bar.size.y), viewport);
    const dvec2 high = sample_of(bar.upper_left + dvec2(bar.size.x, 0), viewport);
    bar_program_->set("bottom", low.y);
    bar_program_->set("height", high.y - low.y);
    draw_rectangle(*bar_program_, low, high, viewport);
  }
}

void OverlayDrawer::draw_strokes(const Annotations& annotations, const Viewport& viewport,
                                 Program& lines) {
  if (annotations.strokes.empty()) return;
  std::vector<std::array<dvec3, 2>> lines_in_space;
  for (const auto& [a, b] : annotations.strokes) {
    lines_in_space.push_back({dvec3(a, 0), dvec3(b, 0)});
  }
  const GpuMesh strokes(mesh_of_lines(lines_in_space));
  glm::dmat4 model_to_clip = pixels_to_clip(viewport);
  model_to_clip[3] = model_to_clip * glm::dvec4(strokes.frame().centre, 1);
  for (int column = 0; column < 3; ++column) model_to_clip[column] *= strokes.frame().sides[column];
  lines.use();
  lines.set("model_to_clip", model_to_clip);
  lines.check_all_set();
  const double width = fit_line_width(viewport.size()) * viewport.per_side;
  set_line_width(std::max(1, static_cast<int>(std::lround(width))));
  strokes.draw_lines();
}

const OverlayDrawer::Letters& OverlayDrawer::letters(const std::string& text, double size) {
  const std::pair key(text, static_cast<int>(std::lround(size)));
  const auto known = letters_.find(key);
  if (known != letters_.end()) return known->second;
  if (letters_.size() >= kMostTexts) letters_.clear();
  const TextBitmap ink = font_.draw(text, key.second);
  const int rim = std::max(1, static_cast<int>(std::lround(kLetterRim * key.second)));
  return letters_.emplace(key, Letters{stencil(ink), stencil(rim_of(ink, rim))}).first->second;
}

OverlayDrawer::Stencil OverlayDrawer::stencil(const TextBitmap& bitmap) {
  Stencil made{make_name<GlTexture>(glGenTextures), bitmap.width, bitmap.height};
  glBindTexture(GL_TEXTURE_2D, made.texture.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, bitmap.width, bitmap.height, 0, GL_RED, GL_UNSIGNED_BYTE,
               bitmap.coverage.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return made;
}

void OverlayDrawer::draw_texts(const Annotations& annotations, const Viewport& viewport,
                               const dvec3& color, Stencil Letters::*part) {
  if (annotations.texts.empty()) return;
  if (!text_program_) text_program_.emplace(make_program("text.frag.glsl"));
  glActiveTexture(GL_TEXTURE0);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  text_program_->use();
  text_program_->set("ink", color);
  text_program_->set_texture("letters", 0);
  glBindVertexArray(corners_->get());
  for (const WrittenText& text : annotations.texts) {
    const Stencil& drawn = letters(text.text, text.size * viewport.per_side).*part;
    glBindTexture(GL_TEXTURE_2D, drawn.texture.get());
    const dvec2 extent(drawn.width, drawn.height);
    const dvec2 middle = sample_of(text.middle, viewport);
    // Rounded alike in all tiles, also left of them.
    const dvec2 corner(std::floor(middle.x - extent.x / 2 + 0.5),
                       std::floor(middle.y + extent.y / 2 + 0.5));
    text_program_->set("corner", dvec3(corner, 0));
    draw_rectangle(*text_program_, {corner.x, corner.y - extent.y}, {corner.x + extent.x, corner.y},
                   viewport);
  }
  glDisable(GL_BLEND);
}

}  // namespace saddle
