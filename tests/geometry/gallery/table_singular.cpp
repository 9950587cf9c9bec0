// Facts of surfaces that are one-sided or singular.
#include "geometry/gallery/table_parts.h"

namespace saddle {
namespace {

/// The figure of eight that is turned by half a turn along a circle of radius 2.
double figure_8(const dvec3& p, double u, double) {
  const double across = std::hypot(p.x, p.y) - 2;
  const double a = std::cos(u / 2) * across + std::sin(u / 2) * p.z;
  const double b = std::cos(u / 2) * p.z - std::sin(u / 2) * across;
  return sq(b) - 4 * sq(a) * (1 - sq(a));
}

/// A tube around its bent axis.
double bottle(const dvec3& p, double u, double) {
  const double r = 4 * (1 - std::cos(u) / 2);
  const dvec3 axis = {6 * std::cos(u) * (1 + std::sin(u)), 16 * std::sin(u), 0};
  return glm::dot(p - axis, p - axis) - r * r;
}

/// In complex numbers, after Apery; without the denominator.
double apery(const dvec3& p, double u, double v) {
  const double d = 2 - std::sqrt(2.0) * std::sin(3 * u) * std::sin(2 * v);
  const std::complex<double> w = std::sqrt(2.0) * sq(std::cos(v)) * std::polar(1.0, 2 * u) +
                                 std::sin(2 * v) * std::polar(1.0, -u);
  return std::abs(d * std::complex<double>(p.x, p.y) - w) + std::abs(d * p.z - 3 * sq(std::cos(v)));
}

Equation plucker() {
  return polynomial(4, 3, [](const dvec3& p) { return p.z * (sq(p.x) + sq(p.y)) - 2 * p.x * p.y; });
}
}  // namespace

std::vector<GalleryFacts> one_sided_surfaces() {
  return {
      {.name = "mobius",
       .extents = {2.529, 2.728, 1},
       .boundary_loops = 1,
       .orientable = false,
       .closed_u = "reversed",
       .equation = polynomial(10, 3,
                              [](const dvec3& p) {
                                return p.y * (glm::dot(p, p) - 1) -
                                       2 * p.z * (p.x + sq(p.x) + sq(p.y));
                              })},
      {.name = "klein-figure8",
       .extents = {6.019, 6.489, 2.5},
       .orientable = false,
       .closed_u = "reversed",
       .closed_v = "join",
       .equation = at_parameters(10, 4, figure_8)},
      {.name = "klein-bottle",
       .extents = {22.85, 36.1, 12},
       .orientable = false,
       .closed_u = "reversed",
       .closed_v = "join",
       .proof = Proof::May,
       .equation = at_parameters(10, 2, bottle)},
      // Poles, and pinch points where sin(2v) is 0.
      {.name = "cross-cap",
       .extents = {2, 2, 2},
       .euler_number = 1,
       .orientable = false,
       .closed_u = "reversed",
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {v_is(0), v_is(kPi), {[](double u, double v) {
                      return std::hypot(std::cos(u) * std::sin(u), std::cos(v));
                    }}},
       .equation = polynomial(40, 4,
                              [](const dvec3& p) {
                                const double r = sq(p.x) + sq(p.y);
                                return sq(r + sq(p.x)) - 4 * (r * p.z + sq(p.x)) * (1 - p.z);
                              })},
      // A parallel that is the triple point, and six pinch points.
      {.name = "roman",
       .extents = {1, 1, 1},
       .euler_number = 1,
       .orientable = false,
       .closed_u = "reversed",
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {v_is(kPi / 2), {[](double u, double v) {
                      return std::hypot(std::sin(4 * u), std::sin(4 * v));
                    }}},
       .equation = polynomial(4, 4,
                              [](const dvec3& p) {
                                return sq(p.x * p.y) + sq(p.y * p.z) + sq(p.z * p.x) -
                                       p.x * p.y * p.z;
                              })},
      {.name = "boy",
       .extents = {3.648, 3.855, 3},
       .euler_number = 1,
       .orientable = false,
       .closed_u = "reversed",
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {v_is(kPi / 2)},
       .equation = at_parameters(20, 1, apery)},
  };
}

std::vector<GalleryFacts> singular_surfaces() {
  return {
      {.name = "whitney-umbrella",
       .extents = {2, 2, 1},
       .euler_number = 1,
       .boundary_loops = 1,
       .singular = {{[](double u, double v) { return std::hypot(u, v); }}},
       .equation = polynomial(2, 3, [](const dvec3& p) { return sq(p.x) - sq(p.y) * p.z; })},
      {.name = "cuspidal-edge",
       .extents = {2, 1, 2},
       .euler_number = 1,
       .boundary_loops = 1,
       .proof = Proof::May,
       .singular = {v_is(0)},
       .equation = polynomial(2, 3, [](const dvec3& p) { return p.y * sq(p.y) - sq(p.z); })},
      // The discriminant of t^4 + z t^2 + y t + x, 0 where its derivative and the second are.
      {.name = "swallowtail",
       .extents = {2.842, 10.5, 4},
       .euler_number = 1,
       .boundary_loops = 1,
       .proof = Proof::May,
       .singular = {{[](double u, double v) { return u + 6 * v * v; }}},
       .equation = polynomial(575, 5,
                              [](const dvec3& p) {
                                const double y2 = sq(p.y);
                                const double z2 = sq(p.z);
                                return 16 * z2 * z2 * p.x - 4 * z2 * p.z * y2 - 128 * z2 * sq(p.x) +
                                       144 * p.z * y2 * p.x - 27 * y2 * y2 + 256 * p.x * sq(p.x);
                              })},
      {.name = "menn",
       .extents = {2, 2, 2.25},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = polynomial(
           3.5, 4,
           [](const dvec3& p) { return p.z - 0.5 * sq(sq(p.x)) - sq(p.x) * p.y + sq(p.y); })},
      // Each point of its axis is met four times, at v = 0, by sheets that pass through each other:
      // they stay apart. Pinch points where the axis ends.
      {.name = "plucker-conoid",
       .extents = {2, 2, 2},
       .boundary_loops = 2,
       .closed_u = "join",
       .singular = {{[](double u, double v) { return std::hypot(std::cos(2 * u), v); }}},
       .equation = plucker()},
      // A disc without its middle.
      {.name = "plucker-conoid-cartesian",
       .extents = {2, 2, 2},
       .boundary_loops = 2,
       .proof = Proof::Fails,
       .jumps = {{[](double u, double v) { return std::hypot(u, v); }}},
       .holed = true,
       .equation = plucker()},
      // With a = b the height is |sin(u)|: creases. A disc: the edge v = 0 is folded.
      {.name = "wallis-conical-edge",
       .extents = {2, 2, 0.5},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = {sin_u(), {[](double u, double v) { return std::hypot(std::cos(u), v); }}},
       .equation = polynomial(
           2, 4, [](const dvec3& p) { return sq(p.z) * (sq(p.x) + sq(p.y)) - sq(p.y) / 4; })},
      {.name = "riemann-sqrt",
       .extents = {2, 2, 2},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {u_is(0)},
       .equation = polynomial(
           7, 4, [](const dvec3& p) { return sq(2 * sq(p.z) - p.x) - sq(p.x) - sq(p.y); })},
      {.name = "riemann-cbrt",
       .extents = {2, 2, 2},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {u_is(0)},
       .equation = polynomial(150, 9,
                              [](const dvec3& p) {
                                const double cube = p.z * sq(p.z);
                                const double left = 4 * cube - p.x;
                                return left * sq(left) - 27 * cube * (sq(p.x) + sq(p.y));
                              })},
      // Half the turns that the sampled one had.
      {.name = "riemann-log",
       .extents = {2, 2, 3.142},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = polynomial(
           40, 1,
           [](const dvec3& p) { return p.y * std::cos(6 * p.z) - p.x * std::sin(6 * p.z); })},
      {.name = "riemann-asin",
       .extents = {4.705, 4.259, 6.283},
       .euler_number = 1,
       .boundary_loops = 1,
       .singular = {{[](double u, double v) { return std::hypot(std::cos(u), v); }}},
       .equation = polynomial(10, 2,
                              [](const dvec3& p) {
                                const double s = sq(std::sin(p.z));
                                return sq(p.x) * (1 - s) - sq(p.y) * s - s * (1 - s);
                              })},
      // Cones at the zeros of the sine.
      {.name = "sine-modulus",
       .extents = {6.283, 3, 2.352},
       .euler_number = 1,
       .boundary_loops = 1,
       .proof = Proof::May,
       .singular = {{[](double u, double v) { return std::hypot(std::sin(u), v); }}},
       .equation = polynomial(
           10, 2, [](const dvec3& p) { return sq(p.z) - sq(std::sin(p.x)) - sq(std::sinh(p.y)); })},
  };
}

}  // namespace saddle
