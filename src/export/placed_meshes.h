// Meshes where files have them, once for each node that shows them; nothing is copied.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "export/content.h"
#include "mesh/model/mesh.h"
#include "scene/model/color_scale.h"
#include "scene/model/scene.h"

namespace saddle {

/// From a mesh's own coordinates to those of a file; affine.
class Placement {
 public:
  Placement() = default;
  explicit Placement(const glm::dmat4& to_file);

  dvec3 point(const dvec3& p) const { return is_identity_ ? p : matrix_ * p + offset_; }
  /// Unit; of a unit normal.
  dvec3 normal(const dvec3& n) const;
  /// With the winding that keeps the front in front.
  Triangle triangle(Triangle t) const {
    if (is_mirror_) std::swap(t[1], t[2]);
    return t;
  }

 private:
  glm::dmat3 matrix_{1};
  dvec3 offset_{0};
  glm::dmat3 normals_{1};
  bool is_identity_ = true;
  bool is_mirror_ = false;
};

/// A surface's mesh in one of its places. It refers to the mesh and to the scene.
struct ExportedMesh {
  const Mesh* mesh = nullptr;
  Placement place = {};
  const SurfaceSpec* spec = nullptr;
  std::size_t surface = 0;               ///< its number in the scene
  std::string name = "surface";          ///< no other has it
  std::optional<ColorScale> scale = {};  ///< of its colours
  std::size_t row = 0;                   ///< that scale's number
  bool is_line = false;                  ///< a curve or point without triangles

  dvec3 point(std::size_t corner) const { return place.point(mesh->position[corner]); }
  dvec3 normal(std::size_t corner) const { return place.normal(mesh->normal[corner]); }
  Triangle triangle(std::size_t t) const { return place.triangle(mesh->triangles[t]); }
  /// The triangle has no number to be coloured by.
  bool is_undefined(std::size_t t) const;
  /// Where a corner's number is on the scale, 0 to 1; 0 if it has none.
  double place_of(std::size_t corner) const;
};

/// It stands for a curve or point without a radius, which has no triangles.
bool is_line(const Scene& scene, std::span<const Mesh> meshes, std::size_t surface);

/// All that is there to write, in the order of the scene's instances. Without meshes that are
/// empty.
std::vector<ExportedMesh> placed_meshes(const MeshContent& content);

/// The scales of the colours that the scene's meshes have.
std::vector<ColorScale> scales_of(const Scene& scene, std::span<const Mesh> meshes);

/// The turn from the scene's coordinates to those with the y axis up, and the factor.
glm::dmat4 to_file(const MeshContent& content);

/// A box around all of it. `lines`: curves and points included.
Bounds bounds_of(std::span<const ExportedMesh> placed, bool lines);

/// The largest rounding of positions to floats, as a share of the box's diagonal; infinite beyond
/// the range of floats.
double float_rounding(std::span<const ExportedMesh> placed);

/// Rounding of positions to float beyond this share of the diagonal makes numbers doubles where a
/// format has them: a tenth of the finest tolerance that meshes are asked for.
inline constexpr double kFloatRounding = 1e-7;

using Rgb = std::array<std::uint8_t, 3>;

/// Colours of 0 to 1 in bytes.
Rgb bytes_of(const dvec3& color);

/// Throws Error (Input) if numbers do not fit into floats. `format`: its name in the message.
void check_floats(std::span<const ExportedMesh> placed, const std::string& format);

}  // namespace saddle
