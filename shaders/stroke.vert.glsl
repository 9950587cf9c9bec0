#version 330 core
// A piece of a wide line with round ends, as a strip of four corners; of no length: a dot. One
// instance each.

layout(location = 0) in vec3 position;
layout(location = 5) in vec3 far_end;

uniform mat4 model_to_clip;
uniform vec3 half_size;  // of the framebuffer: across, down; and of the line's width, in samples

flat out vec2 from;  // samples from the framebuffer's middle
flat out vec2 to;

void main() {
  vec4 a = model_to_clip * vec4(position, 1.0);
  vec4 b = model_to_clip * vec4(far_end, 1.0);
  // What is beside or behind the eye has no place on the screen.
  float least = 0.01 * max(a.w, b.w);
  if (least <= 0.0) {
    from = to = vec2(0.0);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  if (a.w < least) a = mix(a, b, (least - a.w) / (b.w - a.w));
  if (b.w < least) b = mix(b, a, (least - b.w) / (a.w - b.w));
  from = a.xy / a.w * half_size.xy;
  to = b.xy / b.w * half_size.xy;
  vec2 way = to - from;
  float length_of_way = length(way);
  vec2 along = length_of_way > 0.0 ? way / length_of_way : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float reach = half_size.z + 1.0;
  bool at_end = (gl_VertexID & 2) != 0;
  float side = (gl_VertexID & 1) == 0 ? -reach : reach;
  vec2 corner = (at_end ? to + reach * along : from - reach * along) + side * across;
  vec4 end = at_end ? b : a;
  gl_Position = vec4(corner / half_size.xy * end.w, end.z, end.w);
}
