// The textures of a GLB file.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>

#include "export/meshes/glb_file.h"
#include "scene/model/color_scale.h"
#include "scene/model/scene.h"

namespace saddle {

/// Adds textures with their pictures to a file, each one once. It refers to the file.
class GlbTextures {
 public:
  /// `threads` pack the pictures; 0: all.
  GlbTextures(GlbFile& file, unsigned threads) : file_(file), threads_(threads) {}

  /// The picture of these scales' colours. Returns the texture's number.
  std::size_t add_scales(std::span<const ColorScale> scales);

  /// A surface's texture. Glossy or not, a picture is the colour of both sides; a chequerboard has
  /// the material's own, in two by two cells. Returns the texture's number.
  std::size_t add(const Texture& texture, const Material& material);

 private:
  struct Sampler {
    int magnify, reduce, wrap;  ///< glTF's numbers
  };
  std::size_t add_picture(std::string png, const Sampler& sampler);

  GlbFile& file_;
  unsigned threads_;
  std::map<std::string, std::size_t> images_;  ///< of the file, by their bytes
};

/// How many pictures of GlbTextures::add() are across the ranges of u and v.
dvec2 pictures_across(const SurfaceSpec& spec);

}  // namespace saddle
