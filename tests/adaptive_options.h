// What tests ask of meshes within a tolerance.
#pragma once

#include "mesh/mesher/adaptive_mesh.h"

namespace saddle {

/// Within a share of the diagonal of the surface's box, and `normal_tolerance` degrees.
inline AdaptiveOptions within_share(double share, double normal_tolerance = 180) {
  AdaptiveOptions options;
  options.tolerance = [share](const Probe& probe) -> Tolerance {
    return share * probe.bounds().diagonal();
  };
  options.normal_tolerance = normal_tolerance;
  return options;
}

/// Within a length, in the surface's units.
inline AdaptiveOptions within_length(double length) {
  AdaptiveOptions options;
  options.tolerance = [length](const Probe&) -> Tolerance { return length; };
  return options;
}

}  // namespace saddle
