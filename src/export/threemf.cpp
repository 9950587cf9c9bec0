#include "export/threemf.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "base/format.h"
#include "base/printable.h"
#include "export/looks.h"
#include "export/placed_meshes.h"
#include "export/solid_parts.h"
#include "export/writers.h"
#include "export/zip.h"
#include "scene/model/colormap.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

constexpr const char* kModelPart = "3D/3dmodel.model";
constexpr std::string_view kSceneBegin = "<metadata name=\"saddle:scene\">";
constexpr std::string_view kSceneEnd = "</metadata>";
/// The scene is before all meshes: a scene file is shorter than 4 MiB, its escapes six times that.
constexpr std::size_t kMostHead = (std::size_t{25} << 20);

constexpr const char* kContentTypes = R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr const char* kRelations = R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

constexpr const char* kModelBegin = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02" xmlns:slic3rpe="http://schemas.slic3r.org/3mf/2017/06" xmlns:saddle="urn:saddle:scene">
<metadata name="Application">saddle</metadata>
<metadata name="slic3rpe:Version3mf">1</metadata>
<metadata name="slic3rpe:MmPaintingVersion">1</metadata>
)";

/// Places in a surface's group of colours; those of numbers are behind them.
enum GroupColor : std::size_t { kFrontColor, kBackColor, kNoNumberColor, kWallColor, kFirstNumber };
constexpr std::size_t kNumberColors = 256;

/// A triangle of the second extruder.
constexpr std::string_view kSecondExtruder = "\" slic3rpe:mmu_segmentation=\"8";

constexpr std::pair<char, std::string_view> kXmlEscapes[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    std::string_view written(&c, 1);
    for (const auto& [plain, escape] : kXmlEscapes) {
      if (c == plain) written = escape;
    }
    result += written;
  }
  return result;
}

std::string xml_unescaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    std::size_t taken = 1;
    char c = text.front();
    for (const auto& [plain, escape] : kXmlEscapes) {
      if (!text.starts_with(escape)) continue;
      c = plain;
      taken = escape.size();
      break;
    }
    result += c;
    text.remove_prefix(taken);
  }
  return result;
}

std::string hex_of(const dvec3& color, double opacity) {
  const Rgb rgb = bytes_of(color);
  const Rgb alpha = bytes_of(dvec3(opacity));
  return formatted("#%02X%02X%02X%02X", rgb[0], rgb[1], rgb[2], alpha[0]);
}

class ModelWriter {
 public:
  ModelWriter(std::ostream& out, const MeshContent& content)
      : writer_(out), content_(content), meshes_(placed_meshes(content)) {
    std::erase_if(meshes_, [](const ExportedMesh& placed) { return placed.is_line; });
    doubles_ = float_rounding(meshes_) > kFloatRounding;
    if (content.shells.empty()) own_ = shells_of(content.meshes);
    shells_ = own_.empty() ? content.shells : own_;
  }

