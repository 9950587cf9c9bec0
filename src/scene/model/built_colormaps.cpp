#include "scene/model/built_colormaps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace saddle {
namespace {

constexpr double kPi = std::numbers::pi;

/// Linear sRGB to XYZ, row by row. Source: IEC 61966-2-1:1999.
constexpr std::array<std::array<double, 3>, 3> kToXyz = {
    {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};

/// GLM's matrices stand column by column.
glm::dmat3 to_xyz() {
  glm::dmat3 m;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      m[column][row] = kToXyz[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }
  }
  return m;
}

double linear(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double encoded(double c) {
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

/// The cube root of CIELAB and its inverse, straight near 0. Source: CIE 15:2004.
constexpr double kKnee = 6.0 / 29;
double root(double x) {
  return x > kKnee * kKnee * kKnee ? std::cbrt(x) : x / (3 * kKnee * kKnee) + 4.0 / 29;
}
double cube(double y) {
  return y > kKnee ? y * y * y : 3 * kKnee * kKnee * (y - 4.0 / 29);
}

/// Magnitude, saturation and hue: spherical coordinates of CIELAB. Source: Moreland 2009.
struct Msh {
  double m, s, h;
};

Msh msh_of(const dvec3& lab) {
  const double m = glm::length(lab);
  return {m, std::acos(lab.x / m), std::atan2(lab.z, lab.y)};
}

dvec3 lab_of_msh(const Msh& c) {
  return {c.m * std::cos(c.s), c.m * std::sin(c.s) * std::cos(c.h),
          c.m * std::sin(c.s) * std::sin(c.h)};
}

/// The hue of the unsaturated end of a way from `end`: the way bends to keep its lightness even.
double hue_toward(const Msh& end, double m) {
  if (end.m >= m) return end.h;
  const double spin = end.s * std::sqrt(m * m - end.m * end.m) / (end.m * std::sin(end.s));
  return end.h > -kPi / 3 ? end.h + spin : end.h - spin;
}

/// From an end of the map, at 0, to its unsaturated middle, at 1.
dvec3 toward_middle(const Msh& end, double middle, double x) {
  const double hue = hue_toward(end, middle);
  return lab_of_msh({end.m + (middle - end.m) * x, end.s * (1 - x), end.h + (hue - end.h) * x});
}

double degrees(double angle) {
  return angle * kPi / 180;
}

}  // namespace

dvec3 lab_of(const dvec3& srgb) {
  const glm::dmat3 m = to_xyz();
  const dvec3 white = m * dvec3(1);
  const dvec3 xyz = m * dvec3(linear(srgb.x), linear(srgb.y), linear(srgb.z)) / white;
  const dvec3 f(root(xyz.x), root(xyz.y), root(xyz.z));
  return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

dvec3 srgb_of(const dvec3& lab) {
  const glm::dmat3 m = to_xyz();
  const double y = (lab.x + 16) / 116;
  const dvec3 f(y + lab.y / 500, y, y - lab.z / 200);
  const dvec3 rgb = glm::inverse(m) * (m * dvec3(1) * dvec3(cube(f.x), cube(f.y), cube(f.z)));
  const dvec3 kept = glm::clamp(rgb, 0.0, 1.0);
  return {encoded(kept.x), encoded(kept.y), encoded(kept.z)};
}

BuiltColormap built_coolwarm() {
  // The paper's ends, and the least magnitude of its middle.
  const Msh cool = msh_of(lab_of(dvec3(59, 76, 192) / 255.0));
  const Msh warm = msh_of(lab_of(dvec3(180, 4, 38) / 255.0));
  const double middle = std::max({cool.m, warm.m, 88.0});
  BuiltColormap map;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const double x = 2 * static_cast<double>(i) / (kBuiltColors - 1);
    map[i] = srgb_of(x <= 1 ? toward_middle(cool, middle, x) : toward_middle(warm, middle, 2 - x));
  }
  return map;
}

BuiltColormap built_twilight() {
  // Between these lightnesses sRGB has all of the hues below with their chroma.
  constexpr double kLight = 88;
  constexpr double kDark = 20;
  constexpr double kDarkChroma = 24;  // of the middle
  constexpr double kSideChroma = 26;  // more of it halfway
  constexpr double kDarkHue = 310;    // degrees: purple
  constexpr double kBlueHue = 235;    // of the light end, on either side
  constexpr double kRoseHue = 400;
  BuiltColormap map;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const double x = 2 * static_cast<double>(i) / (kBuiltColors - 1);
    const double depth = x <= 1 ? x : 2 - x;
    const double end = x <= 1 ? kBlueHue : kRoseHue;
    const double hue = degrees(end + (kDarkHue - end) * depth);
    const double chroma = kDarkChroma * depth + kSideChroma * std::sin(kPi * depth);
    map[i] = srgb_of(
        {kLight + (kDark - kLight) * depth, chroma * std::cos(hue), chroma * std::sin(hue)});
  }
  return map;
}

}  // namespace saddle
