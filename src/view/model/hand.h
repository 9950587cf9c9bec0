// The pointer's hold on the camera: drags and the wheel over the picture.
#pragma once

#include <optional>

#include "view/model/controls.h"
#include "view/model/model.h"

namespace saddle {

/// Pixels are those of the picture, from its upper left.
class Hand {
 public:
  /// Takes hold: the left button (0) turns, any other and Shift move.
  void press(const Model& model, const dvec2& pixel, int button, bool shift);
  /// Lets go: what was moved since is one change.
  void release(Model& model, int button);

  /// True if the camera has moved.
  bool move(Model& model, const dvec2& pixel) const;

  /// Nearer or farther, by notches of the wheel; lets go.
  void scroll(Model& model, const dvec2& pixel, double notches);

 private:
  struct Hold {
    bool turns = true;
    int button = 0;
    Grip grip;
    dvec2 from{0, 0};
    dvec3 held{0, 0, 0};
  };
  std::optional<Hold> hold_;
};

}  // namespace saddle
