#include "export/meshes/obj.h"

#include <cstddef>
#include <ostream>
#include <string_view>
#include <vector>

#include "base/image_png.h"
#include "export/common/scene_lines.h"
#include "export/common/writers.h"
#include "export/meshes/looks.h"
#include "export/meshes/placed_meshes.h"
#include "export/meshes/solid_parts.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

constexpr std::string_view kHash = "# ";

/// A name as one word of printing characters.
std::string word_of(const std::string& name) {
  std::string word = name;
  for (char& c : word) {
    if (static_cast<unsigned char>(c) <= ' ' || c == 0x7f || c == '#') c = '_';
  }
  return word;
}

/// The material of a part of the mesh of this name.
std::string material_name(const std::string& name, SolidPart part) {
  if (part == SolidPart::Front) return name;
  return name + (part == SolidPart::Back ? "-back" : "-walls");
}

/// Numbers of the first element of a mesh in the file; OBJ counts from 1.
struct Firsts {
  std::size_t v = 1;
  std::size_t corner = 1;  ///< of vt and vn
};

class ObjWriter {
 public:
  ObjWriter(std::ostream& out, const MeshContent& content)
      : writer_(out), content_(content), meshes_(placed_meshes(content)) {
    rows_ = scales_of(content.scene, content.meshes).size();
    doubles_ = float_rounding(meshes_) > kFloatRounding;
  }

  void write() {
    writer_ << "# saddle\n" << scene_lines(content_.scene, kHash);
    if (has_materials()) writer_ << "mtllib " << content_.stem << ".mtl\n";
    std::vector<Firsts> firsts;
    for (const ExportedMesh& placed : meshes_) {
      firsts.push_back(next_);
      if (!placed.is_line) write_mesh(placed);
    }
    // Objects of their own: in an object with faces, some readers take all for lines.
    for (std::size_t i = 0; i < meshes_.size(); ++i) write_lines(meshes_[i], firsts[i]);
    writer_.flush();
  }

 private:
  bool has_materials() const { return !content_.stem.empty(); }

  void use(const std::string& material) {
    if (has_materials()) writer_ << "usemtl " << material << "\n";
  }

  void put_vector(std::string_view key, const dvec3& v, bool doubles) {
    writer_ << key;
    for (int k = 0; k < 3; ++k) writer_.put(' ').real(v[k], doubles);
    writer_.put('\n');
  }

  /// The corner that has each point's place.
  static std::vector<std::uint32_t> corner_of_points(const Mesh& mesh) {
    std::vector<std::uint32_t> corner(mesh.point_count);
    for (std::size_t i = mesh.point.size(); i-- > 0;) {
      corner[mesh.point[i]] = static_cast<std::uint32_t>(i);
    }
    return corner;
  }

  void write_points(const ExportedMesh& placed) {
    for (const std::uint32_t corner : corner_of_points(*placed.mesh)) {
      put_vector("v", placed.point(corner), doubles_);
    }
    next_.v += placed.mesh->point_count;
  }

  void write_mesh(const ExportedMesh& placed) {
    const std::string name = word_of(placed.name);
    writer_ << "o " << name << "\n";
    const Firsts first = next_;
    write_points(placed);
    write_corners(placed);
    bool some_undefined = false;
    for (const PartRange& part : parts_of(*placed.mesh)) {
      use(material_name(name, part.part));
      for (std::size_t t = part.first; t < part.end(); ++t) {
        placed.is_undefined(t) ? static_cast<void>(some_undefined = true)
                               : write_face(placed, t, first);
      }
    }
    if (!some_undefined) return;
    use("undefined");
    for (std::size_t t = 0; t < placed.mesh->triangles.size(); ++t) {
      if (placed.is_undefined(t)) write_face(placed, t, first);
    }
  }

  void write_corners(const ExportedMesh& placed) {
    const Mesh& mesh = *placed.mesh;
    for (std::size_t i = 0; i < mesh.position.size(); ++i) {
      dvec2 place = mesh.uv[i];
      if (placed.scale) {
        place = place_in_image(placed.place_of(i), placed.row, rows_);
        place.y = 1 - place.y;  // from the lower left corner
      }
      writer_ << "vt ";
      writer_.real(place.x, doubles_).put(' ').real(place.y, doubles_).put('\n');
    }
    for (std::size_t i = 0; i < mesh.position.size(); ++i) {
      const dvec3 normal = placed.normal(i);
      writer_ << "vn";
      for (int k = 0; k < 3; ++k) writer_.put(' ').unit(normal[k]);
      writer_.put('\n');
    }
    next_.corner += mesh.position.size();
  }

  void write_face(const ExportedMesh& placed, std::size_t t, const Firsts& first) {
    writer_.put('f');
    for (const std::uint32_t corner : placed.triangle(t)) {
      writer_.corner(first.v + placed.mesh->point[corner], first.corner + corner);
    }
    writer_.put('\n');
  }

