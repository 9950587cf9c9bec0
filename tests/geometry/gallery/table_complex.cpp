// Facts of surfaces that are made of complex numbers, vectors and sums.
#include "geometry/gallery/special_values.h"
#include "geometry/gallery/table_parts.h"

namespace saddle {
namespace {

using complex = std::complex<double>;

/// Bryant and Kusner's three harmonic functions, over their squares' sum.
double bryant_kusner(const dvec3& p, double u, double v) {
  const complex w = std::polar(1.0, u) * std::tan(v / 2);
  const complex w3 = w * w * w;
  const complex m = w3 * w3 + std::sqrt(5.0) * w3 - 1.0;
  const dvec3 g(-1.5 * std::imag(w * (1.0 - w * w3) / m), -1.5 * std::real(w * (1.0 + w * w3) / m),
                std::imag((1.0 + w3 * w3) / m) - 0.5);
  return glm::length(p * glm::dot(g, g) - g);
}

/// Im(a conj(b)^2) = 0 in the 3-sphere |a|^2 + |b|^2 = 1, seen from (a, b) = (i, 1) / sqrt(2).
double lawson(const dvec3& p) {
  const double square = glm::dot(p, p);
  const double along = (square - 1) / std::sqrt(2.0);
  const complex a(2 * p.x, std::sqrt(2.0) * p.y + along);
  const complex b(-std::sqrt(2.0) * p.y + along, 2 * p.z);
  return std::imag(a * std::conj(b * b));
}

/// Hopf's map of a point of the 3-sphere, seen from (0, i), against the curve.
double hopf(const dvec3& p, double u, double) {
  const double square = glm::dot(p, p);
  const complex a(2 * p.x, 2 * p.y);
  const complex b(2 * p.z, square - 1);
  const double height = std::norm(a) - std::norm(b);
  const complex across = 2.0 * std::conj(a) * b;
  const double angle = kPi / 2 + 0.5 * std::sin(3 * u);
  const double whole = sq(square + 1);
  return std::abs(height - whole * std::cos(angle)) +
         std::abs(across - std::polar(whole * std::sin(angle), u));
}

/// The torus, reflected once more in the sphere of radius 3 around (4, 0, 0), and in that point.
double cyclide(const dvec3& p) {
  const dvec3 c(4, 0, 0);
  const dvec3 q = c - 9.0 * (p - c) / glm::dot(p - c, p - c);
  return sq(std::hypot(q.x, q.y) - 2) + sq(q.z) - 0.64;
}

double trefoil_on_torus(const dvec3& p, double u, double) {
  const double r = 2 + std::cos(3 * u);
  const double r_u = -3 * std::sin(3 * u);
  const dvec3 out(std::cos(2 * u), std::sin(2 * u), 0);
  const dvec3 off = p - (r * out + dvec3(0, 0, std::sin(3 * u)));
  const dvec3 along =
      r_u * out + 2 * r * dvec3(-out.y, out.x, 0) + dvec3(0, 0, 3 * std::cos(3 * u));
  return std::abs(glm::dot(off, off) - 0.16) + std::abs(glm::dot(off, along));
}

/// By Chebyshev's polynomials: cos(3 a) = 4 cos(a)^3 - 3 cos(a).
double weierstrass(const dvec3& p) {
  const auto tripled = [](double c) { return c * (4 * c * c - 3); };
  double x = std::cos(kPi * p.x);
  double y = std::cos(kPi * p.y);
  double sum = 0;
  for (double share = 0.25; share > 0.03; share /= 2) {
    sum += share * x * y;
    x = tripled(x);
    y = tripled(y);
  }
  return p.z - sum;
}

/// The odd modes: the others are not plucked.
double drum(const dvec3& p) {
  const auto amplitude = [](int n) { return 8 * (n % 4 == 1 ? 1 : -1) / sq(n * kPi); };
  double sum = 0;
  for (int m = 1; m < 16; m += 2) {
    for (int n = 1; n < 16; n += 2) {
      sum += amplitude(m) * amplitude(n) * std::sin(m * p.x) * std::sin(n * p.y) *
             std::cos(0.8 * std::sqrt(double(m * m + n * n)));
    }
  }
  return p.z - 2 * sum;
}

}  // namespace

std::vector<GalleryFacts> minimal_surfaces_of_complex_numbers() {
  return {
      {.name = "enneper-order",
       .extents = {2.974, 3.395, 2.304},
       .euler_number = 1,
       .boundary_loops = 1,
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {u_is(0)},
       .minimal = true},
      // r(u, v) = r(-u, v + pi). Branch points: (0, k*pi/2).
      {.name = "henneberg-band",
       .extents = {9.135, 9.135, 10.31},
       .boundary_loops = 1,
       .orientable = false,
       .closed_v = "reversed",
       .singular = {{[](double u, double v) { return std::hypot(u, std::sin(2 * v)); }}},
       .minimal = true},
      // As Catalan's.
      {.name = "catalan-bjorling",
       .extents = {14.56, 4.705, 6.579},
       .euler_number = 1,
       .boundary_loops = 1,
       .singular = {{[](double u, double v) { return std::hypot(std::sin(u / 2), v); }}},
       .minimal = true},
      // A sphere with three holes, whose poles are w = 0 and infinity.
      {.name = "trinoid",
       .extents = {5.006, 5.78, 4},
       .euler_number = -1,
       .boundary_loops = 3,
       .closed_u = "join",
       .proof = Proof::Fails,
       .singular = {v_is(0), v_is(kPi)},
       .holed = true,
       .minimal = true},
      // A torus with a hole.
      {.name = "chen-gackstatter",
       .extents = {5.227, 5.227, 6.302},
       .euler_number = -1,
       .boundary_loops = 1,
       .closed_u = "join",
       .closed_v = "join",
       .proof = Proof::Fails,
       .holed = true,
       .minimal = true},
  };
}

std::vector<GalleryFacts> surfaces_of_the_three_sphere() {
  return {
      {.name = "lawson-klein",
       .extents = {5.749, 5.447, 7.304},
       .orientable = false,
       .closed_u = "reversed",
       .closed_v = "join",
       .equation = polynomial(40, 6, lawson)},
      {.name = "boy-bryant-kusner",
       .extents = {2.6, 2.589, 2.443},
       .euler_number = 1,
       .orientable = false,
       .closed_u = "reversed",
       .closed_v = "join",
       .proof = Proof::May,
       .singular = {v_is(0)},
       .equation = at_parameters(20, 1, bryant_kusner)},
      {.name = "hopf-torus",
       .extents = {6.088, 6.601, 3.372},
       .closed_u = "join",
       .closed_v = "join",
       .equation = at_parameters(20, 4, hopf)},
      {.name = "dupin-cyclide",
       .extents = {6.177, 6.176, 4.286},
       .closed_u = "join",
       .closed_v = "join",
       .equation = polynomial(80, 2, cyclide)},
      {.name = "torus-knot",
       .extents = {6.164, 6.457, 2.8},
       .closed_u = "join",
       .closed_v = "join",
       .equation = at_parameters(40, 2, trefoil_on_torus)},
  };
}

std::vector<GalleryFacts> functions_and_sums() {
  return {
      // The figure |Im z| = arcosh: two cups that share a segment. Branch points: +-1.
      {.name = "riemann-asin-imaginary",
       .extents = {4.705, 4.259, 3},
       .boundary_loops = 2,
       .closed_u = "join",
       .singular = {{[](double u, double v) { return std::hypot(std::cos(u), v); }}},
       .equation = polynomial(100, 0,
                              [](const dvec3& p) {
                                const double s = sq(std::sinh(p.z));
                                const double c = sq(std::cosh(p.z));
                                return sq(p.x) * s + sq(p.y) * c - s * c;
                              })},
      {.name = "riemann-conic",
       .extents = {3.086, 2.35, 2.35},
       .boundary_loops = 2,
       .closed_v = "join",
       .singular = {{[](double u, double v) { return std::hypot(u, std::sin(v)); }}},
       .equation = polynomial(6, 4,
                              [](const dvec3& p) {
                                const double h = sq(p.z);
                                return h * (h - sq(p.x) + sq(p.y) + 1) - sq(p.x * p.y);
                              })},
      // A disc without four poles; clipped.
      {.name = "gamma-modulus",
       .extents = {7.5, 6, 6.5},
       .euler_number = -3,
       .boundary_loops = 5,
       .proof = Proof::Fails,
       .poles = {{[](double u, double v) { return std::hypot(std::sin(kPi * u) / kPi, v); }}},
       .holed = true,
       .equation = at_parameters(40, 1,
                                 [](const dvec3& p, double u, double v) {
                                   return p.z - gamma_modulus({u, v});
                                 })},
      // A disc without its pole; clipped.
      {.name = "zeta-modulus",
       .extents = {2.95, 7.25, 4},
       .boundary_loops = 2,
       .proof = Proof::Fails,
       .equation = at_parameters(200, 1,
                                 [](const dvec3& p, double u, double v) {
                                   return p.z - std::abs(zeta({u, v}));
                                 })},
      {.name = "weierstrass-function",
       .extents = {1, 1, 0.9375},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = polynomial(1000, 0, weierstrass)},
      {.name = "fourier-drum",
       .extents = {kPi, kPi, 0.4815},
       .euler_number = 1,
       .boundary_loops = 1,
       .equation = polynomial(20, 0, drum)},
  };
}

}  // namespace saddle
