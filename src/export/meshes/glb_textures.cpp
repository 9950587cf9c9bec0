#include "export/meshes/glb_textures.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "base/image_png.h"
#include "export/meshes/looks.h"
#include "export/meshes/placed_meshes.h"
#include "scene/model/texture.h"

namespace saddle {
namespace {

using Json = GlbFile::Json;

constexpr int kNearest = 9728;
constexpr int kLinear = 9729;
constexpr int kMipmaps = 9987;
constexpr int kClampToEdge = 33071;
constexpr int kMirror = 33648;
constexpr int kRepeat = 10497;

/// Pixels along a cell of a chequerboard. One would do; readers that smooth all pictures blur this
/// part of a cell.
constexpr int kCellPixels = 32;
constexpr int kCells = 2;

int wrap_of(Texture::Wrap wrap) {
  switch (wrap) {
    case Texture::Wrap::Repeat:
      return kRepeat;
    case Texture::Wrap::Mirror:
      return kMirror;
    case Texture::Wrap::Clamp:
      return kClampToEdge;
  }
  return kRepeat;
}

/// The cell at the start of both ranges, the lower left one, has the material's colour.
Image checker_image(const Color& color) {
  Image image(kCells * kCellPixels, kCells * kCellPixels);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool is_dark = x / kCellPixels == y / kCellPixels;
      const Rgb rgb = bytes_of((is_dark ? kDarkCell : 1.0) * rgb_of(color));
      std::ranges::copy(rgb, image.pixel(x, y));
      image.pixel(x, y)[3] = 255;
    }
  }
  return image;
}

std::string png_of(const Image& image, unsigned threads) {
  std::ostringstream png;
  write_png(png, image, {}, threads);
  return std::move(png).str();
}

}  // namespace

std::size_t GlbTextures::add_scales(std::span<const ColorScale> scales) {
  return add_picture(png_of(colormap_image(scales), threads_), {kLinear, kLinear, kClampToEdge});
}

std::size_t GlbTextures::add(const Texture& texture, const Material& material) {
  if (!texture.picture) {
    return add_picture(png_of(checker_image(material.diffuse), threads_),
                       {kNearest, kMipmaps, kRepeat});
  }
  const TexturePicture& picture = *texture.picture;
  const bool is_smooth = texture.filter == Texture::Filter::Smooth;
  return add_picture(
      is_opaque(picture.image) ? picture.file : png_of(opaque(picture.image), threads_),
      {is_smooth ? kLinear : kNearest, is_smooth ? kMipmaps : kNearest, wrap_of(texture.wrap)});
}

std::size_t GlbTextures::add_picture(std::string png, const Sampler& sampler) {
  Json& json = file_.json;
  const auto number_of = [&json](const char* list, Json entry) {
    Json& known = json[list];
    const auto found = std::find(known.begin(), known.end(), entry);
    const auto number = static_cast<std::size_t>(found - known.begin());
    if (found == known.end()) known.push_back(std::move(entry));
    return number;
  };
  auto [image, is_new] = images_.try_emplace(std::move(png), images_.size());
  if (is_new) {
    const std::string& bytes = image->first;  // maps keep their keys where they are
    const std::size_t view = file_.add_view(
        bytes.size(), GlbTarget::None, [&bytes](ByteWriter& writer) { writer.put_text(bytes); });
    json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
  }
  const std::size_t number = number_of("samplers", {{"magFilter", sampler.magnify},
                                                    {"minFilter", sampler.reduce},
                                                    {"wrapS", sampler.wrap},
                                                    {"wrapT", sampler.wrap}});
  return number_of("textures", {{"sampler", number}, {"source", image->second}});
}

dvec2 pictures_across(const SurfaceSpec& spec) {
  return texture_scale(spec) / (spec.texture.is_checker() ? double{kCells} : 1.0);
}

}  // namespace saddle
