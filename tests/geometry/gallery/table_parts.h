// What the parts of the gallery's table are written with, and the parts.
#pragma once

#include <cmath>
#include <complex>
#include <limits>

#include "geometry/gallery/table.h"
#include "surface_from_text.h"

namespace saddle {

inline constexpr double kEndless = std::numeric_limits<double>::infinity();

inline double sq(double a) {
  return a * a;
}
/// |a|^e.
inline double power(double a, double e) {
  return std::pow(std::abs(a), e);
}

// Lines and points of (u, v).
inline Places u_is(double line) {
  return {[line](double u, double) { return u - line; }};
}
inline Places v_is(double line) {
  return {[line](double, double v) { return v - line; }};
}
/// Multiples of half a turn.
inline Places sin_u() {
  return {[](double u, double) { return std::sin(u); }};
}
inline Places cos_u() {
  return {[](double u, double) { return std::cos(u); }};
}
inline Equation polynomial(double coefficients, int degree, double (*value)(const dvec3&)) {
  return {[value](const dvec3& p, double, double) { return value(p); }, coefficients, degree};
}
/// With the parameters as known numbers.
inline Equation at_parameters(double coefficients, int degree,
                              double (*value)(const dvec3&, double, double)) {
  return {value, coefficients, degree};
}

/// |x|^(2/3) + |y|^(2/3) + |z|^(2/3) = 1.
inline Equation astroid() {
  return polynomial(28, 6, [](const dvec3& p) {
    return std::cbrt(sq(p.x)) + std::cbrt(sq(p.y)) + std::cbrt(sq(p.z)) - 1;
  });
}
inline const std::vector<Places> kPoles = {v_is(-kPi / 2), v_is(kPi / 2)};
/// The edges of an octahedron, cusps all of them, and its corners.
inline std::vector<Places> octahedron() {
  return {v_is(0), v_is(-kPi / 2), v_is(kPi / 2), sin_u(), cos_u()};
}

std::vector<GalleryFacts> quadrics_and_revolutions();
std::vector<GalleryFacts> minimal_surfaces();
std::vector<GalleryFacts> pseudospherical_surfaces();
std::vector<GalleryFacts> one_sided_surfaces();
std::vector<GalleryFacts> singular_surfaces();
std::vector<GalleryFacts> tubes_and_shells();
std::vector<GalleryFacts> minimal_surfaces_of_complex_numbers();
std::vector<GalleryFacts> surfaces_of_the_three_sphere();
std::vector<GalleryFacts> functions_and_sums();

}  // namespace saddle
