// All methods on one surface: what each costs, and how near it comes to the truth.
#pragma once

#include <vector>

#include "study/measurement.h"
#include "study/subject.h"

namespace saddle {

std::vector<Measurement> study(const Subject& subject, const StudyProgress& progress);

}  // namespace saddle
