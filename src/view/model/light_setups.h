// Lights that the viewer shows a scene in, one setup after the other.
#pragma once

#include <vector>

#include "scene/model/scene.h"

namespace saddle {

/// The first setup is the scene's own lights.
class LightSetups {
 public:
  /// The lights of the next setup. `shown`: the scene's lights as they are.
  std::vector<Light> next(const std::vector<Light>& shown);

  /// The same setup is shown.
  bool operator==(const LightSetups& other) const { return number_ == other.number_; }

 private:
  int number_ = 0;
  std::vector<Light> own_;  ///< while another setup is shown
};

}  // namespace saddle
