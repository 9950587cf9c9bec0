// The defaults of a scene.
#include "scene/model/scene.h"

namespace saddle {

std::vector<Light> default_lights() {
  return {
      {.position = {0, 0, 0}, .directional = false, .color = {0.6, 0.6, 0.6}},
      {.position = {0, 1, 1}, .directional = true, .color = {0.3, 0.3, 0.3}},
      {.position = {0, -1, 0}, .directional = true, .color = {0.3, 0.3, 0.3}},
  };
}

void set_time_range(Scene& scene, const Number& from, const Number& to) {
  if (!scene.animation) scene.animation.emplace();
  scene.animation->from = from;
  scene.animation->to = to;
  scene.t = from;
}

}  // namespace saddle
