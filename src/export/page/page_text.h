// The page's script, style and shaders, made short.
#pragma once

#include <string>
#include <string_view>

namespace saddle {

/// Without indentation, empty lines, and comments that begin a line or stand two spaces behind
/// code.
std::string without_comments(std::string_view text);

/// JavaScript, CSS or GLSL without comments, and without spaces and ends of lines that separate
/// nothing. Text in quotes and lines that begin with # are left alone. JavaScript's regular
/// expressions must have neither quotes nor spaces, CSS no negative lengths behind others.
std::string squeezed(std::string_view text);

}  // namespace saddle
