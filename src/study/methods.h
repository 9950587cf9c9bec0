// The methods that a study compares, each against the truth. `progress` is told of a panel's share.
#pragma once

#include <vector>

#include "study/measurement.h"
#include "study/subject.h"

namespace saddle {

/// Digits of a method's setting in tables and charts.
inline constexpr int kSettingDigits = 6;

/// Positions on a grid: muparser and tapes. Errors in units in the last place of the surface's
/// largest coordinate.
std::vector<Measurement> measure_evaluation(const Subject& subject, const StudyProgress& progress);

/// Unit normals on a grid whose lines include the ends of the ranges, where singular points are:
/// differences, means of faces, derivatives, limits. Errors in degrees; 180 for a normal that is
/// missing.
std::vector<Measurement> measure_normals(const Subject& subject, const StudyProgress& progress);

/// Meshes: uniform grids, and adaptive ones over tolerances, with and without proof. Errors in
/// pixels of the subject's picture.
std::vector<Measurement> measure_meshes(const Subject& subject, const StudyProgress& progress);

/// Pictures over tolerances, and over samples per pixel, without grid lines. Errors against the
/// exact image, as a share of full scale. Throws Error (Machine): there is no OpenGL.
std::vector<Measurement> measure_images(const Subject& subject, const StudyProgress& progress);

}  // namespace saddle
