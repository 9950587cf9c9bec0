// From the expressions of a scene to the numbers that they are at a moment.
#pragma once

#include <memory>
#include <string>

#include "scene/model/scene.h"

namespace saddle {

/// The scene with the value of every Number filled in, at its moment t. Throws Error (Input) that
/// names the number ("light 2: cutoff"): anything wrong with its expression, not finite, out of its
/// range; a direction of length 0; a node that is missing, there twice, or in itself.
Scene resolve(Scene scene);

/// A scene that is wanted at many moments: its expressions are parsed once.
class Timeline {
 public:
  /// Throws Error (Input) as resolve() does, for nodes, the moment and the range of time.
  explicit Timeline(Scene scene);
  ~Timeline();
  Timeline(const Timeline&) = delete;
  Timeline& operator=(const Timeline&) = delete;

  /// As it was written, with its moment and its range of time filled in.
  const Scene& scene() const { return scene_; }
  /// The resolved scene at this moment.
  Scene at(double t);
  /// One of its numbers, other than those of formulas, has used t. After at().
  bool moves() const;

 private:
  struct Parsed;

  Scene scene_;
  std::unique_ptr<Parsed> parsed_;
};

/// The name of a part of the scene in messages, before the name of each of its numbers.
std::string surface_prefix(std::size_t index);   // "surface 1: "
std::string curve_prefix(std::size_t index);     // "curve 1: "
std::string point_prefix(std::size_t index);     // "point 1: "
std::string light_prefix(std::size_t index);     // "light 1: "
std::string node_prefix(const SceneNode& node);  // "node wheel: "

}  // namespace saddle
