// See-through surfaces, layer by layer: the nearest of them at each sample, then the nearest behind
// that, until a layer is empty. So the order of triangles does not matter, and surfaces may overlap
// each other and themselves.
// Source: C. Everitt, "Interactive order-independent transparency", 2001.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

#include "render/gl/gl.h"
#include "render/gl/program.h"

namespace saddle {

/// Layers behind each other that are drawn, at the most: each is a picture of its own.
inline constexpr std::size_t kMostLayers = 1000;

/// Many layers take long: a window may be asked for something else meanwhile.
struct Interruption {
  std::function<bool()> is_wanted;  ///< asked before each layer but the first; empty: never
  bool is_end = false;              ///< of the picture, without the layers behind; else a pause
  bool is_over = false;             ///< the last call has paused: go on with the same picture
};

/// Needs a current context. Scissors hold for layers, too.
class Layers {
 public:
  Layers();

  /// Layers have `width` x `height` samples from now on; buffers that are larger stay. Throws Error
  /// (Machine) if OpenGL cannot draw into as much.
  void fit(int width, int height);

  /// Draws the surfaces with the program of peel(), which tells layers apart; and with their own,
  /// lit, where the depth of the layer at hand is: its colour, and as alpha its opacity.
  struct Surfaces {
    std::function<void(Program& peel)> peel;
    std::function<void()> shade;
    double least_opacity = 0;   ///< of any of them; more than 0
    std::size_t triangles = 0;  ///< of all of them
    Interruption interruption = {};
  };

  /// Puts the layers over what the bound framebuffer holds, which must have a depth of 24 bits.
  /// Returns how many it has drawn if some behind them, which would be seen, are left out: it draws
  /// up to kMostLayers, the fewer the more triangles there are. Else 0. Nothing: it has paused, and
  /// the bound framebuffer is as before.
  std::optional<std::size_t> draw(const Surfaces& surfaces);

 private:
  void make_buffers();
  void attach_all(const GlFramebuffer& framebuffer, const GlTexture& texture) const;
  /// From there to the bound framebuffer.
  void copy(GLuint framebuffer, GLbitfield what) const;
  bool find_layer(std::size_t number, GLuint framebuffer, const Surfaces& surfaces);
  void shade_layer(const Surfaces& surfaces);
  void put_under();
  void put_over(GLuint framebuffer);

  int width_ = 0;
  int height_ = 0;
  int most_width_ = 0;  ///< that there is room for
  int most_height_ = 0;
  GlTexture color_;                 ///< of a layer, with its opacity
  GlTexture front_;                 ///< of the layers so far, multiplied by their opacity
  std::array<GlTexture, 2> depth_;  ///< of a layer and the one before, in turns
  GlRenderbuffer nearest_;          ///< for the depth test
  std::array<GlFramebuffer, 2> depth_buffers_;
  GlFramebuffer color_buffer_;
  GlFramebuffer front_buffer_;
  GlVertexArray no_vertices_;
  GlQuery drawn_;
  std::size_t count_ = 0;  ///< of the layers of this picture so far
  Program peel_;
  Program under_;
  Program over_;
};

}  // namespace saddle
