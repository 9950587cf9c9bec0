// All methods on one surface: what each costs, and how near it comes to the truth.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/measurement.h"
#include "study/subject.h"

namespace saddle {

/// Called with the share that is done and what comes next.
using StudyProgress = std::function<void(double share, const std::string& what)>;

std::vector<Measurement> study(const Subject& subject, const StudyProgress& progress);

}  // namespace saddle
