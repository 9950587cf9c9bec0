#include "render/gl/gpu_strokes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "render/gl/model_frame.h"
#include "render/gl/program.h"

namespace saddle {

GpuStrokes::GpuStrokes(const Lines& lines, std::span<const dvec3> positions,
                       std::span<const dvec3> behind, const Bounds& bounds)
    : array_(make_name<GlVertexArray>(glGenVertexArrays)),
      pieces_(make_name<GlBuffer>(glGenBuffers)) {
  const ModelFrame frame = model_frame(bounds);
  const auto model = [&](const dvec3& p) { return glm::vec3((p - frame.centre) / frame.sides); };
  struct End {
    glm::vec3 position, behind;
  };
  const auto end_at = [&](std::uint32_t i) { return End{model(positions[i]), model(behind[i])}; };
  std::vector<std::array<End, 2>> pieces;
  for (const auto& line : lines) {
    if (line.size() == 1) pieces.push_back({end_at(line[0]), end_at(line[0])});
    for (std::size_t i = 1; i < line.size(); ++i) {
      pieces.push_back({end_at(line[i - 1]), end_at(line[i])});
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
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(End), start);
    glVertexAttribDivisor(location, 1);
  };
  attribute(kPosition, offsetof(End, position));
  attribute(kOnMesh, offsetof(End, behind));
  attribute(kFarEnd, sizeof(End) + offsetof(End, position));
  attribute(kFarOnMesh, sizeof(End) + offsetof(End, behind));
}

void GpuStrokes::draw() const {
  glBindVertexArray(array_.get());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace saddle
