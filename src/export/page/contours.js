// Level lines, where sliders move the surface. Pages without any lack this.

// Level lines on the triangles, where a slider has moved the surface.
function traceContours(s) {
  const pieces = [];
  s.levels.forEach((levels, k) => {
    const numbers = s.numbers[s.colored ? k + 1 : k];
    if (!levels.length) levels = ticks(...numbers.reduce(([a, b], x) => isFinite(x) ? [Math.min(a, x), Math.max(b, x)] : [a, b], [1 / 0, -1 / 0]), 10);
    for (let i = 0; i < s.drawn.length; i += 3) {
      for (const level of levels) {
        const ends = [];
        for (let e = 0; e < 3; ++e) {
          const a = s.drawn[i + e], b = s.drawn[i + (e + 1) % 3];
          const x = numbers[a] - level, y = numbers[b] - level;
          if (x < 0 == y < 0 || !isFinite(x - y)) continue;
          ends.push([0, 1, 2].map(c => s.position[3 * a + c] + (s.position[3 * b + c] - s.position[3 * a + c]) * x / (x - y)));
        }
        if (ends.length == 2) pieces.push(ends);
      }
    }
  });
  return pieces;
}
