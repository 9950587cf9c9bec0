// The box that a surface is clipped to without one of the user's: where it goes to infinity, or
// outgrows its picture.
#pragma once

#include <optional>
#include <span>

#include "base/bounds.h"
#include "base/numbers.h"

namespace saddle {

/// The box that a surface which goes to infinity is clipped to, if `points` (finite) are spread
/// over it. `all` is around everything that was seen, and decides in which coordinates the surface
/// goes far beyond most of the points. There the box has what most of them keep to, and less of
/// that if it is much longer than the box's other sides; in the others it has `usual`, the box
/// around samples that are not beside poles.
Bounds clip_box(const Bounds& all, const Bounds& usual, std::span<const dvec3> points);

/// Beside a side that is so many times as long, the others are narrower than a pixel.
inline constexpr double kNeedle = 1000;

/// The box for a surface that outgrows its picture: one side is so long that the others are no
/// wider than a pixel, while a part of the points (finite) is in proportion. Its faces are
/// infinitely far where no point is beyond. Nothing for other surfaces. Where it is only the edges
/// of the domain that go so far, as that of tan(u) at u = pi / 2, which is no pole in double
/// precision, it is clip_box() without the faces that are not needed.
std::optional<Bounds> readable_box(const Bounds& all, std::span<const dvec3> points);

}  // namespace saddle
