#version 330 core
// Whether floats know the normal at a corner: they are given the formula's u and v a little off to
// either side, as interpolation in a triangle leaves them, and compared with the corner's own, which
// comes from doubles. It is none of theirs at cuts, creases, poles and other singular points.

layout(location = 1) in vec3 corner_normal;
layout(location = 2) in vec2 parameters;

out float trust_in_formula;

// What turns a highlight's colour by half a step of 8 bits: colours change by about 2 per radian.
const float ENOUGH = 1e-3;
// Eight units in the last place.
const float OFF = 1.0 / 1048576.0;

bool is_known(vec2 uv) {
  vec3 off = formula_normal(uv.x, uv.y) - corner_normal;
  return dot(off, off) <= ENOUGH * ENOUGH;
}

void main() {
  bool known = is_known(parameters * (1.0 + OFF)) && is_known(parameters * (1.0 - OFF));
  trust_in_formula = known ? 1.0 : 0.0;
}
