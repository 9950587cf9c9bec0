#version 330 core
// A sample of a colour bar: the colours from the first, at the bottom, to the last.

uniform sampler2D colormap;
uniform float bottom;  // samples from the framebuffer's lower end
uniform float height;

out vec4 pixel;

void main() {
  float place = clamp((gl_FragCoord.y - bottom) / height, 0.0, 1.0);
  float texels = float(textureSize(colormap, 0).x);
  pixel = vec4(texture(colormap, vec2((place * (texels - 1.0) + 0.5) / texels, 0.5)).rgb, 1.0);
}
