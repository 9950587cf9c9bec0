// A scene as a page of the web: one file that asks for no other, with the formulas, the meshes, and
// what draws them.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "export/common/content.h"

namespace saddle {

/// Writes the page, or the part that other pages embed. Throws Error (Input): a slider for what is
/// no parameter.
void write_page(std::ostream& out, const PageContent& content);

/// Half a pixel of a large screen, 1080 pixels high, in pixels of a picture so high: browsers show
/// pages larger than the picture.
double page_pixels_off(double height);

/// The scene file in a page; nothing if it holds none.
std::optional<std::string> scene_in_page(const std::string& bytes, const std::string& name);

}  // namespace saddle
