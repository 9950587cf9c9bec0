// What tests ask of meshes within a tolerance.
#pragma once

#include "mesh/mesher/mesher.h"

namespace saddle {

/// Within a share of the diagonal of the surface's box, and `normal_tolerance` degrees.
inline MeshRequest within_share(double share, double normal_tolerance = 180) {
  MeshRequest options;
  options.tolerance = [share](const Probe& probe) -> Tolerance {
    return share * probe.bounds().diagonal();
  };
  options.normal_tolerance = normal_tolerance;
  return options;
}

/// Within a length, in the surface's units.
inline MeshRequest within_length(double length) {
  MeshRequest options;
  options.tolerance = [length](const Probe&) -> Tolerance { return length; };
  return options;
}

/// The same with a grid of cells that are not subdivided.
inline MeshRequest with_samples(MeshRequest request, std::size_t cells_u, std::size_t cells_v) {
  request.samples = {cells_u, cells_v};
  return request;
}

}  // namespace saddle
