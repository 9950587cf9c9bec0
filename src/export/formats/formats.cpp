#include "export/formats/formats.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <ostream>
#include <utility>
#include <vector>

#include "export/figures/figure.h"
#include "export/meshes/glb.h"
#include "export/meshes/obj.h"
#include "export/meshes/ply.h"
#include "export/meshes/stl.h"
#include "export/meshes/threemf.h"
#include "export/page/page.h"
#include "export/pictures/scene_png.h"
#include "export/pictures/video.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

using Kind = Format::Kind;

void write_toml(std::ostream& out, const Scene& scene) {
  out << write_scene(scene);
}

constexpr FileBeside kBesideObj[] = {
    {.ending = ".mtl", .write = write_mtl},
    {.ending = "-color.png", .write = write_color_png, .is_needed = is_colored}};

constexpr std::array kFormats = {
    Format{.extension = "png",
           .kind = Kind::Picture,
           .write_picture = write_scene_png,
           .scene_in = scene_in_png,
           .magic = "\x89PNG\r\n"},
    Format{.extension = "ply",
           .kind = Kind::Mesh,
           .write_mesh = write_scene_ply,
           .scene_in = scene_in_ply,
           .magic = "ply\n",
           .holds = {.numbers = true, .normals = true, .uv = true, .doubles = true, .open = true},
           .use = "programs that measure meshes"},
    Format{.extension = "stl",
           .kind = Kind::Mesh,
           .write_mesh = write_stl,
           .unit = 1,
           .flattened = flattened_triangles,
           .use = "printers and CAD"},
    Format{.extension = "obj",
           .kind = Kind::Mesh,
           .write_mesh = write_obj,
           .scene_in = scene_in_obj,
           .magic = "# saddle\n",
           .holds = {.front = true,
                     .numbers = true,
                     .opacity = true,
                     .lines = true,
                     .strokes = true,
                     .normals = true,
                     .uv = true,
                     .doubles = true,
                     .open = true},
           .beside = kBesideObj,
           .unit = 1,
           .use = "modelling programs"},
    Format{.extension = "glb",
           .kind = Kind::Mesh,
           .write_mesh = write_glb,
           .scene_in = scene_in_glb,
           .magic = "glTF",
           .holds = {.front = true,
                     .back = true,
                     .numbers = true,
                     .texture = true,
                     .opacity = true,
                     .lines = true,
                     .strokes = true,
                     .normals = true,
                     .uv = true,
                     .nodes = true,
                     .doubles = true,
                     .open = true},
           .unit = 1000,
           .use = "the web, phones, Blender"},
    Format{
        .extension = "3mf",
        .kind = Kind::Mesh,
        .write_mesh = write_3mf,
        .scene_in = scene_in_3mf,
        .magic = "PK\x03\x04",
        .holds = {.front = true, .back = true, .numbers = true, .opacity = true, .doubles = true},
        .unit = 1,
        .use = "printers, with colours and units"},
    Format{.extension = "html",
           .kind = Kind::Page,
           .write_page = write_page,
           .takes_sliders = true,
           .pixels_off = page_pixels_off,
           .scene_in = scene_in_page,
           .magic = "<!DOCTYPE html>"},
    Format{.extension = "svg",
           .kind = Kind::Page,
           .write_page = write_svg,
           .pixels_off = figure_pixels_off,
           .scene_in = scene_in_svg,
           .magic = "<?xml"},
    Format{.extension = "pdf",
           .kind = Kind::Page,
           .write_page = write_pdf,
           .pixels_off = figure_pixels_off,
           .scene_in = scene_in_pdf,
           .magic = "%PDF"},
    Format{.extension = "toml", .kind = Kind::Scene, .write_scene = write_toml},
    Format{.extension = "gif", .kind = Kind::Animation, .video = &kGif},
    Format{.extension = "mp4", .kind = Kind::Animation, .video = &kMp4},
    Format{.extension = "webm", .kind = Kind::Animation, .video = &kWebm},
};

}  // namespace

std::span<const Format> formats() {
  return kFormats;
}

const Format* find_format(std::string_view extension) {
  std::string name(extension);
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto* const found = std::ranges::find(kFormats, name, &Format::extension);
  return found == kFormats.end() ? nullptr : found;
}

const Format* format_of_bytes(std::string_view bytes) {
  for (const Format& format : kFormats) {
    if (!format.magic.empty() && bytes.starts_with(format.magic)) return &format;
  }
  return nullptr;
}

std::string extension_of(const std::filesystem::path& path) {
  const std::string with_point = path.extension().string();
  return with_point.empty() ? "" : with_point.substr(1);
}

std::string format_list() {
  std::string text;
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    text += i == 0 ? "" : i + 1 == kFormats.size() ? " or " : ", ";
    text += kFormats[i].extension;
  }
  return text;
}

std::string format_table() {
  constexpr std::pair<const char*, bool Holds::*> kColumns[] = {
      {"front", &Holds::front},     {"back", &Holds::back},       {"color", &Holds::numbers},
      {"texture", &Holds::texture}, {"opacity", &Holds::opacity}, {"lines", &Holds::lines},
      {"curves", &Holds::strokes},  {"normals", &Holds::normals}, {"u,v", &Holds::uv},
      {"nodes", &Holds::nodes},     {"doubles", &Holds::doubles}, {"open", &Holds::open}};
  const auto padded = [](std::string_view word, std::size_t width) {
    return std::string(word) + std::string(width - word.size() + 2, ' ');
  };
  std::string text = "Formats of meshes, what they have room for, and what they are for:\n\n  ";
  text += padded("", 4);
  for (const auto& [name, holds] : kColumns) text += padded(name, std::string_view(name).size());
  text += "scene  for\n";
  for (const Format& format : kFormats) {
    if (format.kind != Format::Kind::Mesh) continue;
    text += "  " + padded("." + std::string(format.extension), 4);
    for (const auto& [name, holds] : kColumns) {
      text += padded(format.holds.*holds ? "+" : "-", std::string_view(name).size());
    }
    text += padded(format.carries_scene() ? "+" : "-", 5) + std::string(format.use) + "\n";
  }
  return text +
         "\nfront, back: colours of the sides. color: of --color. texture: of --texture. lines: on "
         "surfaces.\ncurves: and points, without a radius. nodes: a mesh once for all of its "
         "places. "
         "open: surfaces\nthat are no solid. scene: saddle FILE opens it again.\n";
}

namespace {

template <typename Wanted>
std::string extensions_of(Wanted wanted) {
  std::string text;
  for (const Format& format : kFormats) {
    if (!wanted(format)) continue;
    text += (text.empty() ? "." : " .") + std::string(format.extension);
  }
  return text;
}

}  // namespace

std::string extension_list(std::optional<Format::Kind> kind) {
  return extensions_of([kind](const Format& format) { return !kind || format.kind == *kind; });
}

std::string scene_extension_list() {
  return extensions_of([](const Format& format) { return format.carries_scene(); });
}

}  // namespace saddle
