#include "conformance/float_grid.h"

#include <gtest/gtest.h>

#include "render/gl/gl.h"
#include "render/gl/program.h"
#include "render/shading/shaders.h"

namespace saddle::testing {
namespace {

constexpr const char* kVertexShader = R"(#version 330 core
void main() {  // a triangle that covers everything
  gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1);
}
)";

std::string fragment_shader(const std::string& code) {
  return "#version 330 core\n" + std::string(shader_source("functions.glsl")) + R"(
uniform sampler2D arguments;
out vec4 results;
void main() {
  vec4 at = texelFetch(arguments, ivec2(gl_FragCoord.x, 0), 0);
  float u = at.x;
  float v = at.y;
  float x = 0.0;
  float y = 0.0;
  float z = 0.0;
)" + code +
         "  results = vec4(x, y, z, 1.0);\n}\n";
}

/// A row of RGBA32F texels.
GlTexture make_texture(const std::vector<std::array<float, 4>>& texels) {
  GlTexture texture = make_name<GlTexture>(glGenTextures);
  glBindTexture(GL_TEXTURE_2D, texture.get());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(texels.size()), 1, 0, GL_RGBA,
               GL_FLOAT, texels.data());
  return texture;
}

std::vector<std::array<float, 4>> draw(GLsizei width) {
  std::vector<std::array<float, 4>> pixels(width);
  const GlTexture target = make_texture(pixels);
  const GlFramebuffer framebuffer = make_name<GlFramebuffer>(glGenFramebuffers);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.get(), 0);
  EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  const GlVertexArray nothing = make_name<GlVertexArray>(glGenVertexArrays);
  glBindVertexArray(nothing.get());
  glViewport(0, 0, width, 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glReadPixels(0, 0, width, 1, GL_RGBA, GL_FLOAT, pixels.data());
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  return pixels;
}

}  // namespace

std::vector<std::array<float, 3>> run_glsl(const std::string& code,
                                           const std::vector<Arguments>& arguments) {
  const Program program(kVertexShader, fragment_shader(code));
  program.use();
  std::vector<std::array<float, 4>> texels;
  for (const auto& [a, b, c] : arguments) {
    texels.push_back({static_cast<float>(a), static_cast<float>(b), static_cast<float>(c), 0});
  }
  const GlTexture texture = make_texture(texels);
  // make_texture leaves the last texture bound to unit 0: the framebuffer's comes after it.
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, texture.get());
  glActiveTexture(GL_TEXTURE0);
  GLint id = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &id);
  glUniform1i(glGetUniformLocation(static_cast<GLuint>(id), "arguments"), 1);
  std::vector<std::array<float, 3>> results;
  for (const std::array<float, 4>& pixel : draw(static_cast<GLsizei>(texels.size()))) {
    results.push_back({pixel[0], pixel[1], pixel[2]});
  }
  return results;
}

}  // namespace saddle::testing
