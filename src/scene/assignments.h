// NAME=EXPRESSION: what a user types becomes part of a Scene.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.h"

namespace saddle {

/// Puts one assignment into `scene`: `x=`, `y=`, `z=` and the ranges `u=MIN:MAX`, `v=MIN:MAX` into
/// its (last) surface, `t=VALUE` into its time, anything else into its definitions; a name that is
/// there already is replaced. The text splits at its first `=`, a range at its first `:` outside
/// of brackets that no `?` owns. Throws Error (Input): no `=`, a name that is none, `u=` without a
/// `:`, an empty expression.
void assign(Scene& scene, const std::string& assignment);

/// Like assign(), but the name must be there already: a parameter, function or range of the scene.
/// Throws Error (Input) with the names that there are.
void override_assignment(Scene& scene, const std::string& assignment);

/// Whether the text assigns to `t`. Such an assignment goes last: its value may use parameters.
bool assigns_time(std::string_view assignment);

}  // namespace saddle
