// Runs GLSL over a list of arguments, one per pixel.
#pragma once

#include <string>
#include <vector>

#include "conformance/arguments.h"
#include "render/gl/context.h"

namespace saddle::testing {

/// The outputs x, y, z of `code` (statements of the floats u and v) for each pair of arguments
/// (a, b), which are rounded to floats; in 32 bits each.
std::vector<std::array<float, 3>> run_glsl(const std::string& code,
                                           const std::vector<Arguments>& arguments);

}  // namespace saddle::testing
