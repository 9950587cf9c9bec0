// The panel at the left: menus, the list of what the scene has, what is known about it, and at the
// bottom what is wrong.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "view/model/model.h"
#include "view/panel/desk.h"
#include "view/picture/drawing.h"

namespace saddle {

class Panel {
 public:
  /// `quiet`: shows no warnings. `can`: whether an action would do anything.
  Panel(bool quiet, std::function<bool(Action)> can) : quiet_(quiet), can_(std::move(can)) {}

  /// Shows itself and does what the user does to it. `width` in pixels.
  void show(Model& model, const Figures& figures, double width);

  /// Return was pressed in a field, which keeps the keyboard: what was typed is an edit of its own.
  void confirm(Model& model);
  /// That has happened since the last frame.
  bool is_confirmed() const { return is_confirmed_; }
  /// At the end of a frame.
  void end_frame() { is_confirmed_ = false; }

  /// The first field gets the keyboard.
  void enter() { enters_ = true; }

  /// The facts of the picked point are scrolled to.
  void reveal_picked() { reveals_picked_ = true; }

  /// Something was changed that the picture shows, since the last call.
  bool take_change() { return std::exchange(changed_, false); }

  /// The action that was chosen since the last call.
  std::optional<Action> take_action() { return std::exchange(action_, std::nullopt); }

 private:
  void show_list(Desk& desk, const Figures& figures);
  void show_new_definition(Desk& desk);
  void show_time(Desk& desk) const;
  void show_point(const Model& model);
  void show_errors(Desk& desk) const;
  float errors_height(const Desk& desk) const;

  bool quiet_;
  std::function<bool(Action)> can_;
  std::optional<Action> action_;
  unsigned active_ = 0;  ///< ImGui's name of the field that has the keyboard or the pointer
  bool changed_ = false;
  bool is_confirmed_ = false;  ///< Return was pressed since the last frame
  bool enters_ = false;
  bool reveals_picked_ = false;
  bool was_refused_ = false;  ///< a text that is no value of its field, in the last frame
  std::string new_definition_;
  std::optional<Error> refused_;  ///< why the new definition cannot be
};

}  // namespace saddle
