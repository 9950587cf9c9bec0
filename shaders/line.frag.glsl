#version 330 core
// An unlit line.

uniform vec3 line_color;

out vec4 pixel;

void main() {
  pixel = vec4(line_color, 1.0);
}
