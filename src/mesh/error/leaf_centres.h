// The surface at the centres of leaves, also where these samples are forgotten.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/vec.h"
#include "mesh/error/validated_mesh.h"
#include "surface/surface.h"

namespace saddle {

class CellTree;

/// A regular point of the surface.
struct LeafCentre {
  dvec2 uv;
  dvec3 position;
  dvec3 normal;
};

/// Centres of the leaves `which` of a mesh whose estimate exceeds `least` tolerances. Forgotten
/// ones are evaluated together.
class LeafCentres {
 public:
  LeafCentres(const Surface& surface, const ValidatedMesh& mesh, std::span<const std::size_t> which,
              double least, const CellTree& tree, unsigned threads);

  /// The centre of leaf which[i]; nothing if its estimate is smaller, or if it is not regular.
  std::optional<LeafCentre> of(std::size_t i) const;
  std::size_t evaluations() const { return evaluated_.size(); }

 private:
  const ValidatedMesh& mesh_;
  std::span<const std::size_t> which_;
  double least_;
  const CellTree& tree_;
  std::vector<std::uint32_t> numbers_;  // in `evaluated_`, of each leaf; empty: none is forgotten
  std::vector<std::optional<LeafCentre>> evaluated_;
};

}  // namespace saddle
