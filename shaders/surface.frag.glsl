#version 330 core
// A pixel of a surface: lit here, or the mean of colours that its corners have (PER_VERTEX).

#ifdef PER_VERTEX
in vec3 front_color;
#ifdef TEXTURED
in vec3 front_matt;
#endif
#ifdef TWO_SIDED
in vec3 back_color;
#ifdef TEXTURED
in vec3 back_matt;
#endif
#endif
#else
in vec3 eye_position;
in vec3 eye_normal;
#ifdef COLORED
in float color_number;
#endif
#endif
#ifdef EXACT
in vec2 uv;  // where the formula gives the normal
in float trust_in_formula;
#ifdef NORMAL_MATRIX
uniform mat3 normal_to_eye;
#else
uniform mat4 model_to_eye;
#endif
#endif

#ifdef SEE_THROUGH
uniform float opacity;  // of a see-through surface
#endif
#ifdef TEXTURED
in vec2 texture_place;  // 0 to 1 over the ranges of u and v
uniform vec3 texture_scale;  // how often the picture repeats, or how many cells there are; z is 1
#endif
#ifdef PICTURE
uniform sampler2D picture;
#endif

out vec4 pixel;

#ifdef PICTURE
vec3 texel_here() {
  return texture(picture, texture_place * texture_scale.xy).rgb;
}
#endif
#ifdef CHECKER
// Every other cell reflects less.
const float DARK_CELL = 0.4;
const float LEAST_FOOTPRINT = 1e-6;

// Goes down by 1/2 over even cells and up over odd ones: its difference over a width is how much
// more of the width is in even cells than in odd ones.
vec2 zigzag(vec2 at) {
  return abs(fract(0.5 * at) - 0.5);
}

// The mean over the pixel.
vec3 texel_here() {
  vec2 at = texture_place * texture_scale.xy;
  vec2 width = max(fwidth(at), vec2(LEAST_FOOTPRINT));
  vec2 even = 2.0 * (zigzag(at - 0.5 * width) - zigzag(at + 0.5 * width)) / width;
  return vec3(mix(DARK_CELL, 1.0, 0.5 + 0.5 * even.x * even.y));
}
#endif

#ifndef PER_VERTEX
// The side is the winding's, never the sign of normal.view: an interpolated normal may lean away
// from the viewer at a silhouette, and is then pulled back into the plane of sight. Neither vector
// need have length 1: a dull surface needs the direction to the eye nowhere else.
vec3 facing(vec3 n, vec3 way) {
  return unit(n - (min(0.0, dot(n, way)) / max(dot(way, way), LEAST_SQUARE)) * way);
}
#endif

#ifdef EXACT
// Near a corner where the formula is not to be trusted, over an eighth of the way from there to
// others, the interpolated normal becomes the formula's.
vec3 surface_normal() {
  vec3 between = unit(eye_normal);
  float share = clamp(8.0 * trust_in_formula, 0.0, 1.0);
  vec3 n = formula_normal(uv.x, uv.y);
  if (share == 0.0 || !(dot(n, n) > 0.0)) return between;
#ifdef NORMAL_MATRIX
  n = unit(normal_to_eye * n);
#else
  n = unit(mat3(model_to_eye) * n);
#endif
  return share == 1.0 ? n : unit(mix(between, n, share));
}
#endif

vec3 color() {
#ifdef PER_VERTEX
#ifdef TEXTURED
  vec3 texel = texel_here();
#ifdef TWO_SIDED
  return gl_FrontFacing ? front_color + front_matt * texel : back_color + back_matt * texel;
#else
  return front_color + front_matt * texel;
#endif
#else
#ifdef TWO_SIDED
  return gl_FrontFacing ? front_color : back_color;
#else
  return front_color;
#endif
#endif
#else
  vec3 way = way_to_eye(eye_position);
#ifdef EXACT
  vec3 n = surface_normal();
#else
  vec3 n = eye_normal;
#endif
#ifdef TWO_SIDED
  bool front = gl_FrontFacing;
  n = front ? n : -n;
#else
  const bool front = true;
#endif
#ifdef COLORED
  tint = color_of(color_number);
#endif
#ifdef TEXTURED
  texel = texel_here();
#endif
  return shade(front, eye_position, facing(n, way), unit(way));
#endif
}

void main() {
#ifdef SEE_THROUGH
  pixel = vec4(color(), opacity);
#else
  pixel = vec4(color(), 1.0);
#endif
}
