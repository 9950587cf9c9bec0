// The lighting equation in eye coordinates, for the stage that lights: it goes in front of the
// surface's fragment shader, or, PER_VERTEX, of its vertex shader. The program keeps of it what a
// scene needs, by these names:
//   LIT          there are lights: LIGHT_COUNT of them, and LIGHTS, a call for each
//   DIRECTIONAL, AT_EYE, POINT, ATTENUATED, SPOT, SMOOTH_SPOT   there is a light of this kind
//   GREY         no light has a hue: a number is as good as a colour
//   ATTENUATION  some light, a spot light perhaps, is weaker from afar
//   FADES        some light does not arrive in full: ATTENUATED, SPOT or SMOOTH_SPOT
//   CONE         SPOT or SMOOTH_SPOT; FOCUS: some cone has an exponent
//   AMBIENT      some light has an ambient part
//   SPECULAR     some material mirrors; HIGHLIGHTS: light has a colour of its own for that; BLINN
//   POWERS       SPECULAR or FOCUS
//   EMISSION     some material shines by itself
//   UNLIT        there is no light: the colour as it is
//   COLORED      the surface has a colour of its own at each point, in place of its materials'
//   TEXTURED     the fragment shader multiplies what is reflected diffusely, `matt`, by a texel:
//                that of a PICTURE, in place of the materials' colours, or of a CHECKER
//   TWO_SIDED    back faces are seen; TWO_MATERIALS: they look different
// Those of the default scene follow, so that this file is valid on its own.
#ifndef LIGHT_COUNT
#define LIT
#define LIGHT_COUNT 3
#define LIGHTS directional_light(0); directional_light(1); light_at_eye(2);
#define DIRECTIONAL
#define AT_EYE
#define GREY
#define SPECULAR
#define POWERS
#define TWO_SIDED
#define TWO_MATERIALS
#endif
#define MATT color

#ifdef LIT
#ifdef GREY
#define RGB_OR_GREY float
#else
#define RGB_OR_GREY vec3
#endif
uniform vec3 light_position[LIGHT_COUNT];  // of a point light; toward a directional one, unit
uniform RGB_OR_GREY light_color[LIGHT_COUNT];
#ifdef HIGHLIGHTS
uniform RGB_OR_GREY light_highlight[LIGHT_COUNT];
#endif
#ifdef AMBIENT
uniform RGB_OR_GREY light_ambient[LIGHT_COUNT];
#endif
#ifdef ATTENUATION
uniform vec3 light_attenuation[LIGHT_COUNT];  // constant, linear and quadratic
#endif
#ifdef CONE
uniform vec3 spot_direction[LIGHT_COUNT];  // unit
uniform vec3 spot_edge[LIGHT_COUNT];  // cosine of the cutoff, 1 / width of the edge, exponent
#endif
#endif

#ifdef COLORED
uniform sampler2D colormap;
uniform float color_scale;  // from the mesh's numbers to places in the colormap
uniform float color_offset;
vec3 tint;  // of the point that is lit
#else
#ifndef PICTURE
uniform vec3 front_diffuse;
#endif
#endif
#ifdef TEXTURED
vec3 matt;  // what is reflected diffusely, but for the texel
#ifndef PER_VERTEX
vec3 texel;  // of the point that is lit
#endif
#endif
#ifdef SPECULAR
uniform vec3 front_specular;
uniform float front_shininess;
#endif
#ifdef AMBIENT
#ifndef COLORED
#ifndef PICTURE
uniform vec3 front_ambient;
#endif
#endif
#endif
#ifdef EMISSION
uniform vec3 front_emission;
#endif
#ifdef TWO_MATERIALS
#ifndef COLORED
#ifndef PICTURE
uniform vec3 back_diffuse;
#endif
#endif
#ifdef SPECULAR
uniform vec3 back_specular;
uniform float back_shininess;
#endif
#ifdef AMBIENT
#ifndef COLORED
#ifndef PICTURE
uniform vec3 back_ambient;
#endif
#endif
#endif
#ifdef EMISSION
uniform vec3 back_emission;
#endif
#endif

