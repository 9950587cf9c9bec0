// PLY files without what their headers tell of the scene.
#pragma once

#include <algorithm>
#include <string>

namespace saddle {

/// Elements, vertices and faces: two scenes may have the same.
inline std::string mesh_in_ply(const std::string& ply) {
  return ply.substr(std::min(ply.find("\nelement "), ply.size()));
}

}  // namespace saddle
