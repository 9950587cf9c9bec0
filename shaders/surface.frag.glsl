#version 330 core
// Phong lighting of both sides in eye coordinates, per pixel.
// The program puts the scene's constants after the first line: LIGHT_COUNT; LIGHTS, one POINT(i) or
// DIRECTIONAL(i) for each; SPECULAR if a material has it; TWO_MATERIALS if the sides differ;
// ORTHOGRAPHIC. Those of the default scene follow, so that this file is valid on its own.
#ifndef LIGHT_COUNT
#define LIGHT_COUNT 3
#define LIGHTS POINT(0) DIRECTIONAL(1) DIRECTIONAL(2)
#define SPECULAR
#define TWO_MATERIALS
#endif

in vec3 eye_position;
in vec3 eye_normal;
out vec4 pixel;

#if LIGHT_COUNT > 0
uniform vec3 light_position[LIGHT_COUNT];  // of a point light; toward a directional one, unit
uniform vec3 light_color[LIGHT_COUNT];
#endif
uniform vec3 front_diffuse;
#ifdef TWO_MATERIALS
uniform vec3 back_diffuse;
#endif
#ifdef SPECULAR
uniform vec3 front_specular;
uniform float front_shininess;
#ifdef TWO_MATERIALS
uniform vec3 back_specular;
uniform float back_shininess;
#endif
#endif

// Zero for a zero vector, which normalize leaves undefined: a light at the shaded point.
vec3 unit(vec3 w) {
  float square = dot(w, w);
  return square > 0.0 ? w * inversesqrt(square) : vec3(0.0);
}

// The side is the winding's, never the sign of normal.view: an interpolated normal may lean away
// from the viewer at a silhouette, and is then pulled back into the plane of sight.
vec3 facing_normal(vec3 to_eye) {
  vec3 n = unit(gl_FrontFacing ? eye_normal : -eye_normal);
  return unit(n - min(0.0, dot(n, to_eye)) * to_eye);
}

vec3 normal;
vec3 to_eye;
vec3 diffuse = vec3(0.0);  // light that arrives, before the material
#ifdef SPECULAR
vec3 specular = vec3(0.0);
float shininess;
#endif

void add_light(vec3 toward, vec3 color) {
  float n_l = dot(normal, toward);
  diffuse += max(0.0, n_l) * color;
#ifdef SPECULAR
  // r_v = dot(-reflect(toward, normal), to_eye). pow is undefined at (0, 0) and below 0; the
  // least base keeps exponent 0 away from 0 * infinity.
  float r_v = 2.0 * n_l * dot(normal, to_eye) - dot(toward, to_eye);
  if (n_l > 0.0 && r_v > 0.0) specular += pow(max(r_v, 1e-30), shininess) * color;
#endif
}
#define DIRECTIONAL(i) add_light(light_position[i], light_color[i]);
#define POINT(i) add_light(unit(light_position[i] - eye_position), light_color[i]);

void main() {
#ifdef ORTHOGRAPHIC
  to_eye = vec3(0.0, 0.0, 1.0);
#else
  to_eye = unit(-eye_position);
#endif
  normal = facing_normal(to_eye);
#ifdef TWO_MATERIALS
  vec3 diffuse_color = gl_FrontFacing ? front_diffuse : back_diffuse;
#else
  vec3 diffuse_color = front_diffuse;
#endif
#ifdef SPECULAR
#ifdef TWO_MATERIALS
  vec3 specular_color = gl_FrontFacing ? front_specular : back_specular;
  shininess = gl_FrontFacing ? front_shininess : back_shininess;
#else
  vec3 specular_color = front_specular;
  shininess = front_shininess;
#endif
#endif
  LIGHTS
  vec3 color = diffuse * diffuse_color;
#ifdef SPECULAR
  color += specular * specular_color;
#endif
  pixel = vec4(color, 1.0);
}
