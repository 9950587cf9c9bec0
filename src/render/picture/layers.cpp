#include "render/picture/layers.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/activity.h"
#include "base/error.h"
#include "render/shading/shader_text.h"
#include "render/shading/shaders.h"

namespace saddle {
namespace {

/// Half a step of 8 bits.
constexpr double kInvisible = 1.0 / 512;

/// Behind everything.
constexpr std::array<GLfloat, 4> kNothing = {2, 2, 2, 2};
/// In front of everything.
constexpr std::array<GLfloat, 4> kBeforeAll = {-1, -1, -1, -1};
constexpr std::array<GLfloat, 4> kClear = {0, 0, 0, 0};

/// Half floats: an opacity has 11 bits however small it is, so that many layers of little opacity
/// add up rightly; and so do lights of several passes, beyond white.
constexpr GLint kColorFormat = GL_RGBA16F;

GlTexture make_texture(GLint format, int width, int height) {
  GlTexture texture = make_name<GlTexture>(glGenTextures);
  glBindTexture(GL_TEXTURE_2D, texture.get());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RED, GL_FLOAT, nullptr);
  return texture;
}

/// Binds it, too.
void clear(const GlFramebuffer& framebuffer, const std::array<GLfloat, 4>& color) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glClearBufferfv(GL_COLOR, 0, color.data());
}

void bind_texture(GLenum unit, const GlTexture& texture) {
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, texture.get());
}

Program layer_program(const std::vector<std::string>& names) {
  return {std::string(shader_source("layer.vert.glsl")),
          keep_defined(std::string(shader_source("layer.frag.glsl")), names)};
}

/// Layers behind which nothing is seen, if each lets 1 - `least_opacity` of the light through.
std::size_t layers_seen(double least_opacity) {
  constexpr double kMost = 1e9;  // of a surface that is almost not there
  const double layers = std::ceil(std::log(kInvisible) / std::log1p(-least_opacity));
  return static_cast<std::size_t>(std::min(layers, kMost));
}

/// Triangles of all layers together. A layer draws each twice; with llvmpipe that takes 6
/// microseconds, so that the layers of a picture take 20 seconds of a processor at the most.
constexpr std::size_t kMostDrawn = 3'000'000;
/// Samples that a layer fills in the time of a triangle.
constexpr std::size_t kSamplesOfTriangle = 200;
/// However many triangles there are: a front and a back.
constexpr std::size_t kLeastLayers = 2;

/// Layers that a picture is worth. It does not depend on time: a picture is the same anywhere.
std::size_t layers_worth(std::size_t triangles, int width, int height) {
  const auto samples = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::size_t cost = triangles + samples / kSamplesOfTriangle + 1;
  return std::clamp(kMostDrawn / cost, kLeastLayers, kMostLayers);
}

}  // namespace

Layers::Layers()
    : nearest_(make_name<GlRenderbuffer>(glGenRenderbuffers)),
      depth_buffers_{make_name<GlFramebuffer>(glGenFramebuffers),
                     make_name<GlFramebuffer>(glGenFramebuffers)},
      color_buffer_(make_name<GlFramebuffer>(glGenFramebuffers)),
      front_buffer_(make_name<GlFramebuffer>(glGenFramebuffers)),
      no_vertices_(make_name<GlVertexArray>(glGenVertexArrays)),
      drawn_(make_name<GlQuery>(glGenQueries)),
      peel_(std::string(shader_source("unlit.vert.glsl")),
            std::string(shader_source("peel.frag.glsl"))),
      under_(layer_program({})),
      over_(layer_program({"LAST"})) {}

void Layers::fit(int width, int height) {
  width_ = width;
  height_ = height;
  if (width <= most_width_ && height <= most_height_) return;
  most_width_ = std::max(width, most_width_);
  most_height_ = std::max(height, most_height_);
  make_buffers();
}

