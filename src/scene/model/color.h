// Colours as text.
#pragma once

#include <string>

#include "scene/model/scene.h"

namespace saddle {

/// `#rgb`, `#rrggbb`, `#rrggbbaa`, a CSS colour name (any case) or `transparent`. `option` names
/// the place in messages. Throws Error (Input) with the nearest colour name.
/// Source: W3C, "CSS Color Module Level 4", 2022.
Color parse_color(const std::string& option, const std::string& text);

/// The text begins with `#` or is a CSS colour name: what a person means as a colour.
bool looks_like_color(const std::string& text);

/// The shortest text that parse_color reads back as the same 8-bit colour: `#rrggbb[aa]`.
std::string format_color(const Color& color);

}  // namespace saddle
