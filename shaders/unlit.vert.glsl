#version 330 core
// A corner of a line, or of a layer that is looked for: on the screen exactly where the surface has
// it when it is lit.

layout(location = 0) in vec3 position;

uniform mat4 model_to_clip;

invariant gl_Position;

void main() {
  gl_Position = model_to_clip * vec4(position, 1.0);
}
