// Vectors are arrays of three numbers; matrices are arrays of their columns, four numbers each.
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const plus = (a, b, s = 1) => a.map((x, k) => x + s * b[k]);
const times = (a, s) => a.map(x => s * x);
const length = a => Math.hypot(...a);
const unit = a => times(a, 1 / (length(a) || 1));
const columns = (x, y, z, w) => [...x, 0, ...y, 0, ...z, 0, ...w, 1];
const product = (a, b) => b.map((_, i) => {
  let sum = 0;
  for (let k = 0; k < 4; ++k) sum += a[4 * k + i % 4] * b[i - i % 4 + k];
  return sum;
});
const column = (m, k) => m.slice(4 * k, 4 * k + 3);
// The transform of a direction, and of a point.
const turned = (m, d) => [0, 1, 2].map(k => m[k] * d[0] + m[4 + k] * d[1] + m[8 + k] * d[2]);
const placed = (m, p) => plus(turned(m, p), column(m, 3));
const diagonal = s => columns([s[0], 0, 0], [0, s[1], 0], [0, 0, s[2]], [0, 0, 0]);
// By Rodrigues' formula: counter-clockwise around the axis.
const rotated = (v, axis, angle) => {
  const a = unit(axis), c = Math.cos(angle);
  return plus(plus(times(v, c), cross(a, v), Math.sin(angle)), a, dot(a, v) * (1 - c));
};
const rotation = (axis, angle) =>
  columns(rotated([1, 0, 0], axis, angle), rotated([0, 1, 0], axis, angle), rotated([0, 0, 1], axis, angle), [0, 0, 0]);
const bounds = () => ({low: [1 / 0, 1 / 0, 1 / 0], high: [-1 / 0, -1 / 0, -1 / 0]});
const extend = (box, p) => {
  for (let k = 0; k < 3; ++k) {
    if (p[k] < box.low[k]) box.low[k] = p[k];
    if (p[k] > box.high[k]) box.high[k] = p[k];
  }
};
const corners = box => [0, 1, 2, 3, 4, 5, 6, 7].map(i => box.low.map((x, k) => i >> k & 1 ? box.high[k] : x));
