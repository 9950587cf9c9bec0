// Themes: backgrounds, lines, letters and materials that suit each other.
#pragma once

#include <optional>

#include "base/vec.h"
#include "scene/model/scene.h"

namespace saddle {

struct ThemeLook {
  Color background;
  Color lines;     ///< of the grid on surfaces
  Color contours;  ///< level lines
  Material front;
  Material back;
  dvec3 dark_ink;   ///< of letters and axes on a light background: red, green, blue
  dvec3 clear_ink;  ///< on a transparent one
};

/// In `paper`, printed in grey, background, front, back and lines differ by more than 0.1 of the
/// way from black to white wherever the default lights meet a side at 60 degrees or steeper.
const ThemeLook& look_of(Theme theme);

/// A surface with the theme's lines and materials, all else as it is by default.
SurfaceSpec themed_surface(Theme theme);

/// Gives the scene another theme: each part that is the old theme's becomes the new one's.
void change_theme(Scene& scene, Theme theme);

/// Letters and axes on the scene's background: light on a dark one, dark on a light one.
dvec3 ink_of(const Scene& scene);

/// The colour around letters, the background's; none on a transparent one, for which nothing suits.
std::optional<dvec3> rim_of_letters(const Scene& scene);

/// Pixels of the lines in a picture of this size where nothing else is said: 1 in one of 800x600.
/// Larger pictures have wider lines. Smaller ones do not have thinner lines, which would fade.
double fit_line_width(const dvec2& size);

/// The grid of a surface that says nothing of its own, in a picture of this size. Its longest lines
/// of constant v have `lengths.x` pixels, those of constant u `lengths.y`. The usual lines; every
/// third of them where they would be too close to tell apart; none where even these would be.
GridSize fitting_grid(const dvec2& lengths, const dvec2& size);

/// Pixels of the lines on a surface, or of the line or the dot across that it stands for.
double line_width_of(const SurfaceSpec& surface, const dvec2& size);

/// The width of level lines, in widths of a grid line, by which they stand out from the grid.
inline constexpr double kContourWidth = 2;
/// Their colour is the theme's own unless the surface has another colour of lines than the theme.
double contour_width_of(const SurfaceSpec& surface, const dvec2& size);
const Color& contour_color_of(const SurfaceSpec& surface, Theme theme);

/// Pixels of the widest level lines; 0 without any.
double widest_contour(const Scene& scene, const dvec2& size);

/// Pixels of the widest grid lines on surfaces.
double widest_surface_line(const Scene& scene, const dvec2& size);

/// Pixels of the widest lines of all, and of dots across.
double widest_line(const Scene& scene, const dvec2& size);

}  // namespace saddle
