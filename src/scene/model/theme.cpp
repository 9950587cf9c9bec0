#include "scene/model/theme.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace saddle {
namespace {

/// The height of a picture, and the width in units of the height, at which lines are a pixel wide.
constexpr double kUsualHeight = 600;
constexpr double kUsualShape = 4.0 / 3;

/// Grid lines from middle to middle, in widths of a line, at the widest place of a surface: closer
/// ones leave less than three quarters of it to be seen, and of its narrower parts nothing.
constexpr double kLeastGap = 4;
/// Every third of the usual grid lines is a grid, too: they are a multiple of 3 intervals apart.
constexpr int kFewer = 3;
static_assert((kUsualGrid.u - 1) % kFewer == 0 && (kUsualGrid.v - 1) % kFewer == 0);

/// Across a point's dot, in widths of a line.
constexpr double kDotWidth = 7;

const Color kDull{0.05, 0.05, 0.05};
const Color kMatte{0, 0, 0};

const Color kContourRed{0.72, 0.05, 0.1};

/// In the order of Theme.
const std::array<ThemeLook, 3> kLooks = {
    ThemeLook{{0, 0, 0, 1},
              kLineColor,
              kContourRed,
              kFrontMaterial,
              kBackMaterial,
              dvec3(0.15),
              dvec3(0.5)},
    ThemeLook{{0.96, 0.96, 0.94, 1},
              kLineColor,
              kContourRed,
              {{1, 0.82, 0.4}, kDull, 32},
              {{0.42, 0.58, 0.95}, kDull, 32},
              dvec3(0.15),
              dvec3(0.15)},
    ThemeLook{{1, 1, 1, 1},
              {0, 0, 0},
              {0, 0, 0},
              {{1, 0.98, 0.92}, kMatte, 32},
              {{0.3, 0.33, 0.41}, kMatte, 32},
              dvec3(0),
              dvec3(0)},
};

void change_material(const Material& from, const Material& to, Material& material) {
  const auto change = [&](auto part) {
    if (material.*part == from.*part) material.*part = to.*part;
  };
  change(&Material::diffuse);
  change(&Material::specular);
  change(&Material::shininess);
  change(&Material::ambient);
  change(&Material::emission);
}

}  // namespace

const ThemeLook& look_of(Theme theme) {
  return kLooks[static_cast<std::size_t>(theme)];
}

SurfaceSpec themed_surface(Theme theme) {
  const ThemeLook& look = look_of(theme);
  SurfaceSpec surface;
  surface.front = look.front;
  surface.back = look.back;
  surface.line_color = look.lines;
  return surface;
}

void change_theme(Scene& scene, Theme theme) {
  const ThemeLook& from = look_of(scene.theme);
  const ThemeLook& to = look_of(theme);
  scene.theme = theme;
  if (scene.background == from.background) scene.background = to.background;
  for (SurfaceSpec& surface : scene.surfaces) {
    if (surface.line_color == from.lines) surface.line_color = to.lines;
    change_material(from.front, to.front, surface.front);
    change_material(from.back, to.back, surface.back);
  }
}

dvec3 ink_of(const Scene& scene) {
  const Color& background = scene.background;
  const ThemeLook& look = look_of(scene.theme);
  if (background.a < 0.5) return look.clear_ink;
  const double luma = 0.2126 * background.r + 0.7152 * background.g + 0.0722 * background.b;
  return luma < 0.5 ? dvec3(0.85) : look.dark_ink;
}

std::optional<dvec3> rim_of_letters(const Scene& scene) {
  const Color& background = scene.background;
  if (background.a < 1) return std::nullopt;
  return dvec3(background.r, background.g, background.b);
}

double fit_line_width(const dvec2& size) {
  return std::max(1.0, std::min(size.y, size.x / kUsualShape) / kUsualHeight);
}

GridSize fitting_grid(const dvec2& lengths, const dvec2& size) {
  const double gap = kLeastGap * fit_line_width(size);
  const auto fit = [gap](int lines, double length) {
    for (const int intervals : {lines - 1, (lines - 1) / kFewer}) {
      if (!(length < intervals * gap)) return intervals + 1;
    }
    return 0;
  };
  return {fit(kUsualGrid.u, lengths.x), fit(kUsualGrid.v, lengths.y)};
}

double line_width_of(const SurfaceSpec& surface, const dvec2& size) {
  if (surface.line_width) return *surface.line_width;
  return (surface.point ? kDotWidth : 1) * fit_line_width(size);
}

double contour_width_of(const SurfaceSpec& surface, const dvec2& size) {
  return kContourWidth * line_width_of(surface, size);
}

const Color& contour_color_of(const SurfaceSpec& surface, Theme theme) {
  const ThemeLook& look = look_of(theme);
  return surface.line_color == look.lines ? look.contours : surface.line_color;
}

double widest_surface_line(const Scene& scene, const dvec2& size) {
  double widest = 0;
  for (const SurfaceSpec& surface : scene.surfaces) {
    if (!surface.is_stroke()) widest = std::max(widest, line_width_of(surface, size));
  }
  return widest > 0 ? widest : fit_line_width(size);
}

double widest_contour(const Scene& scene, const dvec2& size) {
  double widest = 0;
  for (const SurfaceSpec& surface : scene.surfaces) {
    if (!surface.contours.empty()) widest = std::max(widest, contour_width_of(surface, size));
  }
  return widest;
}

double widest_line(const Scene& scene, const dvec2& size) {
  double widest = widest_contour(scene, size);
  for (const SurfaceSpec& surface : scene.surfaces) {
    widest = std::max(widest, line_width_of(surface, size));
  }
  return widest > 0 ? widest : fit_line_width(size);
}

}  // namespace saddle
