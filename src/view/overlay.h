// What lies over the picture: the mark of a picked point, messages, help. And the few questions
// about the panel's state that the viewer asks.
#pragma once

#include <optional>
#include <string>

#include "base/vec.h"

namespace saddle {

struct Overlay {
  double left = 0;            ///< where the picture begins, in pixels
  std::optional<dvec2> mark;  ///< a pixel of the picture
  std::string message;        ///< a line at the bottom
  std::string help;           ///< lines in the middle
};

/// Between Window::begin_panel() and end_panel().
void show_overlay(const Overlay& overlay);

/// Keys go into a field.
bool is_text_wanted();
/// A list or menu is open, wherever it reaches.
bool is_popup_open();
/// Takes the keyboard from any field.
void leave_fields();

}  // namespace saddle
