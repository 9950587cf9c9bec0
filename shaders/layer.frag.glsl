#version 330 core
// A layer of see-through surfaces, as it goes under those in front of it; or all of them, as they go
// over what hides (LAST). Colours of layers in front are multiplied by their alphas, others are not.
// Source: T. Porter, T. Duff, "Compositing digital images", 1984.

uniform sampler2D layer;  // LAST: what hides
#ifdef LAST
uniform sampler2D front;
#endif

out vec4 pixel;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 behind = texelFetch(layer, at, 0);
#ifdef LAST
  vec4 over = texelFetch(front, at, 0);
  if (over.a == 0.0) discard;
  float share = (1.0 - over.a) * behind.a;
  float alpha = over.a + share;
  pixel = vec4((over.rgb + share * behind.rgb) / alpha, alpha);
#else
  pixel = vec4(min(behind.rgb, 1.0) * behind.a, behind.a);
#endif
}
