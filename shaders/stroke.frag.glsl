#version 330 core
// A sample of a wide line: it is no farther from the middle line than half the width.

uniform vec3 half_size;
uniform vec3 line_color;

flat in vec2 from;
flat in vec2 to;

out vec4 pixel;

void main() {
  vec2 from_start = gl_FragCoord.xy - half_size.xy - from;
  vec2 way = to - from;
  float square = dot(way, way);
  float share = square > 0.0 ? clamp(dot(from_start, way) / square, 0.0, 1.0) : 0.0;
  if (distance(from_start, share * way) > half_size.z) discard;
  pixel = vec4(line_color, 1.0);
}
