// Several objects of a command line as one scene.
#pragma once

#include <string>
#include <vector>

#include "app/command_line/cli.h"
#include "scene/model/scene.h"

namespace saddle {

/// A scene with only what one segment of the command line draws.
struct SceneObject {
  enum class From { Formulas, Gallery, File };  ///< a curve and a point are formulas
  From from = From::Formulas;
  Scene scene;
  std::vector<std::string> shared;   ///< assignments of names that are not the object's
  std::vector<GivenOption> options;  ///< for each of its surfaces
};

/// One scene of all objects. Camera, lights, nodes and the like are those of the first scene file.
/// A gallery surface or a further scene file keeps its definitions to itself; all others are
/// shared. `common`: assignments that hold for all objects; `options`: the scene's, which may use
/// them. Throws Error (Input): two different definitions of a shared name; one that a gallery
/// surface or scene file lacks and nothing else uses; a second scene file with nodes.
Scene combine_objects(const std::vector<SceneObject>& objects,
                      const std::vector<std::string>& common,
                      const std::vector<GivenOption>& options);

/// Lets the objects' options change their surfaces, curves and points, which stand in the scene in
/// their order, and gives each its own name. The options of a lone object change the scene. Throws
/// Error (Input).
void apply_object_options(const std::vector<SceneObject>& objects, Scene& scene);

}  // namespace saddle
