#include "view/window/events.h"

#include <algorithm>

#define GLFW_INCLUDE_NONE  // the numbers of keys, not OpenGL
#include <GLFW/glfw3.h>

namespace saddle {
namespace {

// One frame of Dear ImGui 1.86 handles keys like this: it sees which keys are down, inserts the
// characters typed, unless Ctrl is down, and then does what one editing key says.

bool is_key(const Event& event) {
  return event.kind == Event::Kind::KeyDown || event.kind == Event::Kind::KeyUp;
}

bool is_shift(const Event& event) {
  return is_key(event) && (event.code == GLFW_KEY_LEFT_SHIFT || event.code == GLFW_KEY_RIGHT_SHIFT);
}

/// Shift, Ctrl, Alt and Super.
bool is_modifier(const Event& event) {
  return is_key(event) && event.code >= GLFW_KEY_LEFT_SHIFT && event.code <= GLFW_KEY_RIGHT_SUPER;
}

/// A key that edits: not a modifier, nor one whose character comes as an event of its own.
bool is_editing_key(const Event& event) {
  constexpr int kCommand = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
  const bool is_printable = event.code < GLFW_KEY_ESCAPE;
  return is_key(event) && !is_modifier(event) && (!is_printable || (event.mods & kCommand) != 0);
}

}  // namespace

std::string name_of_key(int key, int mods) {
  if ((mods & GLFW_MOD_CONTROL) != 0) {
    const char* const name = glfwGetKeyName(key, 0);
    if (name == nullptr) return "";
    std::string letter(name);
    // Greek and Cyrillic keyboards have no such letter: the place of the key has.
    const bool is_foreign = static_cast<unsigned char>(letter.front()) > 0x7F;
    if (is_foreign && key >= GLFW_KEY_A && key <= GLFW_KEY_Z) letter = static_cast<char>(key);
    for (char& c : letter) {
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return ((mods & GLFW_MOD_SHIFT) != 0 ? "Ctrl-Shift-" : "Ctrl-") + letter;
  }
  switch (key) {
    case GLFW_KEY_HOME:
      return "Home";
    case GLFW_KEY_SPACE:
      return "Space";
    case GLFW_KEY_TAB:
      return "Tab";
    case GLFW_KEY_F1:
      return "F1";
    case GLFW_KEY_F2:
      return "F2";
    case GLFW_KEY_F11:
      return "F11";
    case GLFW_KEY_ESCAPE:
      return "Escape";
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return "Return";
    default:
      return "";
  }
}

bool is_editing_press(const Event& event) {
  return event.kind == Event::Kind::KeyDown && is_editing_key(event);
}

bool fits_into_frame(const Event& next, std::span<const Event> before) {
  using Kind = Event::Kind;
  const auto is_button = [](const Event& e) {
    return e.kind == Kind::Press || e.kind == Kind::Release;
  };
  const auto is_character = [](const Event& e) { return e.kind == Kind::Character; };
  const auto has = [&](const auto& condition) { return std::ranges::any_of(before, condition); };
  if (has(is_button)) return false;
  // Rows with buttons in them notice a press only where they have seen the pointer before.
  const bool has_moved = has([](const Event& e) { return e.kind == Kind::Move; });
  if (next.kind == Kind::Press && has_moved) return false;
  if (is_button(next)) return !has(is_character) && !has(is_key);
  if (is_character(next)) return !has(is_editing_press);
  if (is_modifier(next)) return !has(is_editing_press) && (is_shift(next) || !has(is_character));
  if (!is_editing_key(next)) return true;
  if (has(is_editing_press)) return false;
  const auto same_key = [&](const Event& e) { return is_key(e) && e.code == next.code; };
  return next.kind == Kind::KeyUp || (!has(is_character) && !has(same_key));
}

}  // namespace saddle
