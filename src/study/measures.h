// Area, volume and curvatures of a surface, from its derivatives.
#pragma once

#include "mesh/model/mesh.h"
#include "mesh/model/topology.h"
#include "study/extremes.h"
#include "study/integrals.h"
#include "surface/surface.h"

namespace saddle {

struct Measures {
  Estimate area;
  /// Inside of a closed surface; negative if its back is outside, and not so if front and back
  /// change places within it.
  Estimate volume;
  Bounds extents;          ///< of the surface, if all of it was meshed; else of the mesh
  Bounds extents_bounds;   ///< proved to hold the surface, or the mesh of a part
  ValueRange gauss, mean;  ///< of the surface's regular points
  std::size_t evaluations = 0;
};

/// The part that a mesh covers: the whole domain, its defined part, or less.
enum class Covered { Whole, Defined, Part };

/// Integrals over the domain, or over each triangle of parameters by a rule that is exact for
/// polynomials of degree 5: of what the mesh covers, those that are known better. For a surface of
/// second order. `parts`: of the mesh. `share`: of the work that does not grow with the mesh, less
/// for one of many surfaces. Source: J. Radon, "Zur mechanischen Kubatur", 1948.
Measures measure_surface(const Surface& surface, const Mesh& mesh, const Parts& parts,
                         Covered covered, unsigned threads, double share = 1);

}  // namespace saddle
