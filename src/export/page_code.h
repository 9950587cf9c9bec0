// A scene as JavaScript: its formulas as functions of the parameters, its numbers, its shaders.
#pragma once

#include <cstddef>
#include <string>

#include "export/page_scene.h"

namespace saddle {

/// Text in quotes that is safe inside of a script of a page.
std::string js_string(const std::string& text);

/// The statement that defines `scene`, which the scripts of src/export/page/ read.
std::string page_scene_code(const PageScene& page);

/// A parameter's place in the array that the page's functions take; 0 is t.
inline std::string parameter_of(std::size_t index) {
  return "p[" + std::to_string(index) + "]";
}

}  // namespace saddle
