// Pictures as PNG, with the scene that they show as text inside.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

#include "export/common/content.h"

namespace saddle {

/// Writes the image as PNG with the scene file of `content.scene` in a text chunk.
void write_scene_png(std::ostream& out, const PictureContent& content);

/// The scene file in a PNG; nothing if it holds none. Throws Error as read_png() does.
std::optional<std::string> scene_in_png(const std::string& bytes, const std::string& name);

}  // namespace saddle
