#version 330 core
// A corner of a surface: to the screen, and lit here (PER_VERTEX) or sent on to be lit, in eye
// coordinates. Model coordinates are the mesh's, recentred and scaled to about 1.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 corner_normal;
#ifdef COLORED
layout(location = 3) in float corner_color;
#endif
#ifdef EXACT
layout(location = 2) in vec2 parameters;
layout(location = 4) in float trust;
#endif

#ifdef TEXTURED
layout(location = 7) in vec2 corner_place;
out vec2 texture_place;
#endif

// Composed in double: the product of two float matrices would lose depth where the eye is far away.
uniform mat4 model_to_clip;
uniform mat4 model_to_eye;
#ifdef NORMAL_MATRIX
uniform mat3 normal_to_eye;  // where model_to_eye is more than a rotation, a factor and a shift
#endif

#ifdef PER_VERTEX
out vec3 front_color;
#ifdef TEXTURED
out vec3 front_matt;
#endif
#ifdef TWO_SIDED
out vec3 back_color;
#ifdef TEXTURED
out vec3 back_matt;
#endif
#endif
#else
out vec3 eye_position;
out vec3 eye_normal;
#ifdef COLORED
out float color_number;
#endif
#endif
#ifdef EXACT
out vec2 uv;
out float trust_in_formula;  // whether floats know the normal there: shaders/trust.vert.glsl
#endif

invariant gl_Position;  // the lines' must be the same bits

void main() {
  gl_Position = model_to_clip * vec4(position, 1.0);
  vec3 at = (model_to_eye * vec4(position, 1.0)).xyz;
#ifdef NORMAL_MATRIX
  vec3 n = normal_to_eye * corner_normal;
  n *= inversesqrt(max(dot(n, n), 1e-37));  // those of a triangle weigh alike between its corners
#else
  vec3 n = mat3(model_to_eye) * corner_normal;
#endif
#ifdef PER_VERTEX
  n = unit(n);
#ifdef COLORED
  tint = color_of(corner_color);
#endif
  front_color = shade(true, at, n, unit(way_to_eye(at)));
#ifdef TEXTURED
  front_matt = matt;
#endif
#ifdef TWO_SIDED
  back_color = shade(false, at, -n, unit(way_to_eye(at)));
#ifdef TEXTURED
  back_matt = matt;
#endif
#endif
#else
  eye_position = at;
  eye_normal = n;
#ifdef COLORED
  color_number = corner_color;
#endif
#endif
#ifdef TEXTURED
  texture_place = corner_place;
#endif
#ifdef EXACT
  uv = parameters;
  trust_in_formula = trust;
#endif
}
