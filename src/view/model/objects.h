// Objects that are added to a scene, each with a name of its own.
#pragma once

#include <cstddef>
#include <string>

#include "scene/model/scene.h"

namespace saddle {

/// A scene of one surface, a saddle.
Scene new_scene();

/// A surface, a curve or a point to begin with, at the end of the scene.
void add_surface(Scene& scene);
void add_curve(Scene& scene);
void add_point(Scene& scene);

/// A curve or point has u and v there, another one x, y and z.
bool is_on_surface(const StrokeSpec& stroke);
/// To the middle of the surface of this name, from wherever it was; into space if it is empty.
void put_on(const Scene& scene, CurveSpec& curve, const std::string& surface);
void put_on(const Scene& scene, PointSpec& point, const std::string& surface);

/// A node that moves nothing, with nothing in it.
void add_node(Scene& scene);
/// All that is in it, and the lights that are at it, go to the node around it.
void delete_node(Scene& scene, std::size_t index);
/// All that is in it stays in it.
void rename_node(Scene& scene, std::size_t index, const std::string& name);

/// `name`, or the first of "name 2", "name 3" ... that no object of the scene has.
std::string free_name(const Scene& scene, const std::string& name);

/// A parameter of this name, from 0 to 2 with the value 1, if nothing has the name.
void add_parameter(Scene& scene, const std::string& name);

}  // namespace saddle
