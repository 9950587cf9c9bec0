// NAME=EXPRESSION: what a user types becomes part of a Scene.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/model/scene.h"

namespace saddle {

/// The parts of `NAME=EXPRESSION` or `NAME(ARGUMENTS)=EXPRESSION`, a text with a `=`. Throws Error
/// (Input) with the place "argument": an invalid name or one that cannot be a function's, an empty
/// expression.
Definition parse_definition(const std::string& assignment);

/// The first `:` from `begin` on that is outside of brackets and belongs to no `?`.
std::optional<std::size_t> range_colon(const std::string& text, std::size_t begin = 0);

/// It is `NAME=MIN:MAX`.
bool is_range(const Definition& definition);

/// It is a surface's, not the scene's: the formula of a coordinate, a range but that of t, or its
/// condition.
bool is_of_surface(const Definition& definition);

/// The reason why a surface's parameter cannot have that name; empty: it can.
std::string fault_of_parameter(const std::string& name);

/// Puts one assignment into `scene`: `x=`, `y=`, `z=`, `where=` and ranges of the parameters,
/// `u=MIN:MAX` unless they have other names, into its (last) surface, `t=VALUE` and `t=MIN:MAX`
/// into its time, anything else into its definitions; a name that is there already is replaced. The
/// text splits at its first `=`, a range at its first
/// `:` outside of brackets that no `?` owns. Throws Error (Input): no `=`, an invalid name, `u=`
/// without a `:`, an empty expression; what check_names() refuses.
void assign(Scene& scene, const std::string& assignment);

/// Puts all of them into `scene`, whose (last) surface takes the names of its parameters from the
/// ranges: u and x name the first, v and y the second, other names what is left, in their order.
/// Throws Error (Input), as assign() does; for a third range.
void assign_all(Scene& scene, const std::vector<std::string>& assignments);

/// Puts the assignment into a curve, if it is one of its own: `x=`, `y=`, `z=`, `xyz=`, `u=`, `v=`,
/// all formulas of s, and the range `s=MIN:MAX`. Returns whether it was. Throws Error (Input):
/// another range but that of t; `s=` without a `:`.
bool assign(CurveSpec& curve, const Definition& definition);

/// The same for a point: `u=` and `v=`. Throws Error (Input): a range but that of t; `x=`, `y=` or
/// `z=`, which the word after `point` gives.
bool assign(PointSpec& point, const Definition& definition);

/// The scene has a parameter, function or range of that name, which can be overridden.
bool has_name(const Scene& scene, const std::string& name);

/// The error for an override of a name that the scene lacks, with the names that there are.
Error unknown_override(const Scene& scene, const std::string& assignment);

/// Like assign(), but the name must be there already: see has_name(). Throws Error (Input):
/// unknown_override(); x, y, z, u and v of a scene with several surfaces.
void override_assignment(Scene& scene, const std::string& assignment);

}  // namespace saddle
