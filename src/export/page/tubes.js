// Tubes round curves and balls round points, where sliders move them. Other pages lack this.

// A tube or ball goes where its curve or point goes; each corner turns as the curve does.
function follower(s, before) {
  const at = (made, corner) => {
    const o = [];
    made.at(own(made.ends, s.uv[0][corner], 0), own(made.ends, s.uv[1][corner], 1), o);
    return [o.slice(0, 3), unit(o.slice(3, 6))];
  };
  return (corner, p, n) => {
    const [[from, ahead], [to, way]] = [at(before, corner), at(s.made, corner)];
    const axis = cross(ahead, way), angle = Math.atan2(length(axis), dot(ahead, way));
    const turn = d => angle > 0 ? rotated(d, axis, angle) : d;
    return [plus(to, turn(plus(p, from, -1))), turn(n)];
  };
}
