#include "view/model/light_setups.h"

namespace saddle {
namespace {

constexpr int kLightSetups = 3;  // with the scene's own

Light point_light(const dvec3& position, double brightness) {
  Light light;
  light.position = position;
  light.color = {brightness, brightness, brightness};
  return light;
}

/// The setups after the scene's own: at the eye; from above, and dimly at the eye.
std::vector<Light> light_setup(int number) {
  if (number == 1) return {point_light({0, 0, 0}, 1)};
  Light above = point_light({0, 1, 0.3}, 0.9);
  above.directional = true;
  return {above, point_light({0, 0, 0}, 0.2)};
}

}  // namespace

std::vector<Light> LightSetups::next(const std::vector<Light>& shown) {
  if (number_ == 0) own_ = shown;
  number_ = (number_ + 1) % kLightSetups;
  return number_ == 0 ? own_ : light_setup(number_);
}

}  // namespace saddle
