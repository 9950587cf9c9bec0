// All parts of the panel share this: the scene that they edit, and what a hand did to
// them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/error.h"
#include "view/model/model.h"

namespace saddle {

struct Desk {
  Model& model;
  bool is_confirmed = false;        ///< Return was pressed in a field since the last frame
  std::optional<Action> action;     ///< that was asked for
  std::optional<Error> refused;     ///< of a text that is no value of its field
  std::function<bool(Action)> can;  ///< whether the action would do anything

  const Scene& scene() const { return model.scene(); }
  /// Makes a change to the scene; `what` as in Model::edit().
  void edit(const std::string& what, const std::function<void(Scene&)>& change) const {
    Scene scene = model.scene();
    change(scene);
    model.edit(std::move(scene), what);
  }
  /// The scene's error is about the thing of this name: "x", or "f" of "f(s)".
  bool is_wrong(const std::string& name) const {
    return model.error() && model.error()->place().name == name;
  }
  /// The same of an object at this place among surfaces, then curves, then points.
  bool is_wrong(const std::string& name, std::size_t place) const {
    return is_wrong(name) && model.faulty() && model.faulty()->place == place;
  }
};

}  // namespace saddle
