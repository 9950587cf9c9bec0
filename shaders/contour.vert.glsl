#version 330 core
// A vertex of a level line: on the screen where the surface has it. The triangles there may hide the
// surface by their error: of both depths it takes the nearer one.

layout(location = 0) in vec3 position;
layout(location = 6) in vec3 on_mesh;  // the same parameters on the triangles

uniform mat4 model_to_clip;

void main() {
  gl_Position = model_to_clip * vec4(position, 1.0);
  vec4 drawn = model_to_clip * vec4(on_mesh, 1.0);
  if (gl_Position.w > 0.0 && drawn.w > 0.0) {
    gl_Position.z = min(gl_Position.z, drawn.z * (gl_Position.w / drawn.w));
  }
}
