#include "export/formats.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <ostream>
#include <vector>

#include "export/figure.h"
#include "export/page.h"
#include "export/ply.h"
#include "export/scene_png.h"
#include "export/video.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

using Kind = Format::Kind;

void write_toml(std::ostream& out, const Scene& scene) {
  out << write_scene(scene);
}

constexpr std::array kFormats = {
    Format{.extension = "png",
           .kind = Kind::Picture,
           .write_picture = write_scene_png,
           .scene_in = scene_in_png},
    Format{.extension = "ply", .kind = Kind::Mesh, .write_mesh = write_scene_ply},
    Format{.extension = "html",
           .kind = Kind::Page,
           .write_page = write_page,
           .takes_sliders = true,
           .scene_in = scene_in_page},
    Format{
        .extension = "svg", .kind = Kind::Page, .write_page = write_svg, .scene_in = scene_in_svg},
    Format{
        .extension = "pdf", .kind = Kind::Page, .write_page = write_pdf, .scene_in = scene_in_pdf},
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

std::string extension_list(std::optional<Format::Kind> kind) {
  std::string text;
  for (const Format& format : kFormats) {
    if (kind && format.kind != *kind) continue;
    text += (text.empty() ? "." : " .") + std::string(format.extension);
  }
  return text;
}

}  // namespace saddle
