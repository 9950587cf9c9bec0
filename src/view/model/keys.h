// The keys of the viewer: one table for the program, its help and its page.
#pragma once

#include <span>
#include <string>

namespace saddle {

enum class Action {
  Grid,
  Axes,
  Wireframe,
  Normals,
  Flip,
  NextLights,
  ShadeVertices,
  ShadePixels,
  ShadeExactly,
  Orthographic,
  Turntable,
  AlongX,
  AlongY,
  AlongZ,
  Fit,
  Play,
  Coarser,
  Finer,
  SavePicture,
  SaveScene,
  CopyCommand,
  CopyScene,
  Undo,
  Redo,
  Reload,
  Panel,
  Help,
  Dismiss,
  Quit,
};

/// A key, as GLFW numbers it and as people call it. Keys that type a character are known by the
/// character, wherever the keyboard has it; the others by the key.
struct KeyBinding {
  Action action;
  const char* name;  ///< "g", "Home", "Ctrl-Z"
  const char* help;
};

std::span<const KeyBinding> key_table();

/// The binding of a character, or of a special key by its name; nullptr if there is none.
const KeyBinding* find_key(std::string_view name);

/// The key types a character, so it is for fields alone while text is edited.
bool types_character(const KeyBinding& key);

/// The action's key does the same in a field and in a list.
bool works_while_typing(Action action);

/// The table as text, a line each.
std::string key_help();

}  // namespace saddle
