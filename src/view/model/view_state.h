// All that a person changes in the window: the scene, and how it is shown.
#pragma once

#include <optional>

#include "base/vec.h"
#include "scene/model/scene.h"
#include "view/model/light_setups.h"

namespace saddle {

/// How a parameter that plays goes between its ends.
enum class PlayManner { ToAndFro, Again, Once };

/// How the window shows a scene, beside what the scene says.
struct ViewState {
  bool grid = true;  ///< grid lines
  bool wireframe = false;
  bool normals = false;
  bool panel = true;
  bool playing = false;     ///< t
  bool turntable = false;   ///< a hand turns on a table, not on a ball
  dvec3 table_up{0, 0, 1};  ///< the table's axis
  double speed = 1;         ///< of t, in that of the animation's film
  PlayManner manner = PlayManner::ToAndFro;
  LightSetups lights;  ///< which setup is shown

  bool operator==(const ViewState&) const = default;
};

/// The camera as an animation was fitted into the picture, and as it was before.
struct FramedCamera {
  Camera after;
  Camera before;
};

/// The state that undo and redo go to.
struct State {
  Scene scene;
  ViewState view;
  std::optional<FramedCamera> framed = {};
};

}  // namespace saddle
