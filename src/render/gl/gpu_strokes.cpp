#include "render/gl/gpu_strokes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "render/gl/program.h"

namespace saddle {

GpuStrokes::GpuStrokes(const Mesh& mesh)
    : array_(make_name<GlVertexArray>(glGenVertexArrays)),
      pieces_(make_name<GlBuffer>(glGenBuffers)) {
  const ModelFrame frame = model_frame(mesh.bounds);
  const auto model = [&](std::uint32_t corner) {
    return glm::vec3((mesh.position[corner] - frame.centre) / frame.size);
  };
  std::vector<std::array<glm::vec3, 2>> pieces;
  for (const auto& line : mesh.lines) {
    if (line.size() == 1) pieces.push_back({model(line[0]), model(line[0])});
    for (std::size_t i = 1; i < line.size(); ++i) {
      pieces.push_back({model(line[i - 1]), model(line[i])});
    }
  }
  count_ = static_cast<GLsizei>(pieces.size());
  glBindVertexArray(array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, pieces_.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(pieces.size() * sizeof(pieces[0])),
               pieces.data(), GL_STATIC_DRAW);
  const auto attribute = [](GLuint location, std::size_t offset) {
    glEnableVertexAttribArray(location);
    // GL takes an offset into the buffer as a pointer.
    const void* start = reinterpret_cast<const void*>(offset);
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(glm::vec3), start);
    glVertexAttribDivisor(location, 1);
  };
  attribute(kPosition, 0);
  attribute(kFarEnd, sizeof(glm::vec3));
}

void GpuStrokes::draw() const {
  glBindVertexArray(array_.get());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace saddle
