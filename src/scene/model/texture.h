// Textures: picture files in memory, and where a surface has them.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"
#include "scene/model/scene.h"

namespace saddle {

/// The name of the texture that is no picture: a chequerboard of the cells between grid lines.
inline constexpr std::string_view kChecker = "checker";

/// The texture `name` of an option: a path of the user's own, kChecker, or what texture_text()
/// gives; `subject` for messages. Throws Error: Input for a file that is missing, no PNG, damaged
/// or more than kMaxPixels wide or high; Machine for one that cannot be read.
Texture read_texture(const std::string& subject, const std::string& name);

/// The same for a scene file in `folder`. Such a file may come from a stranger: its path begins in
/// the folder and never leaves it.
Texture read_scene_texture(const std::string& subject, const std::string& name,
                           const std::filesystem::path& folder);

/// The texture in a scene's text: kChecker, the picture's bytes as a data URI (RFC 2397), or, of a
/// file larger than kMostEmbeddedBytes, its name.
std::string texture_text(const Texture& texture);
inline constexpr std::size_t kMostEmbeddedBytes = std::size_t{1} << 20;

/// The texture changes nothing but its wrap, filter and repeat.
void set_picture(const Texture& read, Texture& texture);

/// Places on the texture, 0 to 1 over the ranges, of corners with these parameters.
std::vector<dvec2> texture_places(const Scene& scene, const SurfaceSpec& spec,
                                  std::span<const dvec2> uv);

/// How often the texture repeats across the ranges of u and v; of a chequerboard its cells.
dvec2 texture_scale(const SurfaceSpec& spec);

}  // namespace saddle