  void write_lines(const ExportedMesh& placed, const Firsts& first) {
    const Mesh& mesh = *placed.mesh;
    const std::string name = word_of(placed.name);
    if (placed.is_line) {
      writer_ << "o " << name << "\n";
      const std::size_t begin = next_.v;
      write_points(placed);
      use(name + "-lines");
      write_chains(mesh.lines, begin, [&](std::uint32_t corner) { return mesh.point[corner]; });
      return;
    }
    if (!mesh.lines.empty()) {
      writer_ << "o " << name << "-lines\n";
      use(name + "-lines");
      write_chains(mesh.lines, first.v, [&](std::uint32_t corner) { return mesh.point[corner]; });
    }
    if (mesh.contours.lines.empty()) return;
    writer_ << "o " << name << "-contours\n";
    const std::size_t begin = next_.v;
    for (const dvec3& p : mesh.contours.on_mesh) put_vector("v", placed.place.point(p), doubles_);
    next_.v += mesh.contours.on_mesh.size();
    use(name + "-contours");
    write_chains(mesh.contours.lines, begin, [](std::uint32_t vertex) { return vertex; });
  }

  /// `l` of two vertices each: some readers take only the first two of more.
  template <typename Number>
  void write_chains(const std::vector<std::vector<std::uint32_t>>& chains, std::size_t first,
                    const Number& number) {
    for (const std::vector<std::uint32_t>& chain : chains) {
      if (chain.size() == 1) {
        writer_ << "p ";
        writer_.whole(first + number(chain[0])) << "\n";
      }
      for (std::size_t i = 1; i < chain.size(); ++i) {
        writer_ << "l ";
        writer_.whole(first + number(chain[i - 1])) << " ";
        writer_.whole(first + number(chain[i])) << "\n";
      }
    }
  }

  TextWriter writer_;
  const MeshContent& content_;
  std::vector<ExportedMesh> meshes_;
  std::size_t rows_ = 0;  ///< of the picture of colours
  bool doubles_ = false;
  Firsts next_;
};

void write_color(TextWriter& writer, std::string_view key, const dvec3& color) {
  writer << key;
  for (int k = 0; k < 3; ++k) (writer << " ").real(color[k], false);
  writer << "\n";
}

void write_material(TextWriter& writer, const std::string& name, const Material& material,
                    double opacity) {
  constexpr double kMostShininess = 1000;  // the format's limit
  writer << "newmtl " << name << "\n";
  write_color(writer, "Kd", rgb_of(material.diffuse));
  write_color(writer, "Ka", rgb_of(material.ambient.value_or(material.diffuse)));
  write_color(writer, "Ks", rgb_of(material.specular));
  write_color(writer, "Ke", rgb_of(material.emission));
  writer << "Ns ";
  writer.real(std::min(material.shininess.value, kMostShininess), false) << "\nd ";
  writer.real(opacity, false) << "\nillum 2\n";
}

}  // namespace

void write_obj(std::ostream& out, const MeshContent& content) {
  ObjWriter(out, content).write();
}

void write_mtl(std::ostream& out, const MeshContent& content) {
  TextWriter writer(out);
  writer << "# saddle\n";
  bool some_colored = false;
  for (const ExportedMesh& placed : placed_meshes(content)) {
    const std::string name = word_of(placed.name);
    Material lines;
    lines.diffuse = placed.spec->line_color;
    write_material(writer, name + "-lines", lines, 1);
    if (!placed.mesh->contours.lines.empty()) {
      lines.diffuse = contour_color_of(*placed.spec, content.scene.theme);
      write_material(writer, name + "-contours", lines, 1);
    }
    if (placed.is_line) continue;
    for (const PartRange& part : parts_of(*placed.mesh)) {
      Material material = material_of(*placed.spec, part.part);
      // The picture is multiplied by the colour.
      if (placed.scale) material.diffuse = {1, 1, 1};
      write_material(writer, material_name(name, part.part), material, placed.spec->opacity);
      if (!placed.scale) continue;
      some_colored = true;
      writer << "map_Kd " << content.stem << "-color.png\n";
    }
  }
  Material undefined;
  undefined.diffuse = {kUndefinedGrey, kUndefinedGrey, kUndefinedGrey};
  if (some_colored) write_material(writer, "undefined", undefined, 1);
  writer.flush();
}

void write_color_png(std::ostream& out, const MeshContent& content) {
  write_png(out, colormap_image(scales_of(content.scene, content.meshes)), {}, content.threads);
}

bool is_colored(const MeshContent& content) {
  return !scales_of(content.scene, content.meshes).empty();
}

std::optional<std::string> scene_in_obj(const std::string& bytes, const std::string& /*name*/) {
  constexpr int kFirstLine = 1;  // "# saddle"
  return scene_in_lines(bytes, kHash, kFirstLine);
}

}  // namespace saddle
