// The panel at the left: the scene's formulas and numbers in fields, and what is known about it.
#pragma once

#include <string>
#include <utility>

#include "view/model.h"

namespace saddle {

/// What drawing takes.
struct Figures {
  std::size_t frames = 0;  ///< pictures drawn so far
  double frame_ms = 0;     ///< the last one, from scene to finished pixels
};

class Panel {
 public:
  /// Shows itself and does what the user does to it. `width` in pixels, `scale` per pixel of the
  /// user's.
  void show(Model& model, const Figures& figures, double width, double scale);

  /// Something was changed that the picture shows, since the last call.
  bool take_change() { return std::exchange(changed_, false); }

  /// The scene's error was that of a field, and is shown there.
  bool has_shown_error() const { return has_shown_error_; }

 private:
  void show_gallery(Model& model);
  void show_surface(Model& model, std::size_t index);
  void show_definitions(Model& model);
  void show_parameter(Model& model, Scene& scene, std::size_t index);
  void show_slider(Model& model, Scene& scene, Definition& definition, double number);
  void show_time(Model& model);
  void show_look(Model& model);
  void show_picked(const Model& model);
  void show_figures(const Model& model, const Figures& figures);
  void show_error_of(const Model& model, const std::string& name);
  bool field(Model& model, const std::string& label, std::string& text, bool wrong);

  bool changed_ = false;
  bool has_shown_error_ = false;
  std::string search_;
  std::string new_definition_;
  std::string refused_;  ///< why the new definition cannot be
};

}  // namespace saddle
