// The actions of the viewer: one table that keys, menus, the list of actions, the help, and the
// page about the viewer are made from.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace saddle {

enum class Action {
  Start,
  New,
  Open,
  Gallery,
  SavePicture,
  SaveScene,
  SavePage,
  CopyCommand,
  CopyScene,
  Restore,
  Reload,
  Quit,
  Undo,
  Redo,
  AddSurface,
  AddCurve,
  AddPoint,
  AddLight,
  Play,
  Orthographic,
  Turntable,
  AlongX,
  AlongY,
  AlongZ,
  Fit,
  Panel,
  FullScreen,
  Grid,
  Axes,
  Wireframe,
  Normals,
  Flip,
  NextLights,
  ShadeVertices,
  ShadePixels,
  ShadeExactly,
  Coarser,
  Finer,
  Actions,
  Help,
  Dismiss,
};

/// The menu that an action is in. None: it has a key alone.
enum class Menu { None, File, Edit, View, Look, Help };

/// An action does nothing without it.
enum class Needs { Nothing, Past, Future, Movement, Source, Work, Surface };

/// A row of the table. A key that types a character is known by the character, wherever the
/// keyboard has it; the others by the key.
struct ActionRow {
  Action action;
  const char* name;  ///< as menus have it; rows of one action have one name
  const char* key;   ///< "g", "Home", "Ctrl-Z"; empty: none
  Menu menu;
  const char* help;
  Needs needs = Needs::Nothing;
};

std::span<const ActionRow> action_table();

/// Why an action does nothing without what it needs.
const char* lack_of(Needs needs);

/// The first row of an action.
const ActionRow& row_of(Action action);

/// "File"
const char* title_of(Menu menu);

/// The row of a character, or of a special key by its name; nullptr if there is none.
const ActionRow* find_key(std::string_view name);

/// The key types a character, so it is for fields alone while text is edited.
bool types_character(const ActionRow& row);

/// The action's key does the same in a field and in a list.
bool works_while_typing(Action action);

/// All gestures and keys, a line each.
std::string key_help();

}  // namespace saddle
