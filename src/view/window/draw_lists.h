// The vertices and commands of a frame of Dear ImGui.
#pragma once

#include <string>
#include <vector>

#include "render/gl/viewport.h"

struct ImDrawData;

namespace saddle {

/// The boxes around what its commands draw, in pixels from the window's upper left.
std::vector<PixelRect> boxes_of(const ImDrawData& drawn);

/// All of it: frames that look alike have the same.
std::string bytes_of(const ImDrawData& drawn);

}  // namespace saddle
