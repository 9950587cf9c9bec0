// The built-in surfaces.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "scene/model/scene.h"

namespace saddle {

/// A surface of the gallery, as a user would type it.
struct GalleryEntry {
  std::string_view name;         ///< kebab case
  std::string_view description;  ///< one line
  std::string_view assignments;  ///< NAME=EXPRESSION words, separated by spaces
  Camera camera = {};            ///< where it looks good from
  Clip clip = {};
  bool flip = false;                  ///< r_v x r_u points to the front
  std::optional<GridSize> size = {};  ///< of the picture in pixels; none: that of any scene
};

/// All entries, in the order that `saddle list` prints.
std::span<const GalleryEntry> gallery();

/// The entry of that name, or nullptr.
const GalleryEntry* find_gallery_entry(std::string_view name);

/// The entry as a scene; scene and surface have the entry's name.
Scene gallery_scene(const GalleryEntry& entry);

/// The error for a name that is not in the gallery, with the nearest one and all of them.
Error unknown_gallery_name(const std::string& name);

}  // namespace saddle
