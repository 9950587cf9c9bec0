// A distance between a mesh and its surface, and its place.
#pragma once

#include "base/vec.h"

namespace saddle {

struct PlacedError {
  double distance = 0;
  dvec2 uv{0};
};

}  // namespace saddle
