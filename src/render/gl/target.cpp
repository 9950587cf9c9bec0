#include "render/gl/target.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "render/gl/average.h"

namespace saddle {
namespace {

/// Bytes that are read back at a time: they stay in the processor's cache until they are averaged,
/// and memory for a second copy of all samples is never touched.
constexpr std::size_t kBandBytes = std::size_t{256} * 1024;

void attach(const GlRenderbuffer& buffer, GLenum attachment, GLenum format, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.get());
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.get());
}

}  // namespace

Target::Target(int width, int height)
    : framebuffer_(make_name<GlFramebuffer>(glGenFramebuffers)),
      color_(make_name<GlRenderbuffer>(glGenRenderbuffers)),
      depth_(make_name<GlRenderbuffer>(glGenRenderbuffers)) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  attach(color_, GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height);
  attach(depth_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(Status::Machine,
                "OpenGL cannot draw into " + std::to_string(width) + "x" + std::to_string(height) +
                    " samples",
                {}, "try a smaller --size or --antialias 1");
  }
}

void Target::read(int x, int y, int per_side, bool opaque, const PixelRect& rect,
                  Image& image) const {
  const int width = rect.width * per_side;
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(width);
  const int rows = static_cast<int>(std::max<std::size_t>(1, kBandBytes / row_bytes / per_side));
  std::vector<std::uint8_t> band(row_bytes * std::min(rows, rect.height) * per_side);
  for (int done = 0; done < rect.height; done += rows) {
    const int height = std::min(rows, rect.height - done);
    glReadPixels(x, y + done * per_side, width, height * per_side, GL_RGBA, GL_UNSIGNED_BYTE,
                 band.data());
    const PixelRect part{rect.x, rect.y + rect.height - done - height, rect.width, height};
    average_samples({band.data(), row_bytes, per_side, opaque}, part, image);
  }
}

}  // namespace saddle
