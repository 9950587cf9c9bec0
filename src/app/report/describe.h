// The results of `saddle check` in words.
#pragma once

#include <string>
#include <vector>

#include "app/report/report.h"

namespace saddle {

/// A line for each kind of fact, with the surface's name above. For a surface with facts, and its
/// mesh.
std::vector<std::string> describe(const SurfaceReport& surface, const Mesh& mesh);

/// A curve or a point in words.
std::vector<std::string> describe_stroke(const SurfaceReport& report);

}  // namespace saddle
