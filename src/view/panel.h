// The panel at the left: the scene's formulas and numbers in fields, and what is known about it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "view/drawing.h"
#include "view/model.h"

namespace saddle {

class Panel {
 public:
  /// `quiet`: shows no warnings.
  explicit Panel(bool quiet) : quiet_(quiet) {}

  /// Shows itself and does what the user does to it. `width` in pixels, `scale` per pixel of the
  /// user's.
  void show(Model& model, const Figures& figures, double width, double scale);

  /// Return was pressed in a field, which keeps the keyboard: what was typed is an edit of its own.
  void confirm(Model& model);

  /// Something was changed that the picture shows, since the last call.
  bool take_change() { return std::exchange(changed_, false); }

  /// The action of a button that was pressed since the last call.
  std::optional<Action> take_action() { return std::exchange(action_, std::nullopt); }

  /// The scene's error was that of a field, and is shown there.
  bool has_shown_error() const { return has_shown_error_; }

 private:
  void show_buttons();
  void show_gallery(Model& model);
  void show_surface(Model& model, std::size_t index);
  void show_definitions(Model& model);
  void show_colormaps(Model& model, const Scene& scene, SurfaceSpec& spec);
  /// A definition of the scene, or one of a surface's own.
  struct Parameter {
    Definition& definition;
    std::vector<Slider>& sliders;
    std::string owner;  ///< name of the surface
    bool may_be_wrong;  ///< the error may be about it
  };
  void show_parameter(Model& model, const Scene& scene, const Parameter& parameter);
  void show_choices(Model& model, const Scene& scene, const Parameter& parameter,
                    const std::vector<std::string>& choices);
  void show_slider(Model& model, const Scene& scene, const Parameter& parameter, double number);
  void show_time(Model& model);
  void show_look(Model& model);
  void show_shading(const Model& model);
  void show_lights(Model& model);
  void show_tolerance(Model& model);
  void show_picked(const Model& model);
  void show_figures(const Model& model, const Figures& figures);
  void show_warnings(const std::vector<std::string>& warnings) const;
  void show_error_of(const Model& model, const std::string& name);

  bool quiet_;
  std::optional<Action> action_;
  unsigned active_ = 0;  ///< ImGui's name of the field that has the keyboard or the pointer
  bool changed_ = false;
  bool is_confirmed_ = false;  ///< Return was pressed since the last frame
  bool has_shown_error_ = false;
  std::string search_;
  std::string new_definition_;
  std::string refused_;  ///< why the new definition cannot be
};

}  // namespace saddle
