// The window as a place to work in: what its tests share.
#pragma once

#include <functional>
#include <string>

#include "scene/model/scene.h"
#include "view/window/viewer.h"
#include "viewer/display.h"

namespace saddle {

/// GLFW's numbers of keys.
constexpr int kReturn = 257;
constexpr int kEscape = 256;
constexpr int kDown = 264;

/// The viewer in this process, with events that are made up.
class Workplace : public ViewerHere {
 protected:
  static ViewerSetup setup_of(Scene scene);
  static Scene entry(const char* name);
  /// Steps until something is so; false if that takes too long.
  static bool until(Viewer& viewer, const std::function<bool()>& is_so);
  static bool rests(Viewer& viewer);
  static void receive_key(Viewer& viewer, const std::string& name, int code = 0);
  static void receive_text(Viewer& viewer, const std::string& text);
  /// Until nothing of what was received waits any more.
  static void settle(Viewer& viewer);
  static void key(Viewer& viewer, const std::string& name, int code = 0);
  static void type(Viewer& viewer, const std::string& text);
  static void drop(Viewer& viewer, const std::string& file);
  /// Opens a list, types, and takes what is first, faster than the window shows it.
  static void choose(Viewer& viewer, const std::string& list, const std::string& words);
  static void press_at(Viewer& viewer, const dvec2& place);
  /// Another window is closed after this was typed behind its z, u*v.
  void leave_work(const std::string& typed);
  /// The formula z of another window's work, which is there now.
  static std::string work_brought_back(Viewer& viewer);
  void write(const std::string& name, const std::string& text) const;
};

}  // namespace saddle
