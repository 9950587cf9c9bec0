#include "render/gl/gpu_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "mesh/model/hidden_back.h"

namespace saddle {
namespace {

struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
};

/// Stands for no number.
constexpr float kUndefined = -1;

/// The unit normal in a frame whose sides differ by `to_model`. Where they differ much, squares of
/// its components would be less than any double.
dvec3 model_normal(const dvec3& normal, const dvec3& to_model) {
  const dvec3 n = normal * to_model;
  return glm::normalize(n / largest_of(glm::abs(n)));
}

/// Converts straight into the buffer's memory: no second copy of the vertices.
void upload_vertices(const Mesh& mesh, const ModelFrame& frame) {
  const std::size_t count = mesh.position.size();
  if (count == 0) return;
  const auto bytes = static_cast<GLsizeiptr>(count * sizeof(Vertex));
  glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STATIC_DRAW);
  auto* vertices = static_cast<Vertex*>(
      glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT));
  if (vertices == nullptr) throw std::bad_alloc();
  const dvec3 to_model = frame.sides / frame.size;
  const bool is_plain = to_model == dvec3(1);
  for (std::size_t i = 0; i < count; ++i) {
    vertices[i].position = glm::vec3((mesh.position[i] - frame.centre) / frame.sides);
    const dvec3& n = mesh.normal[i];
    vertices[i].normal = glm::vec3(is_plain ? n : model_normal(n, to_model));
  }
  glUnmapBuffer(GL_ARRAY_BUFFER);
}

void describe_vertices() {
  const auto attribute = [](GLuint location, std::size_t offset) {
    glEnableVertexAttribArray(location);
    // GL takes an offset into the buffer as a pointer.
    const void* start = reinterpret_cast<const void*>(offset);
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), start);
  };
  attribute(kPosition, offsetof(Vertex, position));
  attribute(kNormal, offsetof(Vertex, normal));
}

/// The numbers of the corners as a share of their range.
void upload_colors(const Mesh& mesh) {
  const double low = mesh.color_range.low;
  const double high = mesh.color_range.high;
  std::vector<float> shares;
  shares.reserve(mesh.color.size());
  for (const double number : mesh.color) {
    const double share = high > low ? (std::clamp(number, low, high) - low) / (high - low) : 0.5;
    shares.push_back(std::isnan(number) ? kUndefined : static_cast<float>(share));
  }
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shares.size() * sizeof(float)),
               shares.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(kColor);
  glVertexAttribPointer(kColor, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
}

/// A buffer of two floats for each corner, as an attribute of the triangles' array, which is bound.
void upload_pairs(std::span<const dvec2> pairs, Attribute attribute, const GlBuffer& buffer) {
  const std::vector<glm::vec2> rounded(pairs.begin(), pairs.end());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(rounded.size() * sizeof(glm::vec2)),
               rounded.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
}

/// The pieces of all chains. As strips with restarts between them llvmpipe would begin anew for
/// each chain. GL leaves out the last pixel of a line, so that the next one may begin there: each
/// chain goes back one step at its end.
std::vector<GLuint> line_indices_of(std::span<const std::vector<std::uint32_t>> lines) {
  std::vector<GLuint> indices;
  for (const auto& chain : lines) {
    if (chain.size() < 2) continue;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      indices.insert(indices.end(), {chain[i], chain[i + 1]});
    }
    indices.insert(indices.end(), {chain.back(), chain[chain.size() - 2]});
  }
  return indices;
}

}  // namespace

Mesh mesh_of_lines(std::span<const std::array<dvec3, 2>> lines) {
  Mesh mesh;
  for (const std::array<dvec3, 2>& line : lines) {
    const auto first = static_cast<std::uint32_t>(mesh.position.size());
    for (const dvec3& end : line) {
      mesh.position.push_back(dvec3(end));
      mesh.normal.push_back({0, 0, 1});
      mesh.bounds.add(end);
    }
    mesh.lines.push_back({first, first + 1});
  }
  return mesh;
}

