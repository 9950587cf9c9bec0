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

vec4 clip_of(vec3 place, vec3 behind) {
  vec4 clip = model_to_clip * vec4(place, 1.0);
  vec4 drawn = model_to_clip * vec4(behind, 1.0);
  if (clip.w > 0.0 && drawn.w > 0.0) clip.z = min(clip.z, drawn.z * (clip.w / drawn.w));
  return clip;
}

void main() {
  vec4 a = clip_of(position, on_mesh);
  vec4 b = clip_of(far_end, far_on_mesh);
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
