// Vectors of 2 or 3 real expressions, and curves of them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "formula/expression.h"
#include "formula/value.h"

namespace saddle {

using Components = std::vector<Expression>;

Components operator+(const Components& a, const Components& b);
Components operator-(const Components& a, const Components& b);
Components operator*(Expression a, const Components& b);
Components operator/(const Components& a, Expression b);

Expression dot(const Components& a, const Components& b);
Components cross(const Components& a, const Components& b);  ///< of vectors of 3
Expression norm(const Components& a);
Components unit(const Components& a);

/// (r cos(angle), r sin(angle), z).
Components polar(Expression r, Expression angle, Expression z);
/// The point at distance r from the origin, at `pole` radians from the z axis and `angle` round it.
Components spherical(Expression r, Expression pole, Expression angle);
/// `a` turned round `axis` by `angle` radians, counter-clockwise as seen from its end.
Components rotate(const Components& a, const Components& axis, Expression angle);

/// The Frenet frame of the curve c(s). It is undefined where the curve is straight.
Value frame(const Components& c, Symbol s);

/// The values of some nodes at many places of the formula's domain.
using Sampler = std::function<std::vector<std::vector<double>>(std::span<const NodeId>)>;

/// A point of the tube of radius r round the curve c(s). `angle` is measured from cross(a, c'), a
/// being a constant direction that the tangent keeps away from; it grows so that the front of the
/// surface is outside where s is its first parameter.
///
/// A frame from the tangent alone is a formula, with exact derivatives. It does not turn where the
/// curve is straight, does not flip where it inflects, and closes where the curve does. The
/// tangents of a curve are a line on the sphere of directions, so that most directions are free.
Components tube(const Components& c, Symbol s, Expression r, Expression angle,
                const Sampler& sampler);

}  // namespace saddle
