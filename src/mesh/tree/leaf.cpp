#include "mesh/tree/leaf.h"

namespace saddle {

SampleVertices SampleVertices::of_half(bool along_u, bool is_lower) const {
  SampleVertices half;
  if (along_u) {
    half.corner = is_lower ? std::array{corner[0], side[0], side[2], corner[3]}
                           : std::array{side[0], corner[1], corner[2], side[2]};
    half.side[1] = is_lower ? centre : side[1];
    half.side[3] = is_lower ? side[3] : centre;
  } else {
    half.corner = is_lower ? std::array{corner[0], corner[1], side[1], side[3]}
                           : std::array{side[3], side[1], corner[2], corner[3]};
    half.side[0] = is_lower ? side[0] : centre;
    half.side[2] = is_lower ? centre : side[2];
  }
  return half;
}

}  // namespace saddle
