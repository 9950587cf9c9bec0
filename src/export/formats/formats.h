// The formats of the files that saddle writes: the table in formats.cpp. The command line, its
// messages and the runs read it, so a new format is a row and a writer.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "export/common/content.h"
#include "scene/model/scene.h"

namespace saddle {

struct ExportedMesh;
struct VideoFormat;

/// The parts of a scene that a format of meshes has room for. Warnings of what is left out, and a
/// table of docs, are made from it.
struct Holds {
  bool front = false;    ///< the colour of a surface
  bool back = false;     ///< another one of its back
  bool numbers = false;  ///< colours of --color
  bool texture = false;  ///< a surface's own picture, or its chequerboard
  bool opacity = false;  ///< surfaces that are see-through
  bool lines = false;    ///< grid lines and level lines
  bool strokes = false;  ///< curves and points without a radius
  bool normals = false;  ///< normals of corners
  bool uv = false;       ///< parameters of corners
  bool nodes = false;    ///< a mesh once for all of its places
  bool doubles = false;  ///< positions that floats would round
  bool open = false;     ///< surfaces with a boundary, and one-sided ones
};

/// A file beside the main one: its name is the main one's without its extension, and this ending.
struct FileBeside {
  std::string_view ending;
  void (*write)(std::ostream& out, const MeshContent& content) = nullptr;
  /// Not set: it always is.
  bool (*is_needed)(const MeshContent& content) = nullptr;
};

/// One row of the table. Exactly one of its writers is set: the one of its kind.
struct Format {
  enum class Kind {
    Picture,    ///< the image of a moment
    Mesh,       ///< the triangles of a moment
    Page,       ///< the scene of a moment, drawn by a browser or a printer
    Animation,  ///< the images of all frames
    Scene       ///< the scene as it was written
  };

  std::string_view extension;  ///< lower case, without a point
  Kind kind = Kind::Picture;
  void (*write_picture)(std::ostream& out, const PictureContent& content) = nullptr;
  void (*write_mesh)(std::ostream& out, const MeshContent& content) = nullptr;
  void (*write_page)(std::ostream& out, const PageContent& content) = nullptr;
  bool takes_sliders = false;  ///< --sliders and --fragment are about it
  /// Pixels that the mesh may be off by, for a picture so high.
  double (*pixels_off)(double height) = [](double) { return 0.5; };
  void (*write_scene)(std::ostream& out, const Scene& scene) = nullptr;
  const VideoFormat* video = nullptr;
  /// Returns the text of the scene file inside a file of this format, if there is one. Not set: the
  /// format holds none.
  std::optional<std::string> (*scene_in)(const std::string& bytes,
                                         const std::string& name) = nullptr;
  std::string_view magic = {};  ///< what a file that carries a scene begins with

  // Formats of meshes alone have these.
  Holds holds = {};
  std::span<const FileBeside> beside = {};
  /// The file's unit in millimetres, for --print-size; 0: it keeps the scene's units.
  double unit = 0;
  /// Triangles that rounding makes vanish. Not set: it does not.
  std::size_t (*flattened)(std::span<const ExportedMesh> placed) = nullptr;
  std::string_view use = {};  ///< what it is for, in a table of docs

  /// Such a file is made of images.
  bool is_drawn() const { return kind == Kind::Picture || kind == Kind::Animation; }
  /// Its tolerance is that of a picture.
  bool is_seen() const { return is_drawn() || kind == Kind::Page; }
  /// load_scene() can open such a file.
  bool carries_scene() const { return kind == Kind::Scene || scene_in != nullptr; }
};

/// All formats, in the order in which messages list them.
std::span<const Format> formats();

/// The format with this extension, in lower or upper case; nullptr if there is none.
const Format* find_format(std::string_view extension);

/// The format that carries scenes and whose files begin as these bytes do; nullptr if none does.
const Format* format_of_bytes(std::string_view bytes);

/// The extension of a path without its point; empty if it has none.
std::string extension_of(const std::filesystem::path& path);

/// "png, ply, stl, obj, glb, 3mf, html, svg, pdf, toml, gif, mp4 or webm".
std::string format_list();

/// A table of what the formats of meshes have room for, for people.
std::string format_table();

/// ".png .ply .html .svg .pdf .toml .gif .mp4 .webm", or only those of one kind.
std::string extension_list(std::optional<Format::Kind> kind = std::nullopt);

/// ".png .ply .obj .glb .3mf .html .svg .pdf .toml": those that load_scene() can open.
std::string scene_extension_list();

}  // namespace saddle
