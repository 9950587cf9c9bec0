#include "by_hand.h"

#include <cmath>

namespace saddle {

void torus_by_hand(const std::vector<double>& us, const std::vector<double>& vs, float* to) {
  std::vector<double> cos_u(us.size());
  std::vector<double> sin_u(us.size());
  for (std::size_t i = 0; i < us.size(); ++i) {
    cos_u[i] = std::cos(us[i]);
    sin_u[i] = std::sin(us[i]);
  }
  for (const double v : vs) {
    const double cos_v = std::cos(v);
    const double sin_v = std::sin(v);
    const double radius = 2 + cos_v;
    for (std::size_t i = 0; i < us.size(); ++i, to += 6) {
      to[0] = static_cast<float>(radius * cos_u[i]);
      to[1] = static_cast<float>(radius * sin_u[i]);
      to[2] = static_cast<float>(sin_v);
      to[3] = static_cast<float>(cos_v * cos_u[i]);
      to[4] = static_cast<float>(cos_v * sin_u[i]);
      to[5] = static_cast<float>(sin_v);
    }
  }
}

void enneper_by_hand(const std::vector<double>& us, const std::vector<double>& vs, float* to) {
  for (const double v : vs) {
    const double vv = v * v;
    const double v_part = v - v * vv / 3;
    for (const double u : us) {
      // The normal is (-2u, 2v, 1 - u^2 - v^2) / (1 + u^2 + v^2) up to sign.
      const double uu = u * u;
      const double shrink = 1 / (1 + uu + vv);
      to[0] = static_cast<float>(u - u * uu / 3 + u * vv);
      to[1] = static_cast<float>(v_part + uu * v);
      to[2] = static_cast<float>(uu - vv);
      to[3] = static_cast<float>(-2 * u * shrink);
      to[4] = static_cast<float>(2 * v * shrink);
      to[5] = static_cast<float>((1 - uu - vv) * shrink);
      to += 6;
    }
  }
}

}  // namespace saddle
