#version 330 core
// A sample of a line of text: as much ink as its letters cover.

uniform sampler2D letters;  // rows from the top
uniform vec3 corner;        // the sample at their upper left
uniform vec3 ink;

out vec4 pixel;

void main() {
  vec2 from_corner = gl_FragCoord.xy - corner.xy;
  ivec2 texel = ivec2(floor(vec2(from_corner.x, -from_corner.y)));
  pixel = vec4(ink, texelFetch(letters, texel, 0).r);
}
