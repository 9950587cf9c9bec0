// Events of the window, and how many of them the panel can tell apart in a frame.
#pragma once

#include <span>
#include <string>

#include "base/vec.h"

namespace saddle {

/// An event of mouse or keyboard. Places are in pixels from the window's upper left.
struct Event {
  enum class Kind { Press, Release, Move, Scroll, Character, KeyDown, KeyUp, Drop };
  Kind kind = Kind::Move;
  dvec2 place{0, 0};   ///< of the pointer, in pixels
  int button = 0;      ///< 0 left, 1 right, 2 middle
  bool shift = false;  ///< held down
  bool twice = false;  ///< the second press in a row at this place
  double notches = 0;  ///< of the wheel, away from the hand
  /// As in the table of actions, empty: it is not in the table; of a file that was dropped, its
  /// path.
  std::string key;
  // As GLFW has them, for the panel.
  int code = 0;
  int mods = 0;
};

/// The keys that type no character, as the table of actions calls them, by GLFW's numbers; empty:
/// it does not have the key. With Ctrl held, letters are upper case, wherever the keyboard has
/// them.
std::string name_of_key(int code, int mods);

/// The press of a key that edits: not a modifier, nor one whose character comes as an event.
bool is_editing_press(const Event& event);

/// One frame of the panel can tell `next` apart from the events before it.
bool fits_into_frame(const Event& next, std::span<const Event> before);

}  // namespace saddle
