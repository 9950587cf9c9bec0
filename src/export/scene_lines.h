// Scene files inside of text that has lines for comments.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/model/scene.h"

namespace saddle {

/// The scene file in lines that begin with `comment`, which ends in a space. Lines are no longer
/// than the buffers of readers.
std::string scene_lines(const Scene& scene, std::string_view comment);

/// The scene file that such lines of a text hold, if there is one. Only lines up to the first that
/// is no comment are looked at, after `skipped` lines.
std::optional<std::string> scene_in_lines(std::string_view text, std::string_view comment,
                                          int skipped);

}  // namespace saddle
