// The table of tolerances: constants that several units of the mesher share. It defines nothing but
// numbers, so that the loops that are compiled once for each CPU level may include it.
#pragma once

#include <cstddef>

namespace saddle {

// Rounding.

/// 4 epsilon, relative to a coordinate: the rounding of a few operations. A smaller difference is
/// none, and no mesh is nearer to its surface: both are rounded. Each coordinate has its own, so
/// that a spike in one does not swallow the others.
inline constexpr double kRounding = 0x1p-50;
/// Relative: |r_u x r_v|^2 below this part of |r_u|^2 |r_v|^2 is 0. It is the square of
/// kDegenerateCross of surface/normal.h.
inline constexpr double kDegenerateCrossSquare = 1e-14;
/// Relative: the rounding of a sum over a mesh, or of a product of sums.
inline constexpr double kRoundingOfSums = 1e-12;

// The same place or number.

/// Numbers, parameters and points are the same if they differ by no more than this part of their
/// ranges: some digits more than sin(2 pi) and its like lose, and far below a float's digits or a
/// pixel. On a line of parameters, a range is its length: a formula that has a value of its own at
/// a jump makes two steps; a stretch of a side this short is a sliver made of rounding.
inline constexpr double kSame = 1e-9;
/// A part of a range: sheets as thin are made of rounding, as that of floor(cos(u)), which is 1 as
/// far as sqrt(2^-52) from 0.
inline constexpr double kSliver = 0x1p-25;
/// The same for what is derived from them with fewer digits: lengths, areas, limits. Both diagonals
/// of a cell have the same sagitta on surfaces of revolution, and rounding must not choose. Double
/// zeros are known to 1e-8.
inline constexpr double kNearly = 1e-6;
/// In parts of a side of a leaf: jumps that are nearer to each other are close, and so are foot and
/// head of a cliff.
inline constexpr double kClose = 0.25;
/// As a part of a range, a box or a diagonal: what is farther from the rest is apart from it. It is
/// four of the probe's kDomainParts.
inline constexpr double kFarApart = 1.0 / 16;
/// In diagonals of the surface: rounding of the parameters joins no points that are farther apart.
/// sin(2 pi)^0.1 is 0.03.
inline constexpr double kMostRounding = 0.05;
/// In diagonals of the surface: limits along several ways to a point that differ by less agree. A
/// smooth surface moves by 1e-6 of its size on those ways.
inline constexpr double kLimitsAgree = 1e-4;
/// A move, gap or error that is less than this part of the one before goes to 0: a root of order 12
/// moves by 0.79 of its last move on a way 16 times as short, ln by all of it. By a halving the
/// error of a smooth arc falls to 0.25, of a kink to 0.5, of a vertical tangent to 0.71.
inline constexpr double kShrinks = 0.8;
/// A factor: differences that keep within it towards a point stay as they are. If they shrink by
/// more they are on their way to agree; if they grow by more they are a pole or rounding.
inline constexpr double kStays = 2;

// Directions and slopes.

/// Normals that differ by no more, in degrees, are one normal. A smaller angle is no visible
/// crease, and one corner in place of four keeps smooth poles smooth. An edge that turns by more in
/// one place has a corner.
inline constexpr double kCreaseDegrees = 1;
/// An edge that turns by less in all is smooth, and normals that are off by less no sharp bend.
inline constexpr double kSharpDegrees = 10;
/// In chords: a sample farther from its chord does not lie on a small arc, and its distance along
/// the normal is no estimate of the error.
inline constexpr double kSmallArc = 0.3;
/// Cosine of 60 degrees: normals farther apart are not alike, and an arc whose normal turns farther
/// from the chord's is no polynomial of fourth order.
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
/// In even stretches of the domain: the largest shift of a line from the middle of its stretch. A
/// surface that oscillates in step with an even grid is not in step with this one.
inline constexpr double kLineJitter = 0.4;

// Errors.

/// In tolerances: a sampled error raises the safety of a leaf's halves by no more. At a kink it
/// says nothing about the size of leaves. A part of the surface without triangles is this far off.
inline constexpr double kMostSafety = 4;

/// In tolerances: gaps, bends and parts of lines up to this size do not show.
inline constexpr double kUnnoticed = 0.25;
/// A distance, or the bound of one, matters beside the largest known one if it is larger by this
/// factor.
inline constexpr double kMatters = 1.02;

// Counts.

/// Parts of the domain each way in which features are told apart: the columns and rows of a probe's
/// samples, the blocks of a search, the boxes that a report unites.
inline constexpr std::size_t kDomainParts = 64;
/// Sides, leaves or vertices that are worked on together, between two checks of a budget: some
/// milliseconds if each takes hundreds of evaluations.
inline constexpr std::size_t kInBatch = 512;
/// Samples that stand for all of a surface or curve, where its size or kind is asked.
inline constexpr std::size_t kStandForAll = 1024;
/// At least so many places on a line, or at one point of space, are taken together: seams and
/// crossings of sheets have fewer.
inline constexpr std::size_t kManyOfLine = 12;
/// Places or leaves that a search begins with, the worst first: most searches find nothing more.
inline constexpr std::size_t kFirstSearched = 8;
/// As a part of the work that a mesh took: what proofs and the search for its largest error may.
inline constexpr double kShareOfMesh = 0.25;
/// Triangles of a leaf of a tree that finds the nearest ones.
inline constexpr std::size_t kTrianglesOfNode = 4;
/// Vertices or leaves whose columns of results are kept at a time: 1.4 to 3 MB, and work for all
/// threads.
inline constexpr std::size_t kKeptAtATime = 1 << 14;
/// Boxes, leaves or places of a search that are worked on together. In between, what it has found
/// decides what is left to search.
inline constexpr std::size_t kSearchedTogether = 64;

/// Boxes or leaves of a search that are open at a time, and undefined boxes that are kept, the
/// largest first: along a curve the boxes of a level double every two levels. Once there were more,
/// kMostFollowed boxes stand for all.
inline constexpr std::size_t kMostOpen = 256;
/// Boxes or places of a kind that are followed one by one: more are along curves.
inline constexpr std::size_t kMostFollowed = 64;

/// Halvings of a leaf or box to 1/256 of it: a quarter of a tolerance in a cell of 1/16 of the
/// surface.
inline constexpr int kHalvingsToSight = 8;
/// Halvings of a box where the surface may be undefined or jump, both ways taken together: 12 give
/// 1/64 of each side.
inline constexpr int kMaxBrokenDepth = 12;
/// Halvings of a line to 1/4096 of it: enough for a distance of second order.
inline constexpr int kHalvingsOfSecondOrder = 12;
/// The part of a line that is left then. Ends whose distance is less than this part of their
/// distances from what is between them are alike.
inline constexpr double kOfSecondOrder = 1.0 / (1 << kHalvingsOfSecondOrder);
/// Halvings of a line to 1e-6 of it, as near as kNearly.
inline constexpr int kHalvingsToNearly = 20;
/// Halvings of a line to kSame of it.
inline constexpr int kHalvingsToSame = 30;
/// Halvings of a line to 1e-12 of it: a fourth root rises to 1e-3 there.
inline constexpr int kHalvingsToEdge = 2 * kHalvingsToNearly;
/// Halvings of a line until there are no doubles between its ends. Next to 0 doubles go on: there
/// 1e-30 of the line is left.
inline constexpr int kAllHalvings = 100;
/// Halvings of a line towards a pole at 0, beside which doubles go down to 2^-1074.
inline constexpr int kHalvingsToLeast = 1100;
/// Cells each way of a grid that is chosen for a surface, two million triangles, and of a root grid
/// between two fixed lines.
inline constexpr int kMostGridCells = 1000;
/// Cells and lines each way that a cell tree can number.
inline constexpr std::size_t kMostCellsEachWay = 60'000;
/// Places of a kind that a report names; it counts the others.
inline constexpr std::size_t kMaxListed = 1000;

}  // namespace saddle