// Squares of lengths are divided by no less, about the least float.
const float LEAST_SQUARE = 1e-37;

// Zero for a zero vector, which normalize leaves undefined: a light at the shaded point, an eye at
// it, a normal at a singular point.
vec3 unit(vec3 w) {
  return w * inversesqrt(max(dot(w, w), LEAST_SQUARE));
}

#ifdef POWERS
// pow is undefined below 0 and at (0, 0); the least base keeps exponent 0 away from 0 * infinity.
const float LEAST_BASE = 1e-30;
#endif

#ifdef LIT
// The point that is lit.
vec3 place;
vec3 normal;
vec3 to_eye;

// Light that arrives, before the material.
RGB_OR_GREY diffuse;
#ifdef SPECULAR
RGB_OR_GREY specular;
float shininess;
#endif
#ifdef AMBIENT
RGB_OR_GREY ambient;
#endif
#ifdef FADES
float strength;  // of the light at hand where it arrives
#endif

void shine(int i, vec3 toward) {
  float n_l = dot(normal, toward);
  float received = max(0.0, n_l);
#ifdef FADES
  received *= strength;
#endif
  diffuse += received * light_color[i];
#ifdef SPECULAR
#ifdef BLINN
  float cosine = dot(normal, unit(toward + to_eye));
#else
  float cosine = 2.0 * n_l * dot(normal, to_eye) - dot(toward, to_eye);  // -reflect . to_eye
#endif
  if (n_l <= 0.0 || cosine <= 0.0) return;
  float mirrored = pow(max(cosine, LEAST_BASE), shininess);
#ifdef FADES
  mirrored *= strength;
#endif
#ifdef HIGHLIGHTS
  specular += mirrored * light_highlight[i];
#else
  specular += mirrored * light_color[i];
#endif
#endif
}

#ifdef DIRECTIONAL
void directional_light(int i) {
#ifdef FADES
  strength = 1.0;
#endif
#ifdef AMBIENT
  ambient += light_ambient[i];
#endif
  shine(i, light_position[i]);
}
#endif

#ifdef AT_EYE
void light_at_eye(int i) {
#ifdef FADES
  strength = 1.0;
#endif
#ifdef AMBIENT
  ambient += light_ambient[i];
#endif
  shine(i, to_eye);
}
#endif

#ifdef POINT
void point_light(int i) {
#ifdef FADES
  strength = 1.0;
#endif
#ifdef AMBIENT
  ambient += light_ambient[i];
#endif
  shine(i, unit(light_position[i] - place));
}
#endif

#ifdef ATTENUATION
// At least some light: the constant may be 0, and so the distance.
float attenuation(int i, float d) {
  vec3 k = light_attenuation[i];
  return 1.0 / max(k.x + d * (k.y + d * k.z), 1e-30);
}
#endif

#ifdef ATTENUATED
void attenuated_light(int i) {
  vec3 way = light_position[i] - place;
  strength = attenuation(i, length(way));
#ifdef AMBIENT
  ambient += strength * light_ambient[i];
#endif
  shine(i, unit(way));
}
#endif

#ifdef CONE
// How much of a cone's light leaves at this angle from its axis; `edge` is its share at the rim.
float focused(int i, float cosine, float edge) {
#ifdef FOCUS
  return edge * pow(max(cosine, LEAST_BASE), spot_edge[i].z);
#else
  return edge;
#endif
}

// 0 at the cutoff, 1 from the inner angle on. A hard edge is as narrow as a float can have it.
float rim(int i, float cosine) {
  return clamp((cosine - spot_edge[i].x) * spot_edge[i].y, 0.0, 1.0);
}

