#include "scene/model/texture.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "base/base64.h"
#include "base/error.h"
#include "base/file.h"
#include "base/image_png.h"
#include "scene/model/prepare.h"
#include "scene/model/values.h"

namespace saddle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDataPrefix = "data:image/png;base64,";

/// Characters of a texture's name in messages: a data URI has millions.
constexpr std::size_t kShownCharacters = 60;

/// Pixels of a texture: OpenGL takes five times the 250 MB that so many have.
constexpr std::uint64_t kMostTexturePixels = std::uint64_t{8192} * 8192;

Error texture_error(const std::string& subject, const std::string& name, const std::string& message,
                    const std::string& hint) {
  const std::string shown = name.substr(0, kShownCharacters);
  return {Status::Input, message, {subject, shown, {0, shown.size()}}, hint};
}

void check_pixels(const std::string& subject, const std::string& name, const std::string& shown,
                  const std::string& bytes) {
  const std::optional<PngSize> size = size_of_png(bytes);
  if (!size || std::uint64_t{size->width} * size->height <= kMostTexturePixels) return;
  // decode_png() refuses longer sides.
  if (std::max(size->width, size->height) > kMaxPixels) return;
  throw texture_error(
      subject, name,
      shown + " has " + std::to_string(size->width) + "x" + std::to_string(size->height) +
          " pixels",
      "a texture has at most " + std::to_string(kMostTexturePixels) + ", such as 8192x8192");
}

std::shared_ptr<const TexturePicture> decoded(const std::string& subject, const std::string& name,
                                              const std::string& shown, std::string bytes) {
  if (!is_png(bytes)) {
    throw texture_error(subject, name, shown + " is not a PNG file", "a texture is a PNG picture");
  }
  check_pixels(subject, name, shown, bytes);
  try {
    Image image = decode_png(bytes, shown).image;
    return std::make_shared<TexturePicture>(TexturePicture{std::move(image), std::move(bytes)});
  } catch (const Error& error) {
    if (error.status() != Status::Input) throw;
    throw texture_error(
        subject, name, error.what(),
        "a texture is a PNG picture of at most " + std::to_string(kMaxPixels) + " pixels each way");
  }
}

std::shared_ptr<const TexturePicture> loaded(const std::string& subject, const std::string& name,
                                             const fs::path& path) {
  std::error_code ignored;  // what cannot be looked up is no file
  if (!fs::is_regular_file(path, ignored)) {
    throw texture_error(subject, name,
                        fs::exists(path, ignored) ? path.string() + " is not a file"
                                                  : "there is no file " + path.string(),
                        "a texture is a PNG picture, or checker");
  }
  return decoded(subject, name, path.string(), read_file(path));
}

Texture texture_of(const std::string& name, std::shared_ptr<const TexturePicture> picture = {}) {
  Texture texture;
  texture.name = name;
  texture.picture = std::move(picture);
  return texture;
}

/// A texture that is no file; nothing for the name of a file.
std::optional<Texture> texture_without_file(const std::string& subject, const std::string& name) {
  if (name == "off") return Texture();
  if (name == kChecker) return texture_of(name);
  if (!name.starts_with(kDataPrefix)) return std::nullopt;
  auto bytes = bytes_of_base64(std::string_view(name).substr(kDataPrefix.size()));
  if (!bytes) {
    throw texture_error(subject, name, "the picture's text is damaged",
                        "saddle writes it; name the picture's file instead");
  }
  return texture_of("", decoded(subject, name, "the picture in the scene", std::move(*bytes)));
}

bool leaves_folder(const fs::path& path) {
  return path.is_absolute() || path.has_root_path() ||
         std::ranges::any_of(path, [](const fs::path& part) { return part == ".."; });
}

/// Symbolic links lead out of the folder.
bool is_outside(const fs::path& path, const fs::path& folder) {
  std::error_code ignored;
  const fs::path real = fs::weakly_canonical(path, ignored);
  const fs::path home = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, ignored);
  const auto [rest, end] = std::ranges::mismatch(home, real);
  return rest != home.end();
}

}  // namespace

Texture read_texture(const std::string& subject, const std::string& name) {
  if (auto texture = texture_without_file(subject, name)) return std::move(*texture);
  return texture_of(name, loaded(subject, name, name));
}

Texture read_scene_texture(const std::string& subject, const std::string& name,
                           const fs::path& folder) {
  if (auto texture = texture_without_file(subject, name)) return std::move(*texture);
  const fs::path path = folder / name;
  if (leaves_folder(name) || is_outside(path, folder)) {
    throw texture_error(subject, name, "the file is outside of the scene's folder",
                        "put the picture beside the scene file, or name it on the command line: "
                        "--texture FILE");
  }
  return texture_of(path.string(), loaded(subject, name, path));
}

std::string texture_text(const Texture& texture) {
  if (!texture.picture) return texture.name;
  const std::string& file = texture.picture->file;
  const bool is_large = file.size() > kMostEmbeddedBytes && !texture.name.empty();
  if (is_large) return fs::path(texture.name).filename().string();
  return std::string(kDataPrefix) + base64_of(file);
}

void set_picture(const Texture& read, Texture& texture) {
  texture.name = read.name;
  texture.picture = read.picture;
}

std::vector<dvec2> texture_places(const Scene& scene, const SurfaceSpec& spec,
                                  std::span<const dvec2> uv) {
  const Surface surface = prepare_surface(scene, spec).surface;
  std::vector<dvec2> places(uv.begin(), uv.end());
  take_own_parameters(surface, places);
  const Domain& d = surface.domain;
  for (dvec2& place : places) {
    place = (place - dvec2(d.u0, d.v0)) / (dvec2(d.u1, d.v1) - dvec2(d.u0, d.v0));
  }
  return places;
}

dvec2 texture_scale(const SurfaceSpec& spec) {
  if (!spec.texture.is_checker()) return {spec.texture.repeat.u, spec.texture.repeat.v};
  const auto cells = [](int lines, int usual) { return (lines > 1 ? lines : usual) - 1; };
  const GridSize lines = spec.grid_lines();
  return {cells(lines.u, kUsualGrid.u), cells(lines.v, kUsualGrid.v)};
}

}  // namespace saddle
