#version 330 core
// A piece of a wide line with round ends, as a strip of four corners; of no length: a dot. One
// instance each. A level line is on the screen where the surface has it; the triangles there may
// hide the surface by their error: of both depths it takes the nearer one.

layout(location = 0) in vec3 position;
layout(location = 5) in vec3 far_end;
layout(location = 6) in vec3 on_mesh;  // the same parameters on the triangles
layout(location = 8) in vec3 far_on_mesh;

uniform mat4 model_to_clip;
uniform vec3 half_size;  // of the framebuffer: across, down; and of the line's width, in samples

flat out vec2 from;  // samples from the framebuffer's middle
flat out vec2 to;

vec4 clip(vec3 p, vec3 q) {
  vec4 a = model_to_clip * vec4(p, 1.0), b = model_to_clip * vec4(q, 1.0);
  if (b.w > 0.0) a.z = min(a.z, b.z * a.w / b.w);
  return a;
}

void main() {
  vec4 a = clip(position, on_mesh);
  vec4 b = clip(far_end, far_on_mesh);
  // What is beside or behind the eye has no place on the screen.
  float near = 0.01 * max(a.w, b.w);
  if (near <= 0.0) {
    gl_Position = vec4(2.0);
    return;
  }
  if (a.w < near) a = mix(a, b, (near - a.w) / (b.w - a.w));
  if (b.w < near) b = mix(b, a, (near - b.w) / (a.w - b.w));
  from = a.xy / a.w * half_size.xy;
  to = b.xy / b.w * half_size.xy;
  vec2 way = to - from;
  float size = length(way);
  vec2 along = size > 0.0 ? way / size : vec2(1.0, 0.0);
  bool far = gl_VertexID > 1;
  float r = half_size.z + 1.0;
  float side = gl_VertexID % 2 == 0 ? -r : r;
  vec2 at = (far ? to + r * along : from - r * along) + side * vec2(-along.y, along.x);
  vec4 end = far ? b : a;
  gl_Position = vec4(at / half_size.xy * end.w, end.z, end.w);
}
