// Colormaps: from a number between 0 and 1 to a colour.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"

namespace saddle {

/// The names, the default first.
const std::vector<std::string>& colormap_names();

/// Throws Error (Input) with the names and the nearest one unless `text` is one of them.
std::string parse_colormap(const std::string& option, const std::string& text);

/// Red, green, blue, each 0 to 1, of a known map at `x`, which is clamped to 0..1: tables of
/// colours, evenly spaced and linear in between.
dvec3 colormap_at(const std::string& name, double x);

/// The map has a middle that is to stand for zero.
bool is_diverging(const std::string& name);

}  // namespace saddle
