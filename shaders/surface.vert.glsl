#version 330 core
// A corner of a surface: to the screen, and to eye coordinates for lighting. Model coordinates are
// the mesh's, recentred and scaled to about 1; model_to_eye is a rotation and a translation.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

// Composed in double: the product of two float matrices would lose depth where the eye is far away.
uniform mat4 model_to_clip;
uniform mat4 model_to_eye;

out vec3 eye_position;
out vec3 eye_normal;

invariant gl_Position;  // the lines' must be the same bits

void main() {
  gl_Position = model_to_clip * vec4(position, 1.0);
  eye_position = (model_to_eye * vec4(position, 1.0)).xyz;
  eye_normal = mat3(model_to_eye) * normal;
}
