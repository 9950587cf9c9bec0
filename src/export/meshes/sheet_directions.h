// Where the two sheets of a surface go, a front and a back that are a hair apart.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "mesh/model/mesh.h"

namespace saddle {

/// From each corner to its front: its normal, or at a crease the mitre of its fan, so that sheets
/// do not part where normals do. It refers to the mesh.
class SheetDirections {
 public:
  explicit SheetDirections(const Mesh& mesh);

  const dvec3& at(std::size_t corner) const {
    const bool is_creased = !is_creased_.empty() && is_creased_[corner];
    return is_creased ? at_creases_.at(corner) : normal_[corner];
  }

 private:
  const Array<dvec3>& normal_;
  std::vector<bool> is_creased_;  ///< by corner; empty: none is
  std::unordered_map<std::size_t, dvec3> at_creases_;
};

}  // namespace saddle
