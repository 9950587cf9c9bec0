#version 330 core
// A rectangle of the screen, drawn as a strip of four corners.

uniform vec3 low;  // clip coordinates of opposite corners
uniform vec3 high;

void main() {
  vec2 side = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(mix(low.xy, high.xy, side), 0.0, 1.0);
}