  void write() {
    const Scene& scene = content_.scene;
    writer_ << kModelBegin << "<metadata name=\"Title\">" << escaped(printable(scene.title))
            << "</metadata>\n"
            << kSceneBegin << escaped(write_scene(scene)) << kSceneEnd << "\n<resources>\n";
    std::set<std::size_t> grouped;
    for (const ExportedMesh& placed : meshes_) {
      if (grouped.insert(placed.surface).second) write_colors(placed);
    }
    for (std::size_t i = 0; i < meshes_.size(); ++i) write_object(i);
    writer_ << "</resources>\n<build>\n";
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      writer_ << "<item objectid=\"";
      writer_.whole(object_id(i)) << "\"/>\n";
    }
    writer_ << "</build>\n</model>\n";
    writer_.flush();
  }

 private:
  static std::size_t group_id(const ExportedMesh& placed) { return placed.surface + 1; }
  std::size_t object_id(std::size_t i) const { return content_.meshes.size() + 1 + i; }

  void write_colors(const ExportedMesh& placed) {
    const SurfaceSpec& spec = *placed.spec;
    writer_ << "<m:colorgroup id=\"";
    writer_.whole(group_id(placed)) << "\">\n";
    const auto put = [&](const dvec3& color) {
      writer_ << "<m:color color=\"" << hex_of(color, spec.opacity) << "\"/>\n";
    };
    put(rgb_of(spec.front.diffuse));
    put(rgb_of(spec.back.diffuse));
    put(dvec3(kUndefinedGrey));
    put(rgb_of(material_of(spec, SolidPart::Walls).diffuse));
    for (std::size_t k = 0; placed.scale && k < kNumberColors; ++k) {
      put(colormap_at(placed.scale->colormap, static_cast<double>(k) / (kNumberColors - 1)));
    }
    writer_ << "</m:colorgroup>\n";
  }

  void write_object(std::size_t i) {
    const ExportedMesh& placed = meshes_[i];
    const Shells& shells = shells_[placed.surface];
    writer_ << "<object id=\"";
    writer_.whole(object_id(i)) << "\" type=\"" << (shells.is_solid() ? "model" : "surface")
                                << "\" name=\"" << escaped(printable(placed.name)) << "\" pid=\"";
    writer_.whole(group_id(placed)) << "\" pindex=\"0\">\n<mesh>\n<vertices>\n";
    write_vertices(placed);
    writer_ << "</vertices>\n<triangles>\n";
    for (const PartRange& part : parts_of(*placed.mesh)) {
      for (std::size_t t = part.first; t < part.end(); ++t) {
        write_triangle(placed, t, part.part, shells.is_turned(t));
      }
    }
    writer_ << "</triangles>\n</mesh>\n</object>\n";
  }

  void write_vertices(const ExportedMesh& placed) {
    const Mesh& mesh = *placed.mesh;
    std::vector<std::uint32_t> corner_of(mesh.point_count);
    for (std::size_t i = mesh.point.size(); i-- > 0;) {
      corner_of[mesh.point[i]] = static_cast<std::uint32_t>(i);
    }
    for (const std::uint32_t corner : corner_of) {
      const dvec3 p = placed.point(corner);
      writer_ << "<vertex x=\"";
      writer_.real(p.x, doubles_) << "\" y=\"";
      writer_.real(p.y, doubles_) << "\" z=\"";
      writer_.real(p.z, doubles_) << "\"/>\n";
    }
  }

  /// `turned`: the back is outside.
  void write_triangle(const ExportedMesh& placed, std::size_t t, SolidPart part, bool turned) {
    Triangle triangle = placed.triangle(t);
    if (turned) std::swap(triangle[1], triangle[2]);
    std::array<std::uint32_t, 3> point{};
    for (std::size_t k = 0; k < 3; ++k) point[k] = placed.mesh->point[triangle[k]];
    if (point[0] == point[1] || point[1] == point[2] || point[2] == point[0]) return;
    writer_ << "<triangle v1=\"";
    writer_.whole(point[0]) << "\" v2=\"";
    writer_.whole(point[1]) << "\" v3=\"";
    writer_.whole(point[2]);
    const bool is_back = turned || part == SolidPart::Back;
    const GroupColor side = part == SolidPart::Walls ? kWallColor : kFrontColor;
    write_color(placed, t, triangle, is_back ? kBackColor : side);
    writer_ << "\"/>\n";
  }

  /// Nothing for the front, which the object has.
  void write_color(const ExportedMesh& placed, std::size_t t, const Triangle& triangle,
                   GroupColor side) {
    const auto use = [&](std::size_t color) {
      writer_ << "\" pid=\"";
      writer_.whole(group_id(placed)) << "\" p1=\"";
      writer_.whole(color);
    };
    if (placed.is_undefined(t)) {
      use(kNoNumberColor);
    } else if (placed.scale) {
      use(number_color(placed, triangle[0]));
      writer_ << "\" p2=\"";
      writer_.whole(number_color(placed, triangle[1])) << "\" p3=\"";
      writer_.whole(number_color(placed, triangle[2]));
    } else if (side != kFrontColor) {
      use(side);
      if (side == kBackColor) writer_ << kSecondExtruder;
    }
  }

  static std::size_t number_color(const ExportedMesh& placed, std::uint32_t corner) {
    const double place = placed.place_of(corner) * (kNumberColors - 1);
    return kFirstNumber + static_cast<std::size_t>(std::lround(place));
  }

  TextWriter writer_;
  const MeshContent& content_;
  std::vector<ExportedMesh> meshes_;
  std::vector<Shells> own_;
  std::span<const Shells> shells_;
  bool doubles_ = false;
};

}  // namespace

void write_3mf(std::ostream& out, const MeshContent& content) {
  ZipWriter zip(out, content.threads);
  zip.add("[Content_Types].xml", [](std::ostream& part) { part << kContentTypes; });
  zip.add("_rels/.rels", [](std::ostream& part) { part << kRelations; });
  zip.add(kModelPart, [&](std::ostream& part) { ModelWriter(part, content).write(); });
  zip.finish();
}

std::optional<std::string> scene_in_3mf(const std::string& bytes, const std::string& name) {
  const std::optional<std::string> head = part_of_zip(bytes, kModelPart, kMostHead, name);
  if (!head) return std::nullopt;
  const std::size_t begin = head->find(kSceneBegin);
  if (begin == std::string::npos) return std::nullopt;
  const std::size_t text = begin + kSceneBegin.size();
  const std::size_t end = head->find(kSceneEnd, text);
  if (end == std::string::npos) return std::nullopt;
  return xml_unescaped(std::string_view(*head).substr(text, end - text));
}

}  // namespace saddle
