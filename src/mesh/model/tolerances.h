// The table of tolerances: constants that several units of the mesher share. It defines nothing but
// numbers, so that the loops that are compiled once for each CPU level may include it.
#pragma once

#include <cstddef>

namespace saddle {

// Rounding.

/// 4 epsilon, relative to a coordinate: the rounding of a few operations. A smaller difference is
/// none. Each coordinate has its own, so that a spike in one does not swallow the others.
inline constexpr double kRounding = 0x1p-50;
/// 2 epsilon, relative to the largest coordinate: a position and a sample of the surface are each
/// rounded by up to 1/2 epsilon, and so are sums in formulas. No mesh is nearer than that.
inline constexpr double kRoundingOfPositions = 0x1p-51;
/// Relative: |r_u x r_v|^2 below this part of |r_u|^2 |r_v|^2 is 0. It is the square of
/// kDegenerateCross of surface/normal.h.
inline constexpr double kDegenerateCrossSquare = 1e-14;
/// Relative: sagittas, or squares of lengths, that differ by less are equal. Both diagonals of a
/// cell have the same on surfaces of revolution, and rounding must not choose between them.
inline constexpr double kTie = 1e-6;

// The same place.

/// In ranges of the parameters: points, poles and jumps that are nearer to each other are one.
inline constexpr double kSameParameters = 1e-9;
/// In lengths of a line of parameters: places on it that are nearer to each other, or to its end,
/// are one. A formula that has a value of its own at a jump makes two steps; a stretch of a side
/// this short is a sliver made of rounding.
inline constexpr double kSameOnLine = 1e-9;
/// In extents of the surface: points that are nearer to each other may be one. This is some digits
/// more than sin(2 pi) and its like lose, and far below a float's digits or a pixel.
inline constexpr double kSamePosition = 1e-9;
/// In diagonals of the surface: rounding of the parameters joins no points that are farther apart.
/// sin(2 pi)^0.1 is 0.03.
inline constexpr double kMostRounding = 0.05;
/// In diagonals of the surface: limits along several ways to a point that differ by less agree. A
/// smooth surface moves by 1e-6 of its size on those ways.
inline constexpr double kLimitsAgree = 1e-4;

// Directions and slopes.

/// Normals that differ by no more, in degrees, are one normal. A smaller angle is no visible
/// crease, and one corner in place of four keeps smooth poles smooth.
inline constexpr double kCreaseDegrees = 1;
/// In chords: a sample farther from its chord does not lie on a small arc, and its distance along
/// the normal is no estimate of the error.
inline constexpr double kSmallArc = 0.3;
/// Cosine of 60 degrees: an arc whose normal turns farther from the chord's is no polynomial of
/// fourth order.
inline constexpr double kSteepCosine = 0.5;
/// In chords: a sample farther from the chord's middle does not show an arc's height.
inline constexpr double kAsideOfMiddle = 0.2;

// A point straight above a triangle.

/// In longest sides of the triangle: a point that is farther aside is not above it. Curvature adds
/// a third to its height at most.
inline constexpr double kMostAside = 0.3;
/// In longest sides of the triangle: a point that is higher belongs to another front, which the
/// triangle bridges.
inline constexpr double kMostAbove = 0.1;

// Samples.

/// In sides of a cell: the largest random offset of a sample from the place where the error of a
/// parabola is largest. It then shows 1 - (2 * 0.1)^2 = 96 % of that error at least.
inline constexpr double kSampleJitter = 0.1;

// Counts.

/// Halvings of a line until there are no doubles between its ends. Next to 0 doubles go on: there
/// 1e-30 of the line is left.
inline constexpr int kAllHalvings = 100;
/// Halvings of a line towards a pole at 0, beside which doubles go down to 2^-1074.
inline constexpr int kHalvingsToLeast = 1100;
/// Cells and lines each way that a cell tree can number.
inline constexpr std::size_t kMostCellsEachWay = 60'000;
/// Places of a kind that a report names; it counts the others.
inline constexpr std::size_t kMaxListed = 1000;

}  // namespace saddle
