// A scene over all of its time: the camera that holds it at every moment, so that a film's picture
// does not breathe, and what its meshes have to be fine enough for.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "meshing/tolerance.h"
#include "scene/options/resolve.h"

namespace saddle {

/// The camera of a scene with an animation, where the scene leaves it open. The target is the
/// centre of a box around the scene at all moments of its range of time. At the distance, the
/// sphere around the target that holds the scene just fits. They depend on the scene and its range
/// of time alone: frames that are drawn apart fit together, and a frame that is opened again is the
/// same.
///
/// An automatic scale is found for scenes without an animation, too.
///
/// The box of the axes, the range of the numbers that colours stand for and the levels of contours
/// are those of all moments, too.
struct Framing {
  std::optional<dvec3> target;  ///< in the picture, which the scale stretches
  std::optional<double> distance;
  std::optional<Bounds> box;                 ///< of a scene with axes
  std::map<std::size_t, ColorRange> colors;  ///< of surfaces whose colours another moment changes
  /// The same for round levels, of a surface and one of its contours.
  std::map<std::pair<std::size_t, std::size_t>, ColorRange> contours;
  std::vector<Moment> moments;  ///< cameras and nodes, none twice
  std::optional<dvec3> scale;   ///< where the scene's is automatic

  /// Puts the camera, the scale, the box and the colours where they are. A scene without an
  /// animation keeps its own camera.
  void apply(Scene& scene) const;
};

/// Looks at `timeline.scene()` at a fixed number of moments, at samples of its surfaces. Throws
/// Error (Input) as Timeline::at() and prepare_surface() do.
Framing frame_scene(Timeline& timeline, unsigned threads);

/// The moment of a resolved scene without an animation, its scale found, that has several surfaces,
/// or one in several nodes. Where the scene leaves the camera open, it is fitted to samples of all
/// of them: each is then meshed for the pixels that it has in the picture. Empty for a single
/// surface, whose own samples place the camera, and for a scene of which there is nothing to see.
/// Throws Error (Input) as prepare_surface() does.
std::vector<Moment> moments_of_still(const Scene& scene, unsigned threads);

}  // namespace saddle
