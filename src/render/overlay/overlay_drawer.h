// Draws annotations on top of a picture that is drawn: lines, colour bars, letters.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include <glm/mat4x4.hpp>

#include "render/gl/gl.h"
#include "render/gl/program.h"
#include "render/gl/viewport.h"
#include "render/overlay/annotations.h"
#include "render/shading/colormap_textures.h"

namespace saddle {

/// Needs the same current context from the first to the last of its calls.
class OverlayDrawer {
 public:
  /// Colours of letters and of their rims; without one they have none.
  struct TextColors {
    dvec3 ink{0, 0, 0};
    std::optional<dvec3> rim;
  };

  /// Everything but the box, which needs the surfaces' depths. `lines` draws lines, its colour set.
  void draw(const Annotations& annotations, const Viewport& viewport, const TextColors& colors,
            Program& lines, ColormapTextures& colormaps);

  /// From pixels of the whole picture to clip coordinates of a part of it.
  static glm::dmat4 pixels_to_clip(const Viewport& viewport);

 private:
  /// Letters, or the rims of letters, as shares of samples.
  struct Stencil {
    GlTexture texture;
    int width = 0;
    int height = 0;
  };
  struct Letters {
    Stencil ink, rim;
  };

  const Letters& letters(const std::string& text, double size);
  void draw_bars(const Annotations& annotations, const Viewport& viewport,
                 ColormapTextures& colormaps);
  void draw_strokes(const Annotations& annotations, const Viewport& viewport, Program& lines);
  static Stencil stencil(const TextBitmap& bitmap);
  void draw_texts(const Annotations& annotations, const Viewport& viewport, const dvec3& color,
                  Stencil Letters::*part);

  Font font_;
  std::map<std::pair<std::string, int>, Letters> letters_;  ///< by text and size in samples
  std::optional<Program> text_program_;
  std::optional<Program> bar_program_;
  std::optional<GlVertexArray> corners_;
};

}  // namespace saddle
