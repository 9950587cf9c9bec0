// Formulas whose author can hardly mean them.
#pragma once

#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace saddle {

/// A clamp() whose constant bounds are the wrong way round is the upper one everywhere: a sentence
/// for each. Bounds that depend on u, v or t are not looked at.
std::vector<std::string> reversed_clamps(const Scene& scene);

}  // namespace saddle
