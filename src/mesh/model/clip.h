// A mesh cut along the faces of a box.
// Source: I. Sutherland, G. Hodgman, "Reentrant polygon clipping", 1974.
#pragma once

#include <optional>
#include <span>

#include "mesh/model/mesh.h"

namespace saddle {

/// Whether all positions are beyond the same face of the box, so that nothing between them is in
/// it.
template <class Positions>
bool is_beyond(const Bounds& box, const Positions& positions) {
  for (int k = 0; k < 3; ++k) {
    bool below = true;
    bool above = true;
    for (const dvec3& p : positions) {
      below = below && p[k] < box.low[k];
      above = above && p[k] > box.high[k];
    }
    if (below || above) return true;
  }
  return false;
}

/// Whether a position is finite and within a clip box, if there is one.
inline bool is_seen(const std::optional<Bounds>& clip, const dvec3& position) {
  return is_finite(position) && (!clip || clip->contains(position));
}

/// Whether a chord lies along a face of a clip box but for rounding, or beyond it.
bool is_along_face(const Bounds& clip, const dvec3& from, const dvec3& to);

/// The distance of a position from a clip box: 0 within it.
inline double distance_beyond(const Bounds& clip, const dvec3& position) {
  return glm::distance(position, glm::clamp(position, clip.low, clip.high));
}

/// Whether a corner of triangles of a mesh is outside of a clip box, if there is one.
bool reach_outside(const std::optional<Bounds>& clip, const Mesh& mesh,
                   std::span<const Triangle> triangles);

/// Removes everything outside of the box, whose faces may be infinitely far. Triangles and lines
/// that cross a face end on it, at corners that neighbours share, with interpolated normals and
/// parameters. A point's number is that of one of its corners, before and after. Throws Error
/// (Nothing) if nothing is left.
void clip_mesh(const Bounds& box, Mesh& mesh);

}  // namespace saddle
