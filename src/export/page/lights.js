// The lights as the shaders' uniforms: render/shading/shader_lights.cpp.

function lightUniforms(lights, nodes, c) {
  const frame = light => nodes[light.frame == -2 ? -1 : light.frame];
  const toward = (light, d) => light.frame == -3 ? unit(d) : unit(c.axes.map(a => dot(a, unit(turned(frame(light), d)))));
  const point = light => {
    const p = light.frame == -3 ? light.position : inEye(c, placed(frame(light), light.position));
    const far = length(p);
    return times(p, far > 1e9 * scene.unit ? 1e9 / far : 1 / scene.unit);
  };
  const clamped = color => color.map(x => Math.min(x, 1e6));
  return lights.map(light => {
    const on = light.enabled ? 1 : 0;
    return {
      light_position: light.directional ? toward(light, light.position) : point(light),
      light_color: times(clamped(light.color), on),
      light_highlight: times(clamped(light.highlight), on),
      light_ambient: times(clamped(light.ambient), on),
      light_attenuation: light.attenuation.map((x, k) => Math.min(x * scene.unit ** k, 1e30)),
      spot_direction: light.spot ? toward(light, light.spot[0]) : [0, 0, 0],
      spot_edge: light.spot ? (([_, cutoff, inner, exponent]) => {
        const edge = Math.cos(cutoff * Math.PI / 180);
        return [edge, 1 / Math.max(Math.cos(inner * Math.PI / 180) - edge, 1e-9), Math.min(exponent, 1e9)];
      })(light.spot) : [0, 0, 0],
    };
  });
}
