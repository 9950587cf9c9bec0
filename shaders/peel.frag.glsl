#version 330 core
// Where the next layer of see-through surfaces is: farther than the one before. The shader's own
// depths are compared, with each other: the depth buffer's have fewer digits.

uniform sampler2D last_depth;  // more than 1 where there is nothing behind

out float depth;

void main() {
  if (gl_FragCoord.z <= texelFetch(last_depth, ivec2(gl_FragCoord.xy), 0).r) discard;
  depth = gl_FragCoord.z;
}
