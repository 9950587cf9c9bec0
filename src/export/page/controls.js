// What hands and keys do. `page` is the state that main.js draws; page.refit() brings its camera up
// to date with what other hands did since.

// The eye goes round the middle of what is drawn, or, if a hand has moved that aside, round the
// target. It never tips over.
function turn(page, across, down) {
  page.refit();
  const {axes, up, target, width, height} = page.c, u = unit(up);
  let view = rotated(axes[2], u, -across);
  const pole = Math.acos(Math.min(Math.max(dot(unit(view), u), -1), 1));
  const angle = Math.min(Math.max(pole - down, 0.01), Math.PI - 0.01) - pole;
  eye.view = rotated(view, cross(u, view), angle);
  if (!eye.moved) return;
  const middle = onScreen(page.c, scene.centre);
  const isAside = !middle || Math.abs(middle[0] / width - 0.5) > 0.25 || Math.abs(middle[1] / height - 0.5) > 0.25;
  eye.target = carried(isAside ? target : scene.centre, target, axes, axesOf(eye.view, up));
}

function pan(page, across, down) {
  page.refit();
  const {axes, half, height} = page.c, scale = 2 * half / height;
  hold(page);
  eye.target = plus(plus(eye.target, axes[0], -across * scale), axes[1], down * scale);
}

// Toward the point under the pointer, which stays there.
function zoom(page, factor, x, y) {
  page.refit();
  const {c} = page;
  hold(page);
  const [across, up] = beside(c, x, y);
  eye.target = plus(plus(eye.target, c.axes[0], across * (1 - factor)), c.axes[1], up * (1 - factor));
  eye.distance *= factor;
}

function goHome() {
  Object.assign(eye, {view: null, target: scene.target, distance: scene.distance, moved: false});
}

// From now on the hand has the camera, not the scene's own expressions.
function hold(page) {
  const {c} = page;
  Object.assign(eye, {view: c.axes[2], target: c.target, distance: c.distance, moved: true});
}

// Where a line of sight first meets a surface.
function pick(page, x, y) {
  const [origin, direction] = sight(page.c, x, y);
  let best = null;
  for (const {s, node, matrix} of page.items) {
    const world = i => placed(matrix, s.position.subarray(3 * i, 3 * i + 3));
    for (let i = 0; i < s.drawn.length; i += 3) {
      const t = s.drawn.subarray(i, i + 3), a = world(t[0]);
      const ab = plus(world(t[1]), a, -1), ac = plus(world(t[2]), a, -1);
      const h = cross(direction, ac), det = dot(ab, h);
      if (!det) continue;
      const from = plus(origin, a, -1), b = dot(from, h) / det, q = cross(from, ab), g = dot(direction, q) / det;
      const way = dot(ac, q) / det;
      if (b < 0 || g < 0 || b + g > 1 || way < 0 || (best && way >= best.way)) continue;
      best = {s, node, matrix, way, weights: [1 - b - g, b, g], corners: Array.from(t)};
    }
  }
  if (!best) return null;
  const {s, node, weights, corners} = best;
  return reading({s, node, weights, corners}, best.matrix);
}

// What there is at a place of a surface, at the parameters that the page has.
function reading({s, node, weights, corners}, matrix) {
  const mean = of => corners.reduce((sum, i, k) => sum + weights[k] * of(i), 0);
  const of = array => [0, 1, 2].map(j => mean(i => array[3 * i + j]));
  const [u, v] = [0, 1].map(j => own(s.made.ends, mean(i => s.uv[j][i]), j)), o = s.outputs;
  s.made.at(u, v, o);
  const position = s.fixed ? of(s.position) : [o[0], o[1], o[2]];
  const normal = s.fixed ? unit(of(s.normal)) : times(unit(cross([o[3], o[4], o[5]], [o[6], o[7], o[8]])), s.flip ? -1 : 1);
  return {s, node, weights, corners, uv: [u, o[9]], position, normal, world: placed(matrix, position)};
}

function listen(canvas, page) {
  const pointers = new Map();
  const place = e => {
    const r = canvas.getBoundingClientRect();
    return [e.clientX - r.left, e.clientY - r.top];
  };
  const on = (name, act) => canvas.addEventListener(name, e => { act(e); changed(); }, {passive: false});
  const gap = ([p, q]) => [Math.hypot(p[0] - q[0], p[1] - q[1]), (p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
  on('pointerdown', e => {
    canvas.setPointerCapture(e.pointerId);
    pointers.set(e.pointerId, place(e));
  });
  on('pointermove', e => {
    if (!pointers.has(e.pointerId)) return;
    const old = [...pointers.values()], [x, y] = pointers.get(e.pointerId), now = place(e);
    pointers.set(e.pointerId, now);
    if (pointers.size == 2) {
      const [a, b] = [gap(old), gap([...pointers.values()])];
      zoom(page, a[0] / b[0], b[1], b[2]);
      pan(page, b[1] - a[1], b[2] - a[2]);
    } else if (e.shiftKey || e.buttons & 2) {
      pan(page, now[0] - x, now[1] - y);
    } else {
      turn(page, (now[0] - x) * 0.01, (now[1] - y) * 0.01);
    }
  });
  for (const name of ['pointerup', 'pointercancel']) on(name, e => pointers.delete(e.pointerId));
  on('contextmenu', e => e.preventDefault());
  on('wheel', e => {
    e.preventDefault();
    zoom(page, Math.exp(e.deltaY * (e.deltaMode ? 0.03 : 0.001)), ...place(e));
  });
  on('dblclick', e => page.tell(pick(page, ...place(e))));
  const keys = {
    ArrowLeft: () => turn(page, -0.1, 0), ArrowRight: () => turn(page, 0.1, 0),
    ArrowUp: () => turn(page, 0, -0.1), ArrowDown: () => turn(page, 0, 0.1),
    '+': () => zoom(page, 0.9, page.c.width / 2, page.c.height / 2), '-': () => zoom(page, 1 / 0.9, page.c.width / 2, page.c.height / 2),
    Home: goHome,
    g: () => page.grid = !page.grid, a: () => page.axes = !page.axes, ' ': () => page.play(),
  };
  keys['='] = keys['+'];
  // A page of its own listens before it is clicked, too.
  (root.dataset.fragment === undefined ? document : canvas).addEventListener('keydown', e => {
    if (e.ctrlKey || e.metaKey || e.altKey || !keys[e.key] || ![canvas, document.body].includes(e.target)) return;
    e.preventDefault();
    keys[e.key]();
    changed();
  });
}
