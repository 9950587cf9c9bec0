// Ticks, labels, the title and colour bars: render/overlay/annotations.cpp, in the browser's letters.

// Round numbers from low to high, about so many.
function ticks(low, high, count) {
  if (!(high > low)) return [low];
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find(m => m * power >= raw * 0.999999);
  const first = Math.ceil(low / step - 1e-9), result = [];
  for (let k = first; k * step <= high + 1e-9 * step; ++k) result.push(k * step);
  return result;
}
const written = (x, all) => {
  const step = all.length > 1 ? all[1] - all[0] : Math.abs(x) || 1, most = Math.max(...all.map(Math.abs));
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const text = most >= 1e6 || digits > 6 ? x.toExponential(Math.max(0, Math.round(Math.log10(most / step)))) : x.toFixed(digits);
  return text.replace(/^-(0(\.0*)?)$/, '$1').replace('-', '\u2212');
};

// The edges of the box that are not in front of it.
const isFront = (c, box, axis, high) => {
  const toward = c.ortho ? c.axes[2][axis] : c.target[axis] + c.distance * c.axes[2][axis] - (high ? box.high : box.low)[axis];
  return high ? toward > 0 : toward < 0;
};
function boxEdges(c, box) {
  const edges = [];
  for (let axis = 0; axis < 3; ++axis) {
    for (let i = 0; i < 4; ++i) {
      const sides = [i & 1, i >> 1], others = [(axis + 1) % 3, (axis + 2) % 3];
      const front = others.map((k, j) => isFront(c, box, k, sides[j]));
      const end = high => {
        const p = [];
        p[axis] = (high ? box.high : box.low)[axis];
        others.forEach((k, j) => p[k] = (sides[j] ? box.high : box.low)[k]);
        return p;
      };
      edges.push({axis, ends: [end(0), end(1)], front: front[0] && front[1], outline: front[0] != front[1]});
    }
  }
  return edges;
}

function drawOverlay(context, view) {
  const {c, box, note} = view;
  const em = Math.max(9, Math.round(Math.min(c.height, 0.75 * c.width) / 46));
  const ink = `rgb(${scene.ink.map(x => Math.round(255 * x))})`;
  context.clearRect(0, 0, c.width, c.height);
  context.fillStyle = context.strokeStyle = ink;
  context.lineWidth = view.line;
  context.font = `${em}px "DejaVu Sans", sans-serif`;
  context.textBaseline = 'middle';
  context.textAlign = 'center';
  const text = (s, x, y, out) => {
    const w = context.measureText(s).width / 2;
    context.fillText(s, Math.min(Math.max(x + out[0] * w, w + 2), c.width - w - 2), y + out[1] * em / 2);
  };
  const tick = (p, out) => {
    context.beginPath();
    context.moveTo(p[0], p[1]);
    context.lineTo(p[0] + 0.45 * em * out[0], p[1] + 0.45 * em * out[1]);
    context.stroke();
  };
  if (view.axes && box) drawTicks(c, box, em, context, text, tick);
  let right = c.width;
  scene.scales.forEach(({name, range: [low, high, below, above]}, i) => {
    const all = ticks(low, high, Math.min(8, Math.floor(0.84 * c.height / (2.5 * em))));
    const label = x => (below && x == low ? '\u2264 ' : above && x == high ? '\u2265 ' : '') + written(x, all);
    if (below && all[0] != low) all.unshift(low);
    if (above && all.at(-1) != high) all.push(high);
    const widest = Math.max(...all.map(x => context.measureText(label(x)).width));
    const x = right - widest - (1.2 + 0.45 + 0.35 + 1.1) * em, top = Math.round(0.08 * c.height + em), height = Math.round(0.84 * c.height);
    for (let y = 0; y < height; ++y) {
      context.fillStyle = `rgb(${scene.maps[i].slice(3 * Math.round(255 * (1 - y / height)))})`.split(',').slice(0, 3).join() + ')';
      context.fillRect(x, top + y, 1.1 * em, 1.5);
    }
    context.fillStyle = ink;
    context.strokeRect(x, top, 1.1 * em, height);
    for (const value of all) {
      const y = top + height * (1 - (high > low ? (value - low) / (high - low) : 0.5));
      tick([x + 1.1 * em, y], [1, 0]);
      text(label(value), x + 1.9 * em, y, [1, 0]);
    }
    text(name, x + 0.55 * em, top - 0.75 * em, [0, -1]);
    right = x - 1.2 * em;
  });
  for (const {s, matrix} of view.items) {
    const p = s.label && onScreen(c, placed(matrix, s.dot ? s.position.subarray(0, 3) : s.anchor));
    if (p) text(s.label, p[0] + 0.5 * em, p[1] - 0.5 * em, [1, -1]);
  }
  if (scene.titled) {
    context.font = `${1.25 * em}px "DejaVu Sans", sans-serif`;
    text(scene.title, c.width / 2, 1.4 * em, [0, 0]);
  }
  if (note) {
    context.beginPath();
    context.arc(note[0], note[1], 4, 0, 7);
    context.stroke();
  }
}

function drawTicks(c, box, em, context, text, tick) {
  const middle = onScreen(c, times(plus(box.low, box.high), 0.5));
  const edges = boxEdges(c, box);
  for (let axis = 0; axis < 3; ++axis) {
    let best, rank = -1 / 0;
    for (const edge of edges.filter(e => e.axis == axis && e.outline)) {
      const [p, q] = edge.ends.map(e => onScreen(c, e));
      if (!p || !q || !middle) continue;
      const way = [q[0] - p[0], q[1] - p[1]], long = Math.hypot(...way);
      if (long < 2 * em) continue;
      const at = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
      let out = [way[1] / long, -way[0] / long];
      if (out[0] * (at[0] - middle[0]) + out[1] * (at[1] - middle[1]) < 0) out = [-out[0], -out[1]];
      const r = Math.abs(way[1]) > 2.5 * Math.abs(way[0]) ? -at[0] : at[1];
      if (r > rank) [best, rank] = [{edge, out, long, at}, r];
    }
    if (!best) continue;
    const scale = scene.root[axis];
    const room = Math.abs(best.out[1]) < 0.5 ? 1.6 * em : 4 * em;
    const all = ticks(box.low[axis] / scale, box.high[axis] / scale, Math.max(1, Math.min(8, Math.floor(best.long / room))));
    let widest = 0;
    for (const value of all) {
      const p = best.edge.ends[0].slice();
      p[axis] = value * scale;
      const at = onScreen(c, p), label = written(value, all);
      if (!at) continue;
      tick(at, best.out);
      text(label, at[0] + 0.8 * em * best.out[0], at[1] + 0.8 * em * best.out[1], best.out);
      widest = Math.max(widest, context.measureText(label).width);
    }
    const far = 0.45 * em + 0.9 * em + Math.abs(best.out[0]) * widest + Math.abs(best.out[1]) * em;
    text(scene.labels[axis], best.at[0] + far * best.out[0], best.at[1] + far * best.out[1], best.out);
  }
}
