// Facts of tubes, shells and other bodies.
#include "geometry/gallery/table_parts.h"

namespace saddle {
namespace {

/// A trefoil knot.
dvec3 trefoil(double u) {
  return {std::sin(u) + 2 * std::sin(2 * u), std::cos(u) - 2 * std::cos(2 * u), -std::sin(3 * u)};
}
dvec3 along_trefoil(double u) {
  return {std::cos(u) + 4 * std::cos(2 * u), -std::sin(u) + 4 * std::sin(2 * u),
          -3 * std::cos(3 * u)};
}

}  // namespace

std::vector<GalleryFacts> tubes_and_shells() {
  return {
      // Both ellipses' tangents agree at four points.
      {.name = "bohemian-dome",
       .extents = {1, 4, 2},
       .closed_u = "join",
       .closed_v = "join",
       .singular = {{[](double u, double v) { return std::hypot(std::sin(u), std::cos(v)); }}},
       .equation = polynomial(100, 4,
                              [](const dvec3& p) {
                                const double q = sq(p.y) + 0.25 - sq(p.x) - 2.25 * (1 - sq(p.z));
                                return q * q - 4 * sq(p.y) * (0.25 - sq(p.x));
                              })},
      {.name = "corkscrew",
       .extents = {2, 2, 5.142},
       .boundary_loops = 2,
       .closed_v = "join",
       .equation = at_parameters(20, 2,
                                 [](const dvec3& p, double u, double) {
                                   return sq(p.x) + sq(p.y) + sq(p.z - 0.5 * u) - 1;
                                 })},
      // A disc: the edge u = 0 is a segment, there and back.
      {.name = "guimard",
       .extents = {3, 1, 1},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {{[](double u, double v) { return std::hypot(u, std::sin(v)); }}},
       .equation = at_parameters(40, 2,
                                 [](const dvec3& p, double u, double) {
                                   const double half = 1.5 - u;
                                   return std::abs(p.z * u - 4 * sq(p.y)) +
                                          std::abs(sq(p.x * u) + 4 * sq(p.y * half) - sq(u * half));
                                 })},
      {.name = "steinbach-screw",
       .extents = {8, 8, 12.57},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = at_parameters(20, 2,
                                 [](const dvec3& p, double u, double v) {
                                   return std::abs(p.z - v * std::cos(u)) +
                                          std::abs(sq(p.x) + sq(p.y) - u * u);
                                 })},
      // The edges are segments, there and back: two spheres that share a point, v = 0. In all of x,
      // y
      // and z there is a factor of u alone and one of v alone; both pairs of slopes are parallel at
      // cos(u) = 1/4, where those of y and z have the same share in u.
      {.name = "bent-horns",
       .extents = {15.76, 6, 6},
       .euler_number = 3,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = {v_is(-2 * kPi), v_is(2 * kPi), v_is(0), {[](double u, double v) {
                      const double share_x = -std::sin(u) / (2 + std::cos(u));
                      const double share_y =
                          -std::sin(u - 2 * kPi / 3) / (2 + std::cos(u - 2 * kPi / 3));
                      const double part_x = (v / 3 - std::sin(v)) * -std::sin(v);
                      const double part_y = (std::cos(v) - 1) * (1.0 / 3 - std::cos(v));
                      return std::hypot(std::cos(u) - 0.25, share_x * part_x - share_y * part_y);
                    }}},
       .equation = at_parameters(20, 1,
                                 [](const dvec3& p, double u, double) {
                                   return p.y * (2 + std::cos(u + 2 * kPi / 3)) -
                                          p.z * (2 + std::cos(u - 2 * kPi / 3));
                                 })},
      {.name = "trefoil-tube",
       .extents = {6.67, 6.262, 3.2},
       .closed_u = "join",
       .closed_v = "join",
       .equation = at_parameters(40, 2,
                                 [](const dvec3& p, double u, double) {
                                   const dvec3 off = p - trefoil(u);
                                   return std::abs(glm::dot(off, off) - 0.36) +
                                          std::abs(glm::dot(off, along_trefoil(u)));
                                 })},
      {.name = "figure-eight-knot",
       .extents = {6.8, 5.917, 2.8},
       .closed_u = "join",
       .closed_v = "join",
       .equation = at_parameters(40, 2,
                                 [](const dvec3& p, double u, double) {
                                   const double r = 2 + std::cos(2 * u);
                                   const dvec3 knot(r * std::cos(3 * u), r * std::sin(3 * u),
                                                    std::sin(4 * u));
                                   return glm::dot(p - knot, p - knot) - 0.16;
                                 })},
      // Its sections pass through the axis of the cone at v = pi: a cusp. They begin with a point.
      {.name = "seashell",
       .extents = {6.049, 5.258, 8.107},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {u_is(0), v_is(kPi)},
       .equation = at_parameters(60, 2,
                                 [](const dvec3& p, double u, double) {
                                   const double k = std::exp(u / (6 * kPi));
                                   const double out = p.x * std::cos(u) - p.y * std::sin(u);
                                   return sq(out - (1 - k)) + sq(p.z - (1 - k * k)) - sq(1 - k);
                                 })},
      {.name = "conic-spiral",
       .extents = {0.9012, 0.8024, 1.2},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = {v_is(2 * kPi)},
       .equation = at_parameters(20, 2,
                                 [](const dvec3& p, double, double v) {
                                   const double a = 0.2 * (1 - v / (2 * kPi));
                                   const double out = p.x * std::cos(2 * v) + p.y * std::sin(2 * v);
                                   return sq(out - 0.1 - a) + sq(p.z - v / (2 * kPi)) - a * a;
                                 })},
      {.name = "horn",
       .extents = {5.01, 6.505, 2},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {u_is(0)},
       .equation = at_parameters(40, 2,
                                 [](const dvec3& p, double u, double) {
                                   const double turn = 2 * kPi * u;
                                   const double out =
                                       p.x * std::sin(turn) + (p.y - 2 * u) * std::cos(turn);
                                   return sq(out - 2) + sq(p.z) - u * u;
                                 })},
      // Two edges that are segments, 24 times there and back, and two closed lines at r = 0 that
      // are
      // one point: a disc, a sphere two points of which are that one, and a disc. The second line
      // crosses itself at 24 points, beside each of which is a sphere more, 0.008 high: Euler
      // number
      // 3 + 24, of which a mesh shows what it resolves.
      {.name = "bourke-harmonic",
       .extents = {3.076, 4.273, 3.076},
       .euler_number = std::nullopt,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = {{[](double u, double v) {
                      const auto cube = [](double a) { return a * a * a; };
                      return cube(std::sin(4 * v)) + cube(std::cos(2 * v)) + sq(std::sin(6 * u)) +
                             sq(sq(std::cos(6 * u)));
                    }},
                    {[](double u, double v) { return std::hypot(std::sin(24 * u), std::sin(v)); }}},
       .equation = at_parameters(4, 1,
                                 [](const dvec3& p, double u, double v) {
                                   const double out = p.x * std::cos(u) + p.z * std::sin(u);
                                   return std::abs(out * std::cos(v) - p.y * std::sin(v)) +
                                          std::abs(p.x * std::sin(u) - p.z * std::cos(u));
                                 })},
      // Twelve lobes, each a sphere that has the origin: 12 * 2 - 11.
      {.name = "spherical-harmonic",
       .extents = {0.5723, 0.5036, 0.3717},
       .euler_number = 13,
       .closed_u = "join",
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {v_is(-kPi / 2), v_is(0), v_is(kPi / 2), {[](double u, double) {
                      return std::cos(3 * u);
                    }}},
       .equation = polynomial(5, 5,
                              [](const dvec3& p) {
                                return std::pow(glm::dot(p, p), 2.5) -
                                       std::abs(p.z * p.x * (sq(p.x) - 3 * sq(p.y)));
                              })},
      {.name = "superellipsoid",
       .extents = {2, 2, 2},
       .euler_number = 2,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = kPoles,
       .equation = polynomial(3, 10,
                              [](const dvec3& p) {
                                return std::pow(p.x, 10) + std::pow(p.y, 10) + std::pow(p.z, 10) -
                                       1;
                              })},
      {.name = "superellipsoid-star",
       .extents = {2, 2, 2},
       .euler_number = 2,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = octahedron(),
       .equation = astroid()},
      {.name = "supertoroid",
       .extents = {5.4, 5.4, 1.4},
       .closed_u = "join",
       .closed_v = "join",
       .proof = Proof::May,
       .equation = polynomial(
           100, 8,
           [](const dvec3& p) {
             constexpr double kPower = 2 / 0.3;
             const double out = std::pow(power(p.x, kPower) + power(p.y, kPower), 1 / kPower) - 2;
             return power(out, kPower) + power(p.z, kPower) - std::pow(0.7, kPower);
           })},
      {.name = "eck-default",
       .extents = {12, 4, 12},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = polynomial(
           20, 1, [](const dvec3& p) { return p.y - 2 * std::sin(p.x) * std::cos(2 * p.z); })},
  };
}

}  // namespace saddle
