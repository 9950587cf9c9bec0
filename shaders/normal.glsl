// A surface's unit normal from its formula: FORMULA is printed from the derivatives, and needs
// functions of shaders/functions.glsl. CONSTANT_COUNT: numbers in it that depend on parameters and t.
// FLIP: the front is on the other side.
// Those of a plane follow, so that this file is valid on its own.
#ifndef FORMULA
#define FORMULA r_u = vec3(1.0, 0.0, 0.0); r_v = vec3(0.0, 1.0, 0.0);
#endif

#ifdef CONSTANTS
uniform float constant[CONSTANT_COUNT];
#endif

// Tangents whose angle has a smaller sine, squared: there rounding in them turns the normal by more
// than one sees.
const float LEAST_SINE = 1e-6;

// Of a length from 1 to 2; NaN for zero, infinity and NaN. Products of two neither overflow nor
// vanish.
vec3 moderate(vec3 a) {
  return a / max(max(abs(a.x), abs(a.y)), abs(a.z));
}

// Zero where the formula has no normal, or floats do not know it.
vec3 formula_normal(float u, float v) {
  vec3 r_u;
  vec3 r_v;
  FORMULA
#ifdef FLIP
  vec3 n = cross(moderate(r_v), moderate(r_u));
#else
  vec3 n = cross(moderate(r_u), moderate(r_v));
#endif
  float square = dot(n, n);
  return square > LEAST_SINE ? n * inversesqrt(square) : vec3(0.0);
}
