#include "view/model/keys.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace saddle {
namespace {

constexpr std::array kTable{
    KeyBinding{Action::Grid, "g", "grid lines on or off"},
    KeyBinding{Action::Axes, "a", "the box around the surface, with ticks"},
    KeyBinding{Action::Wireframe, "w", "triangles as wires"},
    KeyBinding{Action::Normals, "n", "normals"},
    KeyBinding{Action::Flip, "f", "swap front and back"},
    KeyBinding{Action::NextLights, "l", "next light setup: three lights, at the eye, from above"},
    KeyBinding{Action::ShadeVertices, "1", "colours of corners, blended"},
    KeyBinding{Action::ShadePixels, "2", "lighting of each pixel"},
    KeyBinding{Action::ShadeExactly, "3", "the same, with the normal of the formula"},
    KeyBinding{Action::Orthographic, "o", "orthographic or perspective"},
    KeyBinding{Action::Turntable, "t", "turn on a table, which keeps up up, or on a ball"},
    KeyBinding{Action::AlongX, "x", "look along x; again: from the other side"},
    KeyBinding{Action::AlongY, "y", "look along y"},
    KeyBinding{Action::AlongZ, "z", "look along z"},
    KeyBinding{Action::Fit, "Home", "fit the surface into the picture"},
    KeyBinding{Action::Play, "Space", "play or stop t"},
    KeyBinding{Action::Coarser, "[", "coarser mesh: twice the tolerance"},
    KeyBinding{Action::Finer, "]", "finer mesh: half the tolerance"},
    KeyBinding{Action::SavePicture, "s", "save a PNG"},
    KeyBinding{Action::SaveScene, "S", "save the scene with this camera"},
    KeyBinding{Action::CopyCommand, "c", "copy the scene as a command line"},
    KeyBinding{Action::CopyScene, "C", "copy the scene as a scene file"},
    KeyBinding{Action::Undo, "Ctrl-Z", "undo an edit"},
    KeyBinding{Action::Redo, "Ctrl-Shift-Z", "do it again"},
    KeyBinding{Action::Redo, "Ctrl-Y", "do it again"},
    KeyBinding{Action::Reload, "r", "reload"},
    KeyBinding{Action::Panel, "Tab", "panel on or off"},
    KeyBinding{Action::Help, "F1", "this help"},
    KeyBinding{Action::Dismiss, "Escape", "close help, list, field or message"},
    KeyBinding{Action::Quit, "Ctrl-Q", "quit"},
};

}  // namespace

std::span<const KeyBinding> key_table() {
  return kTable;
}

const KeyBinding* find_key(std::string_view name) {
  const auto found = std::ranges::find(kTable, name, &KeyBinding::name);
  return found == kTable.end() ? nullptr : &*found;
}

bool types_character(const KeyBinding& key) {
  const std::string_view name = key.name;
  return name.size() == 1 || name == "Space";
}

bool works_while_typing(Action action) {
  return action == Action::Help || action == Action::Dismiss || action == Action::Quit;
}

std::string key_help() {
  std::string text;
  for (const KeyBinding& key : kTable) {
    std::string name = key.name;
    name.resize(14, ' ');
    text += name + key.help + "\n";
  }
  return text;
}

}  // namespace saddle
