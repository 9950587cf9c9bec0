#include "export/placed_meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <glm/matrix.hpp>

#include "base/error.h"
#include "scene/model/instances.h"

namespace saddle {
namespace {

/// The name, or the first of "name-2", "name-3" ... that is free.
std::string free_of(const std::string& name, std::set<std::string>& taken) {
  std::string result = name;
  for (int i = 2; !taken.insert(result).second; ++i) result = name + "-" + std::to_string(i);
  return result;
}

}  // namespace

Placement::Placement(const glm::dmat4& to_file)
    : matrix_(to_file),
      offset_(to_file[3]),
      normals_(normal_matrix(matrix_)),
      is_identity_(to_file == glm::dmat4(1)),
      is_mirror_(glm::determinant(matrix_) < 0) {}

dvec3 Placement::normal(const dvec3& n) const {
  if (is_identity_) return n;
  const dvec3 turned = normals_ * n;
  const double length = glm::length(turned);
  return length > 0 ? turned / length : n;
}

bool ExportedMesh::is_undefined(std::size_t t) const {
  return scale && std::isnan(mesh->color[mesh->triangles[t][0]]);
}

double ExportedMesh::place_of(std::size_t corner) const {
  const double place = place_on(*scale, mesh->color[corner]);
  return std::isnan(place) ? 0 : std::clamp(place, 0.0, 1.0);
}

bool is_line(const Scene& scene, std::span<const Mesh> meshes, std::size_t surface) {
  return scene.surfaces[surface].is_stroke() && meshes[surface].triangles.empty();
}

std::vector<ColorScale> scales_of(const Scene& scene, std::span<const Mesh> meshes) {
  std::vector<std::optional<ColorRange>> ranges;
  for (const Mesh& mesh : meshes) ranges.push_back(color_range_of(mesh));
  return color_scales(scene, ranges);
}

glm::dmat4 to_file(const MeshContent& content) {
  const double f = content.factor;
  if (!content.y_up) return glm::dmat4(glm::dmat3(f));
  return glm::dmat4(glm::dmat3({f, 0, 0}, {0, 0, -f}, {0, f, 0}));
}

std::vector<ExportedMesh> placed_meshes(const MeshContent& content) {
  const Scene& scene = content.scene;
  const std::vector<ColorScale> scales = scales_of(scene, content.meshes);
  const glm::dmat4 last = to_file(content);
  std::vector<ExportedMesh> result;
  std::set<std::string> taken;
  for (const Instance& instance : instances(scene, World::True)) {
    const std::size_t i = instance.surface;
    const Mesh& mesh = content.meshes[i];
    if (mesh.triangles.empty() && !scene.surfaces[i].is_stroke()) continue;
    if (mesh.position.empty()) continue;
    ExportedMesh& placed = result.emplace_back();
    placed.mesh = &mesh;
    placed.place = Placement(last * instance.to_world);
    placed.spec = &scene.surfaces[i];
    placed.surface = i;
    placed.name = free_of(placed.spec->name, taken);
    placed.is_line = is_line(scene, content.meshes, i);
    if (mesh.color.empty() || scales.empty()) continue;
    const ColorScale& scale = scale_of(*placed.spec, scales);
    placed.scale = scale;
    placed.row = static_cast<std::size_t>(&scale - scales.data());
  }
  return result;
}

Bounds bounds_of(std::span<const ExportedMesh> placed, bool lines) {
  Bounds bounds;
  for (const ExportedMesh& one : placed) {
    if (one.is_line && !lines) continue;
    for (std::size_t i = 0; i < one.mesh->position.size(); ++i) bounds.add(one.point(i));
  }
  return bounds;
}

double float_rounding(std::span<const ExportedMesh> placed) {
  Bounds bounds;
  double worst = 0;
  for (const ExportedMesh& one : placed) {
    if (one.is_line) continue;
    for (std::size_t i = 0; i < one.mesh->position.size(); ++i) {
      const dvec3 p = one.point(i);
      bounds.add(p);
      for (int k = 0; k < 3; ++k) {
        worst = std::max(worst, std::abs(p[k] - static_cast<double>(static_cast<float>(p[k]))));
      }
    }
  }
  // Beyond the range of floats the rounding is infinite, and squares of the diagonal may be too.
  if (std::isinf(worst)) return worst;
  const double diagonal = bounds.diagonal();
  return worst > 0 ? worst / diagonal : 0;
}

Rgb bytes_of(const dvec3& color) {
  Rgb rgb{};
  for (int k = 0; k < 3; ++k) {
    const double channel = std::clamp(color[k], 0.0, 1.0);
    rgb[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(255 * channel));
  }
  return rgb;
}

void check_floats(std::span<const ExportedMesh> placed, const std::string& format) {
  const Bounds bounds = bounds_of(placed, true);
  const double largest =
      std::max(largest_of(glm::abs(bounds.low)), largest_of(glm::abs(bounds.high)));
  // Differences of positions fit, too.
  const double most = static_cast<double>(std::numeric_limits<float>::max()) / 4;
  if (bounds.empty() || largest <= most) return;
  throw Error(Status::Input, "the mesh is too large for the numbers of " + format + " files", {},
              "PLY and OBJ have doubles: -o mesh.ply");
}

}  // namespace saddle
