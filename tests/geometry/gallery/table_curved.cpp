// Facts of quadrics, surfaces of revolution and those of constant curvature.
#include "geometry/gallery/table_parts.h"

namespace saddle {
namespace {

Equation torus(double R, double r, double coefficients) {
  return {[=](const dvec3& p, double, double) {
            return sq(glm::dot(p, p) + R * R - r * r) - 4 * R * R * (sq(p.x) + sq(p.y));
          },
          coefficients, 4};
}
Equation scherk_1() {
  return polynomial(2e3, 0,
                    [](const dvec3& p) { return std::exp(p.z) * std::cos(p.x) - std::cos(p.y); });
}
Equation scherk_2() {
  return polynomial(200, 0,
                    [](const dvec3& p) { return std::sin(p.z) - std::sinh(p.x) * std::sinh(p.y); });
}
}  // namespace

std::vector<GalleryFacts> quadrics_and_revolutions() {
  return {
      {.name = "sphere",
       .extents = {2, 2, 2},
       .euler_number = 2,
       .closed_u = "join",
       .singular = kPoles,
       .equation = polynomial(4, 2, [](const dvec3& p) { return glm::dot(p, p) - 1; }),
       .gauss = 1},
      {.name = "ellipsoid",
       .extents = {6, 4, 2},
       .euler_number = 2,
       .closed_u = "join",
       .singular = kPoles,
       .equation = polynomial(
           4, 2, [](const dvec3& p) { return sq(p.x / 3) + sq(p.y / 2) + sq(p.z) - 1; })},
      {.name = "torus",
       .extents = {5.6, 5.6, 1.6},
       .closed_u = "join",
       .closed_v = "join",
       .equation = torus(2, 0.8, 80)},
      // A sphere, two points of which are one: where the tube is a point.
      {.name = "horn-torus",
       .extents = {4, 4, 2},
       .euler_number = 1,
       .closed_u = "join",
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {v_is(kPi)},
       .equation = torus(1, 1, 24)},
      // Two spheres that share two points.
      {.name = "spindle-torus",
       .extents = {3.2, 3.2, 2},
       .euler_number = 2,
       .closed_u = "join",
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {v_is(std::acos(-0.6)), v_is(2 * kPi - std::acos(-0.6))},
       .equation = torus(0.6, 1, 24)},
      {.name = "cylinder",
       .extents = {2, 2, 2},
       .boundary_loops = 2,
       .closed_u = "join",
       .equation = polynomial(3, 2, [](const dvec3& p) { return sq(p.x) + sq(p.y) - 1; }),
       .gauss = 0},
      // Two discs that share a point.
      {.name = "cone-double",
       .extents = {2, 2, 2},
       .euler_number = 1,
       .boundary_loops = 2,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = {v_is(0)},
       .equation = polynomial(3, 2, [](const dvec3& p) { return sq(p.x) + sq(p.y) - sq(p.z); }),
       .gauss = 0},
      {.name = "hyperboloid-1",
       .extents = {4.705, 4.705, 4.259},
       .boundary_loops = 2,
       .closed_u = "join",
       .equation =
           polynomial(4, 2, [](const dvec3& p) { return sq(p.x) + sq(p.y) - sq(p.z) - 1; })},
      // Two discs.
      {.name = "hyperboloid-2",
       .extents = {4.259, 4.259, 4.705},
       .euler_number = 2,
       .boundary_loops = 2,
       .components = 2,
       .closed_u = "join",
       .singular = {v_is(0)},
       .jumps = {v_is(0)},
       .equation =
           polynomial(4, 2, [](const dvec3& p) { return sq(p.z) - sq(p.x) - sq(p.y) - 1; })},
      {.name = "paraboloid",
       .extents = {4, 4, 4},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_u = "join",
       .singular = {v_is(0)},
       .equation = polynomial(3, 2, [](const dvec3& p) { return sq(p.x) + sq(p.y) - p.z; })},
      {.name = "hyperbolic-paraboloid",
       .extents = {2, 2, 2},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = polynomial(3, 2, [](const dvec3& p) { return sq(p.x) - sq(p.y) - p.z; })},
      {.name = "monkey-saddle",
       .extents = {2, 2, 4},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = polynomial(
           5, 3, [](const dvec3& p) { return p.z - p.x * sq(p.x) + 3 * p.x * sq(p.y); })},
      {.name = "gabriel-horn",
       .extents = {19, 2, 2},
       .boundary_loops = 2,
       .closed_u = "join",
       .equation =
           polynomial(3, 4, [](const dvec3& p) { return sq(p.x) * (sq(p.y) + sq(p.z)) - 1; })},
      // A disc whose middle is infinitely far.
      {.name = "funnel",
       .extents = {4, 4, kEndless},
       .boundary_loops = 2,
       .closed_u = "join",
       .proof = Proof::Fails,
       .poles = {v_is(0)},
       .holed = true,
       .equation =
           polynomial(2, 1, [](const dvec3& p) { return p.z - std::log(sq(p.x) + sq(p.y)) / 2; })},
      // Two spheres that share a point.
      {.name = "eight-surface",
       .extents = {2, 2, 2},
       .euler_number = 3,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = {v_is(-kPi / 2), v_is(0), v_is(kPi / 2)},
       .equation = polynomial(
           10, 4, [](const dvec3& p) { return sq(p.x) + sq(p.y) - 4 * sq(p.z) * (1 - sq(p.z)); })},
      {.name = "astroidal-ellipsoid",
       .extents = {2, 2, 2},
       .euler_number = 2,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = octahedron(),
       .equation = astroid()},
      // A sphere: each of the edges u = 0 and u = pi is folded.
      {.name = "pillow",
       .extents = {2, 2, 1},
       .euler_number = 2,
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {{[](double u, double v) { return std::hypot(std::sin(u), std::sin(v)); }}},
       .equation = polynomial(
           8, 4, [](const dvec3& p) { return 4 * sq(p.z) - (1 - sq(p.x)) * (1 - sq(p.y)); })},
  };
}

std::vector<GalleryFacts> minimal_surfaces() {
  return {
      {.name = "catenoid",
       .extents = {3.621, 3.621, 2.4},
       .boundary_loops = 2,
       .closed_u = "join",
       .equation =
           polynomial(50, 0, [](const dvec3& p) { return sq(p.x) + sq(p.y) - sq(std::cosh(p.z)); }),
       .minimal = true},
      {.name = "helicoid",
       .extents = {3, 3, 3.142},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = polynomial(
           3, 2, [](const dvec3& p) { return p.y * std::cos(2 * p.z) - p.x * std::sin(2 * p.z); }),
       .minimal = true},
      // 2*sinh(1.2), 2*pi: the helicoid, t = 0.
      {.name = "catenoid-helicoid",
       .extents = {3.019, 3.019, 6.283},
       .euler_number = 1,
       .boundary_loops = 1,
       .minimal = true},
      {.name = "enneper",
       .extents = {14.67, 14.67, 8},
       .euler_number = 1,
       .boundary_loops = 1,
       .minimal = true},
      {.name = "enneper-polar",
       .extents = {3.193, 3.193, 2.074},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {u_is(0)},
       .minimal = true},
      {.name = "scherk-1",
       .extents = {3, 3, 5.298},
       .euler_number = 1,
       .boundary_loops = 1,
       .proof = Proof::May,
       .equation = scherk_1(),
       .minimal = true},
      // 13 whole cells and parts of cells in which both cosines have one sign, each a disc;
      // clipped.
      {.name = "scherk-1-chequerboard",
       .extents = {10, 10, 6},
       .euler_number = 13,
       .boundary_loops = 13,
       .components = 13,
       .proof = Proof::Fails,
       .poles = {{[](double u, double v) { return std::cos(u) * std::cos(v); }}},
       .holed = true,
       .equation = scherk_1(),
       .minimal = true},
      {.name = "scherk-2",
       .extents = {1.5, 1.5, 1.485},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = scherk_2(),
       .minimal = true},
      // The four arms of |sinh u sinh v| <= 1. Its normals have limits on the rim, its tangents
      // not.
      {.name = "scherk-2-tower",
       .extents = {6, 6, kPi},
       .euler_number = 1,
       .boundary_loops = 1,
       .proof = Proof::Fails,
       .singular = {{[](double u, double v) { return std::abs(std::sinh(u) * std::sinh(v)) - 1; }}},
       .holed = true,
       .equation = scherk_2(),
       .minimal = true},
      // r(u, v) = r(-u, v + pi) makes it one-sided, which u > 0 does not show: two sheets.
      {.name = "henneberg",
       .extents = {15.77, 15.77, 15.05},
       .boundary_loops = 2,
       .closed_v = "join",
       .minimal = true},
      // The edges u = -2*pi and 2*pi are folded, which leaves one edge. Branch points: (2*k*pi, 0).
      {.name = "catalan",
       .extents = {14.56, 4.705, 6.579},
       .euler_number = 1,
       .boundary_loops = 1,
       .singular = {{[](double u, double v) { return std::hypot(std::sin(u / 2), v); }}},
       .minimal = true},
      {.name = "richmond",
       .extents = {2.042, 1.958, 2.6},
       .boundary_loops = 2,
       .closed_v = "join",
       .minimal = true},
      {.name = "bour",
       .extents = {2.25, 2.597, 2.667},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {u_is(0)},
       .minimal = true},
      // A torus with three holes; clipped. Infinite at (0, 0), (1/2, 0), (0, 1/2) and their copies.
      // Regular elsewhere, also beside tangents that are a thousand times as long.
      {.name = "costa",
       .extents = {6, 6, 6},
       .euler_number = -3,
       .boundary_loops = 3,
       .closed_u = "join",
       .closed_v = "join",
       .proof = Proof::Fails,
       .poles = {{[](double u, double v) {
         return std::abs(std::sin(2 * kPi * u)) + std::abs(std::sin(2 * kPi * v)) +
                std::max(0.0, std::cos(2 * kPi * u) * std::cos(2 * kPi * v)) *
                    std::abs(std::sin(kPi * u) * std::sin(kPi * v));
       }}},
       .holed = true,
       .minimal = true},
  };
}

std::vector<GalleryFacts> pseudospherical_surfaces() {
  // Where w = 1 + u^2 sin(v)^2 is 2 normals turn over, and where r_u is 0: at u = 0.
  const auto kuen_cusps = [](double u, double w) { return u * u / (w * w) - 1; };
  return {
      // A crease along the helix, where both halves of each tangent begin.
      {.name = "tangent-developable",
       .extents = {4.472, 4.472, 3.642},
       .euler_number = 1,
       .boundary_loops = 1,
       .proof = Proof::May,
       .singular = {v_is(0)},
       .gauss = 0},
      {.name = "pseudosphere",
       .extents = {2, 2, 4.01},
       .boundary_loops = 2,
       .closed_u = "join",
       .proof = Proof::May,
       .singular = {v_is(0)},
       .gauss = -1},
      {.name = "dini",
       .extents = {2, 2, 6.839},
       .euler_number = 1,
       .boundary_loops = 1,
       .proof = Proof::May,
       .singular = {v_is(kPi / 2)},
       .gauss = -1 / 1.04},
      {.name = "kuen",
       .extents = {3.024, 2.126, 4.108},
       .euler_number = 1,
       .boundary_loops = 1,
       .proof = Proof::May,
       .singular = {u_is(0), {[=](double u, double v) { return kuen_cusps(u, std::cosh(v)); }}},
       .gauss = -1},
      {.name = "kuen-log",
       .extents = {3.024, 2.126, 3.575},
       .euler_number = 1,
       .boundary_loops = 1,
       .proof = Proof::May,
       .singular = {u_is(0), {[=](double u, double v) { return kuen_cusps(u, 1 / std::sin(v)); }}},
       .gauss = -1},
  };
}

}  // namespace saddle
