// All methods on one surface: what each costs, and how near it comes to the truth.
#pragma once

#include <vector>

#include "study/measurement.h"
#include "study/subject.h"

namespace saddle {

std::vector<Measurement> study(const Subject& subject, const StudyProgress& progress);

/// The measurements of several surfaces as one scene's: of each method and setting that all of them
/// have, the sums of times and triangles, and the largest error.
std::vector<Measurement> together(const std::vector<std::vector<Measurement>>& surfaces);

}  // namespace saddle
