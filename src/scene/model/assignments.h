// NAME=EXPRESSION: what a user types becomes part of a Scene.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "scene/model/scene.h"

namespace saddle {

/// The parts of `NAME=EXPRESSION` or `NAME(ARGUMENTS)=EXPRESSION`. Throws Error (Input) with the
/// place "argument": no `=`, an invalid name or one that cannot be a function's, an empty
/// expression.
Definition parse_definition(const std::string& assignment);

/// The first `:` from `begin` on that is outside of brackets and belongs to no `?`.
std::optional<std::size_t> range_colon(const std::string& text, std::size_t begin = 0);

/// It is `NAME=MIN:MAX`.
bool is_range(const Definition& definition);

/// Puts one assignment into `scene`: `x=`, `y=`, `z=` and the ranges `u=MIN:MAX`, `v=MIN:MAX` into
/// its (last) surface, `t=VALUE` and `t=MIN:MAX` into its time, anything else into its definitions;
/// a name that is there already is replaced. The text splits at its first `=`, a range at its first
/// `:` outside of brackets that no `?` owns. Throws Error (Input): no `=`, an invalid name, `u=`
/// without a `:`, an empty expression.
void assign(Scene& scene, const std::string& assignment);

/// Like assign(), but the name must be there already: a parameter, function or range of the scene.
/// Throws Error (Input) with the names that there are; for x, y, z, u and v of a scene with several
/// surfaces.
void override_assignment(Scene& scene, const std::string& assignment);

}  // namespace saddle