bool set_line_width(int samples) {
  std::array<GLfloat, 2> range{};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
  const auto wanted = static_cast<GLfloat>(samples);
  glLineWidth(std::min(wanted, std::max(range[1], 1.0F)));
  return wanted <= range[1];
}

GpuMesh::GpuMesh(const Mesh& mesh)
    : bounds_(mesh.bounds),
      frame_(model_frame(mesh.bounds)),
      solid_(mesh.solid),
      hides_its_back_(!mesh.solid && saddle::hides_its_back(mesh)),
      triangle_array_(make_name<GlVertexArray>(glGenVertexArrays)),
      line_array_(make_name<GlVertexArray>(glGenVertexArrays)),
      vertices_(make_name<GlBuffer>(glGenBuffers)),
      triangles_(make_name<GlBuffer>(glGenBuffers)),
      lines_(make_name<GlBuffer>(glGenBuffers)),
      triangle_indices_(static_cast<GLsizei>(3 * mesh.triangles.size())) {
  assert(mesh.normal.size() == mesh.position.size());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  upload_vertices(mesh, frame_);

  glBindVertexArray(triangle_array_.get());
  describe_vertices();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.get());
  static_assert(sizeof(mesh.triangles[0]) == 3 * sizeof(GLuint));
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(mesh.triangles[0])),
               mesh.triangles.data(), GL_STATIC_DRAW);

  if (!mesh.color.empty()) {
    assert(mesh.color.size() == mesh.position.size());
    color_range_ = mesh.color_range;
    colors_ = make_name<GlBuffer>(glGenBuffers);
    glBindBuffer(GL_ARRAY_BUFFER, colors_->get());
    upload_colors(mesh);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  }

  const std::vector<GLuint> indices = line_indices_of(mesh.lines);
  line_indices_ = static_cast<GLsizei>(indices.size());
  glBindVertexArray(line_array_.get());
  describe_vertices();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, lines_.get());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
               indices.data(), GL_STATIC_DRAW);
  if (!mesh.contours.lines.empty()) {
    const MeshContours& contours = mesh.contours;
    contours_.emplace(contours.lines, contours.position, contours.on_mesh, bounds_);
  }
}

void GpuMesh::set_texture_places(std::span<const dvec2> places) {
  texture_places_.emplace(make_name<GlBuffer>(glGenBuffers));
  glBindVertexArray(triangle_array_.get());
  upload_pairs(places, kTexture, *texture_places_);
}

double GpuMesh::measure_trust(Program& program, std::span<const dvec2> uv) {
  const auto count = static_cast<GLsizei>(uv.size());
  parameters_.emplace(make_name<GlBuffer>(glGenBuffers));
  trust_.emplace(make_name<GlBuffer>(glGenBuffers));
  glBindVertexArray(triangle_array_.get());
  upload_pairs(uv, kParameters, *parameters_);

  std::vector<GLfloat> trust(uv.size());
  const auto bytes = static_cast<GLsizeiptr>(trust.size() * sizeof(GLfloat));
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, trust_->get());
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STATIC_DRAW);
  program.use();
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, count);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, trust.data());
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);

  glBindBuffer(GL_ARRAY_BUFFER, trust_->get());
  glEnableVertexAttribArray(kTrust);
  glVertexAttribPointer(kTrust, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  return std::accumulate(trust.begin(), trust.end(), 0.0) / count;
}

void GpuMesh::draw_triangles() const {
  glBindVertexArray(triangle_array_.get());
  glDrawElements(GL_TRIANGLES, triangle_indices_, GL_UNSIGNED_INT, nullptr);
}

void GpuMesh::draw_triangles(std::size_t first, std::size_t count) const {
  glBindVertexArray(triangle_array_.get());
  // GL takes an offset into the buffer as a pointer.
  const void* start = reinterpret_cast<const void*>(first * sizeof(Triangle));
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT, start);
}

void GpuMesh::draw_lines() const {
  glBindVertexArray(line_array_.get());
  glDrawElements(GL_LINES, line_indices_, GL_UNSIGNED_INT, nullptr);
}

void GpuMesh::draw_contours() const {
  if (contours_) contours_->draw();
}

}  // namespace saddle