void Layers::make_buffers() {
  const auto texture = [&](GLint format) {
    return make_texture(format, most_width_, most_height_);
  };
  // First the old ones: there need not be memory for both.
  for (GlTexture* old : {&color_, &front_, &depth_[0], &depth_[1]}) *old = GlTexture();
  color_ = texture(kColorFormat);
  front_ = texture(kColorFormat);
  depth_ = {texture(GL_R32F), texture(GL_R32F)};
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glBindRenderbuffer(GL_RENDERBUFFER, nearest_.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, most_width_, most_height_);
  attach_all(depth_buffers_[0], depth_[0]);
  attach_all(depth_buffers_[1], depth_[1]);
  attach_all(color_buffer_, color_);
  attach_all(front_buffer_, front_);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
}

void Layers::attach_all(const GlFramebuffer& framebuffer, const GlTexture& texture) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.get(), 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, nearest_.get());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
  throw Error(Status::Machine,
              "OpenGL cannot draw see-through surfaces into " + std::to_string(most_width_) + "x" +
                  std::to_string(most_height_) + " samples",
              {}, "try a smaller --size, --antialias 1 or --opacity 1");
}

std::optional<std::size_t> Layers::draw(const Surfaces& surfaces) {
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  const auto framebuffer = static_cast<GLuint>(bound);
  const Interruption& interruption = surfaces.interruption;
  if (!interruption.is_over) {
    clear(front_buffer_, kClear);
    clear(depth_buffers_[1], kBeforeAll);
    count_ = 0;
  }
  const std::size_t seen = layers_seen(surfaces.least_opacity);
  const std::size_t most = std::min(seen, layers_worth(surfaces.triangles, width_, height_));
  bool is_interrupted = false;
  while (!is_interrupted && count_ < most && find_layer(count_, framebuffer, surfaces)) {
    shade_layer(surfaces);
    put_under();
    ++count_;
    tell_share(static_cast<double>(count_) / static_cast<double>(most));
    is_interrupted = interruption.is_wanted && interruption.is_wanted();
  }
  if (is_interrupted && !interruption.is_end) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    return std::nullopt;
  }
  const bool is_cut = count_ == most && most < seen && find_layer(count_, framebuffer, surfaces);
  put_over(framebuffer);
  return is_cut ? count_ : 0;
}

/// Everything that hides is in the depth buffer. Returns false if there is no layer any more.
bool Layers::find_layer(std::size_t number, GLuint framebuffer, const Surfaces& surfaces) {
  const std::size_t own = number % 2;
  clear(depth_buffers_[own], kNothing);
  copy(framebuffer, GL_DEPTH_BUFFER_BIT);
  bind_texture(GL_TEXTURE0, depth_[1 - own]);
  peel_.use();
  peel_.set_texture("last_depth", 0);
  glBeginQuery(GL_ANY_SAMPLES_PASSED, drawn_.get());
  surfaces.peel(peel_);
  glEndQuery(GL_ANY_SAMPLES_PASSED);
  GLuint is_drawn = GL_FALSE;
  glGetQueryObjectuiv(drawn_.get(), GL_QUERY_RESULT, &is_drawn);
  return is_drawn == GL_TRUE;
}

void Layers::shade_layer(const Surfaces& surfaces) {
  clear(color_buffer_, kClear);
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
  surfaces.shade();
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
}

void Layers::copy(GLuint framebuffer, GLbitfield what) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, what, GL_NEAREST);
}

void Layers::put_under() {
  glBindFramebuffer(GL_FRAMEBUFFER, front_buffer_.get());
  bind_texture(GL_TEXTURE0, color_);
  under_.use();
  under_.set_texture("layer", 0);
  under_.check_all_set();
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
}

/// The picture of the opaque surfaces is copied for the shader to read: its alpha is not multiplied
/// into its colours, as blending would need.
void Layers::put_over(GLuint framebuffer) {
  glBindFramebuffer(GL_FRAMEBUFFER, color_buffer_.get());
  copy(framebuffer, GL_COLOR_BUFFER_BIT);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  bind_texture(GL_TEXTURE1, front_);
  bind_texture(GL_TEXTURE0, color_);
  over_.use();
  over_.set_texture("layer", 0);
  over_.set_texture("front", 1);
  over_.check_all_set();
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace saddle
