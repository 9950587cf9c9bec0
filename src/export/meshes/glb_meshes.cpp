#include "export/meshes/glb_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "export/meshes/glb_materials.h"
#include "export/meshes/looks.h"
#include "export/meshes/sheet_directions.h"
#include "export/meshes/solid_parts.h"
#include "mesh/model/hidden_back.h"

namespace saddle {
namespace {

using Json = GlbFile::Json;

/// Front and back sheet are so far off the surface, as shares of the box's diagonal: path tracers
/// show speckles on sheets that coincide.
constexpr double kSheetGap = 1e-5;
/// Lines are so far off: nearer ones flicker in renderers with a coarse depth buffer.
constexpr double kLineGap = 1e-3;
/// Least number of vertices that 16-bit indices cannot tell apart; their last value is reserved.
constexpr std::size_t kLongIndices = 65535;
/// Largest difference of a normal's length from 1 that is left as it is.
constexpr double kUnitRounding = 1e-6;
constexpr int kModePoints = 0;
constexpr int kModeLines = 1;

/// A unit vector, whatever the mesh has.
glm::vec3 unit(const dvec3& n) {
  const double length = glm::length(n);
  if (std::abs(length - 1) <= kUnitRounding) return glm::vec3(n);
  return length > 0 && std::isfinite(length) ? glm::vec3(n / length) : glm::vec3(0, 0, 1);
}

void put(ByteWriter& writer, const glm::vec3& v) {
  for (int k = 0; k < 3; ++k) writer.put(v[k]);
}

using PointAt = std::function<glm::vec3(std::size_t)>;

/// Vertices of a mesh or of lines, with the box around them.
std::size_t add_points(std::size_t count, const PointAt& at, GlbFile& file) {
  glm::vec3 low(std::numeric_limits<float>::infinity());
  glm::vec3 high(-low);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 p = at(i);
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const std::size_t view =
      file.add_view(12 * count, GlbTarget::Vertices, [count, at](ByteWriter& writer) {
        for (std::size_t i = 0; i < count; ++i) put(writer, at(i));
      });
  const Json limits = {{"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}};
  return file.add_accessor(view, GlbComponent::Float, count, "VEC3", limits);
}

std::size_t add_indices(std::size_t count, std::size_t vertices,
                        const std::function<void(const std::function<void(std::size_t)>&)>& each,
                        GlbFile& file) {
  const bool is_long = vertices >= kLongIndices;
  const std::size_t view = file.add_view(
      (is_long ? 4 : 2) * count, GlbTarget::Indices, [is_long, each](ByteWriter& writer) {
        each([&](std::size_t index) {
          is_long ? writer.put(static_cast<std::uint32_t>(index))
                  : writer.put(static_cast<std::uint16_t>(index));
        });
      });
  return file.add_accessor(view, is_long ? GlbComponent::U32 : GlbComponent::U16, count, "SCALAR");
}

/// Lines, or points: vertices where they are, and pairs of them, or single ones.
struct Strokes {
  std::vector<dvec3> position;
  std::vector<dvec3> normal;  ///< none: they are on no surface
  std::vector<std::uint32_t> lines;
  std::vector<std::uint32_t> points;
  Color color;
};

class MeshAdder {
 public:
  MeshAdder(const GlbSurface& surface, GlbTextures& textures, GlbFile& file)
      : surface_(surface),
        mesh_(surface.mesh),
        textures_(textures),
        file_(file),
        centre_(mesh_.bounds.centre()),
        diagonal_(mesh_.bounds.diagonal()) {}

  std::size_t add() {
    if (!mesh_.triangles.empty()) add_sheets();
    add_strokes(chain_lines());
    if (!mesh_.contours.lines.empty()) add_strokes(contour_lines());
    file_.json["meshes"].push_back({{"name", surface_.spec.name}, {"primitives", primitives_}});
    return file_.json["meshes"].size() - 1;
  }

 private:
  enum class Side { Both, Front, Back };

  void add_sheets() {
    const SurfaceSpec& spec = surface_.spec;
    add_coordinates();
    if (mesh_.solid) {
      add_solid();
      return;
    }
    hides_back_ = spec.opacity == 1 && hides_its_back(mesh_);
    if (hides_back_) {
      add_sheet(Side::Front, points());
    } else if (look_of(Side::Front) == look_of(Side::Back)) {
      add_sheet(Side::Both, points());
    } else {
      const auto directions = std::make_shared<const SheetDirections>(mesh_);
      add_sheet(Side::Front, points_off(kSheetGap, directions));
      add_sheet(Side::Back, points_off(-kSheetGap, directions));
    }
  }

  /// Each part has one side; the solid hides the other one.
  void add_solid() {
    hides_back_ = true;
    const Json attributes = attributes_of(points(), 1);
    for (const PartRange& part : parts_of(mesh_)) {
      add_part(attributes, false, part, look_with(saddle::material_of(surface_.spec, part.part)));
    }
  }

  /// The numbers in which two sides can differ.
  using Look = std::array<double, 8>;
  Look look_of(Side side) const {
    const Material& m = side == Side::Back ? surface_.spec.back : surface_.spec.front;
    const bool has_own_color = surface_.scale || surface_.spec.texture.picture;
    const Color d = has_own_color ? Color{} : m.diffuse;
    const double shine = surface_.unlit ? 0.0 : m.shininess.value;
    return {d.r, d.g, d.b, shine, m.emission.r, m.emission.g, m.emission.b, 0};
  }

  GlbMaterial look_with(const Material& material) {
    GlbMaterial look;
    look.material = material;
    look.opacity = surface_.spec.opacity;
    if (surface_.scale) look.texture = surface_.colors;
    if (!surface_.places.empty()) look.texture = textures_.add(surface_.spec.texture, material);
    look.unlit = surface_.unlit;
    return look;
  }

  GlbMaterial material_of(Side side) {
    GlbMaterial look = look_with(side == Side::Back ? surface_.spec.back : surface_.spec.front);
    look.double_sided = side == Side::Both;
    return look;
  }

  PointAt points() const {
    return [&mesh = mesh_, centre = centre_](std::size_t i) {
      return glm::vec3(mesh.position[i] - centre);
    };
  }

  /// `gap`: off the surface, as a share of the diagonal.
  PointAt points_off(double gap, const std::shared_ptr<const SheetDirections>& directions) const {
    return [&mesh = mesh_, centre = centre_, offset = gap * diagonal_, directions](std::size_t i) {
      return glm::vec3(mesh.position[i] - centre + offset * directions->at(i));
    };
  }

  std::size_t add_normals(double sign) {
    const std::size_t count = mesh_.normal.size();
    const std::size_t view = file_.add_view(12 * count, GlbTarget::Vertices,
                                            [&mesh = mesh_, sign, count](ByteWriter& writer) {
                                              for (std::size_t i = 0; i < count; ++i)
                                                put(writer, unit(sign * mesh.normal[i]));
                                            });
    return file_.add_accessor(view, GlbComponent::Float, count, "VEC3");
  }

  template <typename At>
  std::size_t add_pairs(At at) {
    const std::size_t count = mesh_.position.size();
    const std::size_t view =
        file_.add_view(8 * count, GlbTarget::Vertices, [at, count](ByteWriter& writer) {
          for (std::size_t i = 0; i < count; ++i) {
            const dvec2 pair = at(i);
            writer.put(static_cast<float>(pair.x));
            writer.put(static_cast<float>(pair.y));
          }
        });
    return file_.add_accessor(view, GlbComponent::Float, count, "VEC2");
  }

  /// Places in the picture of colours, if there is one, and the parameters as shares of their
  /// ranges, v from above. The picture's are the first: some readers know of no others. A texture
  /// has its parameters, as often as it is there.
  void add_coordinates() {
    if (!surface_.places.empty()) {
      const dvec2 across = pictures_across(surface_.spec);
      coordinates_.push_back(add_pairs([&surface = surface_, across](std::size_t i) {
        const dvec2 place = across * surface.places[i];
        return dvec2(place.x, 1 - place.y);
      }));
      return;
    }
    if (surface_.scale) {
      coordinates_.push_back(add_pairs([&surface = surface_](std::size_t i) {
        const double place = place_on(*surface.scale, surface.mesh.color[i]);
        return place_in_image(std::isnan(place) ? 0 : std::clamp(place, 0.0, 1.0), surface.row,
                              surface.rows);
      }));
    }
    dvec2 low(std::numeric_limits<double>::infinity());
    dvec2 high(-low);
    for (const dvec2& uv : mesh_.uv) {
      low = glm::min(low, uv);
      high = glm::max(high, uv);
    }
    const dvec2 size(high.x > low.x ? high.x - low.x : 1, high.y > low.y ? high.y - low.y : 1);
    coordinates_.push_back(add_pairs([&mesh = mesh_, low, size](std::size_t i) {
      const dvec2 share = (mesh.uv[i] - low) / size;
      return dvec2(share.x, 1 - share.y);
    }));
  }

  bool is_undefined(const Triangle& t) const {
    return surface_.scale && std::isnan(mesh_.color[t[0]]);
  }

  void add_sheet(Side side, const PointAt& at) {
    const bool is_back = side == Side::Back;
    const PartRange all{SolidPart::Front, 0, mesh_.triangles.size()};
    add_part(attributes_of(at, is_back ? -1 : 1), is_back, all, material_of(side));
  }

  /// `sign`: of the normals.
  Json attributes_of(const PointAt& at, double sign) {
    Json attributes = {{"POSITION", add_points(mesh_.position.size(), at, file_)},
                       {"NORMAL", add_normals(sign)}};
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      attributes["TEXCOORD_" + std::to_string(i)] = coordinates_[i];
    }
    return attributes;
  }

  void add_part(const Json& attributes, bool reversed, const PartRange& part,
                const GlbMaterial& look) {
    add_triangles(attributes, reversed, false, part, look);
    GlbMaterial grey = look;
    grey.texture.reset();
    grey.material.diffuse = {kUndefinedGrey, kUndefinedGrey, kUndefinedGrey};
    if (surface_.scale) add_triangles(attributes, reversed, true, part, grey);
  }

  /// Adds those triangles of a part that have a number to be coloured by, or the others.
  void add_triangles(const Json& attributes, bool reversed, bool undefined, const PartRange& part,
                     const GlbMaterial& material) {
    const auto belongs = [this, undefined](const Triangle& t) {
      return is_undefined(t) == undefined;
    };
    const std::span triangles(mesh_.triangles.data() + part.first, part.count);
    const auto count = static_cast<std::size_t>(std::ranges::count_if(triangles, belongs));
    if (count == 0) return;
    const GlbSurface& surface = surface_;
    const auto each = [&surface, triangles, reversed, undefined](const auto& take) {
      const Mesh& mesh = surface.mesh;
      for (const Triangle& t : triangles) {
        const bool is_undefined = surface.scale && std::isnan(mesh.color[t[0]]);
        if (is_undefined != undefined) continue;
        take(t[0]);
        take(t[reversed ? 2 : 1]);
        take(t[reversed ? 1 : 2]);
      }
    };
    primitives_.push_back({{"attributes", attributes},
                           {"indices", add_indices(3 * count, mesh_.position.size(), each, file_)},
                           {"material", add_material(material, file_)}});
  }

  /// Grid lines, or the curve or point that the surface stands for.
  Strokes chain_lines() const {
    Strokes strokes;
    strokes.color = surface_.spec.line_color;
    for (const std::vector<std::uint32_t>& chain : mesh_.lines) {
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const auto vertex = static_cast<std::uint32_t>(strokes.position.size());
        strokes.position.push_back(mesh_.position[chain[i]]);
        if (!mesh_.triangles.empty()) strokes.normal.push_back(mesh_.normal[chain[i]]);
        if (chain.size() == 1) strokes.points.push_back(vertex);
        if (i > 0) strokes.lines.insert(strokes.lines.end(), {vertex - 1, vertex});
      }
    }
    return strokes;
  }

  Strokes contour_lines() const {
    Strokes strokes;
    strokes.color = surface_.contours;
    strokes.position = mesh_.contours.on_mesh;
    strokes.normal = mesh_.contours.normal;
    for (const std::vector<std::uint32_t>& chain : mesh_.contours.lines) {
      for (std::size_t i = 1; i < chain.size(); ++i) {
        strokes.lines.insert(strokes.lines.end(), {chain[i - 1], chain[i]});
      }
    }
    return strokes;
  }

  void add_strokes(Strokes strokes) {
    if (strokes.position.empty()) return;
    const auto kept = std::make_shared<const Strokes>(std::move(strokes));
    const bool on_surface = !kept->normal.empty();
    add_copy(kept, on_surface ? kLineGap : 0);
    if (on_surface && !hides_back_) add_copy(kept, -kLineGap);
  }

  void add_copy(const std::shared_ptr<const Strokes>& strokes, double gap) {
    const double offset = gap * diagonal_;
    const auto at = [strokes, offset, centre = centre_](std::size_t i) {
      const dvec3 p = strokes->position[i] - centre;
      return glm::vec3(offset == 0 ? p : p + offset * strokes->normal[i]);
    };
    const std::size_t vertices = strokes->position.size();
    const Json attributes = {{"POSITION", add_points(vertices, at, file_)}};
    const std::size_t material = add_material(plain_look(strokes->color), file_);
    const auto add_kind = [&](const std::vector<std::uint32_t>& indices, int mode) {
      if (indices.empty()) return;
      const auto each = [strokes, &indices](const auto& take) {
        for (const std::uint32_t index : indices) take(index);
      };
      primitives_.push_back({{"attributes", attributes},
                             {"indices", add_indices(indices.size(), vertices, each, file_)},
                             {"material", material},
                             {"mode", mode}});
    };
    add_kind(strokes->lines, kModeLines);
    add_kind(strokes->points, kModePoints);
  }

  const GlbSurface& surface_;
  const Mesh& mesh_;
  GlbTextures& textures_;
  GlbFile& file_;
  dvec3 centre_;
  double diagonal_;
  bool hides_back_ = false;
  std::vector<std::size_t> coordinates_;  ///< accessors of TEXCOORD_0 ...
  Json primitives_ = Json::array();
};

}  // namespace

std::size_t add_mesh(const GlbSurface& surface, GlbTextures& textures, GlbFile& file) {
  return MeshAdder(surface, textures, file).add();
}

}  // namespace saddle