vec3 start_cone(int i) {
  vec3 way = light_position[i] - place;
#ifdef ATTENUATION
  strength = attenuation(i, length(way));
#else
  strength = 1.0;
#endif
#ifdef AMBIENT
  ambient += strength * light_ambient[i];
#endif
  return unit(way);
}
#endif

#ifdef SPOT
void spot_light(int i) {
  vec3 toward = start_cone(i);
  float cosine = -dot(toward, spot_direction[i]);
  strength *= focused(i, cosine, rim(i, cosine));
  shine(i, toward);
}
#endif

#ifdef SMOOTH_SPOT
void smooth_spot_light(int i) {
  vec3 toward = start_cone(i);
  float cosine = -dot(toward, spot_direction[i]);
  float a = rim(i, cosine);
  strength *= focused(i, cosine, a * a * (3.0 - 2.0 * a));
  shine(i, toward);
}
#endif
#endif

// What the front or the back sends to the eye; `n` is the unit normal of that side. MATT is `matt`
// with a texture, else `color`.
vec3 shade(bool front, vec3 at, vec3 n, vec3 eye_direction) {
  vec3 color = vec3(0.0);
#ifdef TEXTURED
  matt = vec3(0.0);
#endif
#ifdef UNLIT
#ifdef COLORED
  color = tint;
#else
#ifdef PICTURE
  matt = vec3(1.0);
#else
#ifdef TWO_MATERIALS
  MATT = front ? front_diffuse : back_diffuse;
#else
  MATT = front_diffuse;
#endif
#endif
#endif
#endif
#ifdef EMISSION
#ifdef TWO_MATERIALS
  color += front ? front_emission : back_emission;
#else
  color += front_emission;
#endif
#endif
#ifdef LIT
  place = at;
  normal = n;
  to_eye = eye_direction;
  diffuse = RGB_OR_GREY(0.0);
#ifdef SPECULAR
  specular = RGB_OR_GREY(0.0);
#ifdef TWO_MATERIALS
  shininess = front ? front_shininess : back_shininess;
#else
  shininess = front_shininess;
#endif
#endif
#ifdef AMBIENT
  ambient = RGB_OR_GREY(0.0);
#endif
  LIGHTS
#ifdef COLORED
  color += diffuse * tint;
#else
#ifdef PICTURE
  matt += vec3(diffuse);
#else
#ifdef TWO_MATERIALS
  MATT += diffuse * (front ? front_diffuse : back_diffuse);
#else
  MATT += diffuse * front_diffuse;
#endif
#endif
#endif
#ifdef SPECULAR
#ifdef TWO_MATERIALS
  color += specular * (front ? front_specular : back_specular);
#else
  color += specular * front_specular;
#endif
#endif
#ifdef AMBIENT
#ifdef COLORED
  color += ambient * tint;
#else
#ifdef PICTURE
  matt += vec3(ambient);
#else
#ifdef TWO_MATERIALS
  MATT += ambient * (front ? front_ambient : back_ambient);
#else
  MATT += ambient * front_ambient;
#endif
#endif
#endif
#endif
#endif
#ifdef TEXTURED
#ifndef PER_VERTEX
  color += matt * texel;
#endif
#endif
  return color;
}

// The way to the eye, of any length.
vec3 way_to_eye(vec3 at) {
#ifdef ORTHOGRAPHIC
  return vec3(0.0, 0.0, 1.0);
#else
  return -at;
#endif
}

#ifdef COLORED
// The colour of a number; what has none, -1 at all corners of a triangle, is grey. The colormap's
// first and last colours are in the middles of its first and last texel.
vec3 color_of(float number) {
  if (number < -0.5) return vec3(0.5);
  float place = clamp(color_scale * number + color_offset, 0.0, 1.0);
  float texels = float(textureSize(colormap, 0).x);
  return texture(colormap, vec2((place * (texels - 1.0) + 0.5) / texels, 0.5)).rgb;
}
#endif
