#include "view/model/actions.h"

#include <algorithm>
#include <array>

namespace saddle {
namespace {

constexpr auto kTable = std::to_array<ActionRow>({
    {Action::Start, "Start page", "", Menu::File, "the gallery in pictures, and recent files"},
    {Action::New, "New", "Ctrl-N", Menu::File, "a new scene: a saddle"},
    {Action::Open, "Open ...", "Ctrl-O", Menu::File,
     "open a scene file, or a picture with a scene"},
    {Action::Gallery, "Gallery ...", "Ctrl-G", Menu::File, "choose a surface of the gallery"},
    {Action::SavePicture, "Save picture", "s", Menu::File, "save a PNG"},
    {Action::SaveScene, "Save scene", "S", Menu::File, "save the scene with this camera"},
    {Action::Export, "Export ...", "Ctrl-E", Menu::File,
     "write a file of any format: picture, mesh, page, film"},
    {Action::SavePage, "Save page", "", Menu::File, "save a page that draws it in a browser"},
    {Action::CopyCommand, "Copy as command", "c", Menu::File, "copy the scene as a command line"},
    {Action::CopyScene, "Copy as scene", "C", Menu::File, "copy the scene as a scene file"},
    {Action::Restore, "Unsaved work", "", Menu::File, "bring back work that was not saved",
     Needs::Work},
    {Action::Reload, "Reload", "r", Menu::File, "read the scene again from where it came from",
     Needs::Source},
    {Action::Quit, "Quit", "Ctrl-Q", Menu::File, "quit"},
    {Action::Undo, "Undo", "Ctrl-Z", Menu::Edit, "undo a change", Needs::Past},
    {Action::Redo, "Redo", "Ctrl-Shift-Z", Menu::Edit, "do it again", Needs::Future},
    {Action::Redo, "Redo", "Ctrl-Y", Menu::None, "do it again", Needs::Future},
    {Action::AddSurface, "Add surface", "", Menu::Edit, "add a surface to the scene"},
    {Action::AddCurve, "Add curve", "", Menu::Edit, "add a curve in space"},
    {Action::AddPoint, "Add point", "", Menu::Edit, "add a point"},
    {Action::AddLight, "Add light", "", Menu::Edit, "add a light at the eye"},
    {Action::Fit, "Fit", "Home", Menu::View, "fit the surface into the picture"},
    {Action::AlongX, "Along x", "x", Menu::View, "look along x; again: from the other side"},
    {Action::AlongY, "Along y", "y", Menu::View, "look along y"},
    {Action::AlongZ, "Along z", "z", Menu::View, "look along z"},
    {Action::Orthographic, "Orthographic", "o", Menu::View, "orthographic or perspective"},
    {Action::Turntable, "Turntable", "t", Menu::View,
     "turn as on a table, about the up axis, or freely, as a ball"},
    {Action::Play, "Play", "Space", Menu::View, "play t; stop what plays", Needs::Movement},
    {Action::Panel, "Panel", "F2", Menu::View, "panel on or off"},
    {Action::FullScreen, "Full screen", "F11", Menu::View, "the whole screen, or a window"},
    {Action::Grid, "Grid lines", "g", Menu::Look, "grid lines on or off"},
    {Action::Axes, "Axes", "a", Menu::Look, "the box around the surface, with ticks"},
    {Action::Wireframe, "Triangles", "w", Menu::Look, "triangles as wires"},
    {Action::Normals, "Normals", "n", Menu::Look, "normals"},
    {Action::Flip, "Flip", "f", Menu::Look, "swap front and back", Needs::Surface},
    {Action::NextLights, "Next lights", "l", Menu::Look,
     "next light setup: the scene's, at the eye, from above"},
    {Action::ShadeVertices, "Shade corners", "1", Menu::Look, "colours of corners, blended"},
    {Action::ShadePixels, "Shade pixels", "2", Menu::Look, "lighting of each pixel"},
    {Action::ShadeExactly, "Shade exactly", "3", Menu::Look,
     "the same, with the normal of the formula"},
    {Action::Coarser, "Coarser", "[", Menu::Look, "coarser mesh: twice the tolerance"},
    {Action::Finer, "Finer", "]", Menu::Look, "finer mesh: half the tolerance"},
    {Action::Actions, "All actions ...", "Ctrl-P", Menu::Help,
     "find an action by its name, and do it"},
    {Action::Help, "Keys", "F1", Menu::Help, "this help"},
    {Action::Dismiss, "Dismiss", "Escape", Menu::None, "close help, list, field or message"},
});

/// The pointer and what it does, for people to read.
constexpr std::array<std::array<const char*, 2>, 6> kGestures{{
    {"Left drag", "turn the surface, as if it were in a ball that fills the picture"},
    {"Right drag", "move it, as Shift with the left button does"},
    {"Wheel", "nearer or farther: the point under the pointer stays there"},
    {"Double click", "pick a point: its u, v, x, y, z, normal and curvatures"},
    {"Drop a file", "open it"},
    {"Tab", "the next field, with Shift the one before"},
}};

constexpr std::size_t kColumn = 14;

std::string line(std::string left, const char* right) {
  left.resize(kColumn, ' ');
  return left + right + "\n";
}

}  // namespace

std::span<const ActionRow> action_table() {
  return kTable;
}

const char* lack_of(Needs needs) {
  constexpr std::array kLacks{"",
                              "there is nothing to undo",
                              "there is nothing to redo",
                              "nothing depends on t: write t into a formula, such as sin(u+t)",
                              "this scene came from no file: Ctrl-O opens one",
                              "there is no unsaved work",
                              "there is no surface"};
  return kLacks[static_cast<std::size_t>(needs)];
}

const ActionRow& row_of(Action action) {
  return *std::ranges::find(kTable, action, &ActionRow::action);
}

const char* title_of(Menu menu) {
  constexpr std::array kTitles{"", "File", "Edit", "View", "Look", "Help"};
  return kTitles[static_cast<std::size_t>(menu)];
}

const ActionRow* find_key(std::string_view name) {
  if (name.empty()) return nullptr;
  const auto found = std::ranges::find(kTable, name, &ActionRow::key);
  return found == kTable.end() ? nullptr : &*found;
}

bool types_character(const ActionRow& row) {
  const std::string_view key = row.key;
  return key.size() == 1 || key == "Space";
}

bool works_while_typing(Action action) {
  switch (action) {
    case Action::New:
    case Action::Open:
    case Action::Gallery:
    case Action::Export:
    case Action::Actions:
    case Action::Panel:
    case Action::FullScreen:
    case Action::Help:
    case Action::Dismiss:
    case Action::Quit:
      return true;
    default:
      return false;
  }
}

std::string key_help() {
  std::string text;
  for (const auto& [gesture, help] : kGestures) text += line(gesture, help);
  for (const ActionRow& row : kTable) {
    if (*row.key != 0) text += line(row.key, row.help);
  }
  return text;
}

}  // namespace saddle
