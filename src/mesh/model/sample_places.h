// Places on a line and in a box, and directions around a place, at which several units of the
// mesher look.
#pragma once

#include <array>

#include "base/vec.h"

namespace saddle {

/// The middle of a line, where an arc is farthest from its chord.
inline constexpr std::array kMiddleOfLine = {0.5};
/// Beside the middle: an arc with a turning point there, or a vertical tangent at an end, is
/// farthest from its chord about here.
inline constexpr std::array kBesideMiddle = {0.25, 0.75};
/// The middle and both places beside it: an edge that turns in the middle is not missed.
inline constexpr std::array kAlongLine = {0.25, 0.5, 0.75};
/// These and both ends.
inline constexpr std::array kAllAlongLine = {0.0, 0.25, 0.5, 0.75, 1.0};

/// In a leaf or a box, in parts of its sides: the middle, and places apart from its lines of
/// symmetry.
inline constexpr std::array kPlacesInBox = {dvec2(0.5, 0.5), dvec2(0.3, 0.2), dvec2(0.8, 0.3),
                                            dvec2(0.7, 0.8), dvec2(0.2, 0.7)};

/// On the way away from a place, one after the other: what is near the place counts most.
inline constexpr std::array kAwayFromPlace = {0.0625, 0.25, 0.5, 1.0};

/// The first step of a compass search, in sizes of what is searched. Later steps are halves of it.
inline constexpr double kCompassStep = 0.25;
/// The directions of its steps.
inline constexpr std::array kFourWays = {dvec2(1, 0), dvec2(-1, 0), dvec2(0, 1), dvec2(0, -1)};
/// Axes and diagonals in their order around a place: opposite ones are four apart.
inline constexpr std::array kEightWays = {dvec2(1, 0),  dvec2(1, 1),   dvec2(0, 1),  dvec2(-1, 1),
                                          dvec2(-1, 0), dvec2(-1, -1), dvec2(0, -1), dvec2(1, -1)};

}  // namespace saddle
