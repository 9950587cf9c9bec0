// The overlay of the picture: the mark of a picked point, messages, help.
#pragma once

#include <optional>
#include <string>

#include "base/vec.h"

namespace saddle {

struct Overlay {
  double left = 0;              ///< where the picture begins, in pixels
  std::optional<dvec2> mark;    ///< a pixel of the picture
  bool is_mark_hidden = false;  ///< behind a surface: hollow
  std::string message;          ///< a line at the bottom
  std::string help;             ///< lines in the middle
};

/// Between Window::begin_panel() and end_panel().
void show_overlay(const Overlay& overlay);

}  // namespace saddle
