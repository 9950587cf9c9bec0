// Reports a proof: the proved share of the domain, the proof gaps, and how large a feature could
// hide in them.
#pragma once

#include <span>

#include "mesh/model/mesh_report.h"
#include "mesh/proof/certify.h"
#include "surface/surface.h"
#include "surface/surface_enclosure.h"

namespace saddle {

/// The cells that a proof was tried for.
struct ProvedCells {
  double covered = 0;  ///< share of the domain
  dvec2 largest{0};    ///< largest size each way; samples are no farther apart

  /// Adds a cell of a domain that extends over `range`.
  void add(const dvec2& size, const dvec2& range);
};

/// Fills in the sizes of disjoint gaps, and their worst places. The room is the distance by which
/// bounds of the position over a box exceed five samples of it: its corners and its middle.
void measure_gaps(const Surface& surface, const dvec2& largest_cell, double tolerance,
                  unsigned threads, KnownHulls& hulls, std::span<ProofGap> gaps);

/// Fills in what is proved of a mesh, and its proof gaps. An error that is proved to be at most the
/// tolerance is a bound from then on.
void report_proof(const Surface& surface, const ProvedCells& cells, unsigned threads,
                  KnownHulls& hulls, const Certification& proof, MeshReport& report);

}  // namespace saddle
