// From formulas to meshes: positions and normals of the corners, in doubles.

const own = (ends, k, j) => ends[2 * j] * (1 - k / 65536) + ends[2 * j + 1] * (k / 65536);

// The surface at the parameters that the page has: s.position, s.normal, s.numbers (what colours
// and contours show), s.drawn (the triangles that are there), s.frame. Whether it had to be made anew.
function evaluate(s, p, homes) {
  s.uses ||= homes.map((_, k) => k).filter(k => String(s.make).includes(`p[${k}]`));
  const key = s.uses.map(k => p[k]).join(), home = s.isHome = s.uses.every(k => p[k] == homes[k]);
  if (s.key == key) return false;
  s.key = key;
  const made = s.made = s.make(p);
  s.look = s.lookOf(made.n);
  const count = s.uv[0].length;
  const o = s.outputs = new Float64Array(9 + s.extra);
  s.position = new Float64Array(3 * count);
  s.normal = new Float64Array(3 * count);
  s.numbers = Array.from({length: s.extra - 1}, () => new Float64Array(count));
  s.lost = [];
  for (let i = 0; i < count; ++i) {
    made.at(own(made.ends, s.uv[0][i], 0), own(made.ends, s.uv[1][i], 1), o);
    const x = o[4] * o[8] - o[5] * o[7], y = o[5] * o[6] - o[3] * o[8], z = o[3] * o[7] - o[4] * o[6];
    const scale = (s.flip ? -1 : 1) / Math.hypot(x, y, z), n = [x * scale, y * scale, z * scale];
    if (!isFinite(n[0] + n[1] + n[2])) s.lost.push(i);
    for (let k = 0; k < 3; ++k) {
      s.position[3 * i + k] = o[k];
      s.normal[3 * i + k] = n[k];
    }
    s.numbers.forEach((numbers, k) => numbers[i] = o[10 + k]);
  }
  if (home || s.fixed) {
    const follow = home ? (corner, p, n) => [p, n] : follower(s, s.make(homes));
    s.known.forEach((corner, i) => {
      const [p, n] = follow(corner, s.knownPosition[i], s.knownNormal[i]);
      s.position.set(p, 3 * corner);
      s.normal.set(n, 3 * corner);
    });
    s.lost = [];
  }
  s.drawn = finiteTriangles(s);
  mendNormals(s);
  const box = bounds();
  for (const i of s.drawn.length ? s.drawn : s.chains.flat()) extend(box, s.position.subarray(3 * i, 3 * i + 3));
  const half = times(plus(box.high, box.low, -1), 0.5), size = length(half) || 1;
  s.bounds = box;
  s.frame = {centre: times(plus(box.high, box.low), 0.5), size};
  s.contours = home || !s.levels.length ? s.contourChains.map(chain => chain.map(i => s.contourPlaces[i])) : traceContours(s);
  return s.stale = true;
}

// The triangles whose corners are all there.
function finiteTriangles(s) {
  const there = i => isFinite(s.position[3 * i] + s.position[3 * i + 1] + s.position[3 * i + 2]);
  const t = s.triangles, result = new Uint32Array(t.length);
  let count = 0;
  for (let i = 0; i < t.length; i += 3) {
    if (!there(t[i]) || !there(t[i + 1]) || !there(t[i + 2])) continue;
    for (let k = 0; k < 3; ++k) result[count++] = t[i + k];
  }
  return result.subarray(0, count);
}

// Corners without a normal of their own take the mean of their place's triangles.
function mendNormals(s) {
  if (!s.lost.length) return;
  const place = i => s.position.subarray(3 * i, 3 * i + 3).join();
  const sums = new Map(s.lost.map(i => [place(i), [0, 0, 0]]));
  const at = i => Array.from(s.position.subarray(3 * i, 3 * i + 3));
  for (let i = 0; i < s.drawn.length; i += 3) {
    const [a, b, c] = s.drawn.subarray(i, i + 3);
    for (const corner of [a, b, c]) {
      const sum = sums.get(place(corner));
      if (sum) sums.set(place(corner), plus(sum, cross(plus(at(b), at(a), -1), plus(at(c), at(a), -1))));
    }
  }
  for (const i of s.lost) s.normal.set(unit(sums.get(place(i))), 3 * i);
}

// What a color number is as a share of its mesh's range; -1: undefined.
const share = (s, number) => {
  const [low, high] = s.range;
  return isFinite(number) ? high > low ? (Math.min(Math.max(number, low), high) - low) / (high - low) : 0.5 : -1;
};

// The transforms of the nodes at this moment, and of the world for what is in none.
function frames(nodes) {
  const root = diagonal(scene.root);
  const result = [];
  const frame = i => result[i] ||= nodes[i].steps.reduce((m, [kind, x, y, z, angle]) =>
    product(m, kind == 'r' ? rotation([x, y, z], angle * Math.PI / 180)
      : kind == 's' ? diagonal([x, y, z]) : columns([1, 0, 0], [0, 1, 0], [0, 0, 1], [x, y, z])),
    nodes[i].in < 0 ? root : frame(nodes[i].in));
  nodes.forEach((_, i) => frame(i));
  result[-1] = root;
  return result;
}
