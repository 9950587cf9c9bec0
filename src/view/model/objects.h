// Objects that are added to a scene, each with a name of its own.
#pragma once

#include <string>

#include "scene/model/scene.h"

namespace saddle {

/// A scene of one surface, a saddle.
Scene new_scene();

/// A surface, a curve or a point to begin with, at the end of the scene.
void add_surface(Scene& scene);
void add_curve(Scene& scene);
void add_point(Scene& scene);

/// `name`, or the first of "name 2", "name 3" ... that no object of the scene has.
std::string free_name(const Scene& scene, const std::string& name);

/// A parameter of this name, from 0 to 2 with the value 1, if nothing has the name.
void add_parameter(Scene& scene, const std::string& name);

}  // namespace saddle
