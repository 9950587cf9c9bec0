// The same picture without WebGL2: triangles from back to front, each in one colour.
function flatPainter(canvas) {
  const context = canvas.getContext('2d');
  const css = color => `rgb(${color.map(x => Math.round(255 * Math.min(Math.max(x, 0), 1)))})`;
  function draw({c, items, lights, edges, grid, line}) {
    const per = canvas.height / c.height;
    const list = [];
    const lines = (chains, matrix, color, width) => {
      for (const chain of chains) {
        chain.forEach((p, i) => {
          const ends = [chain[Math.max(i - 1, 0)], p].map(q => onScreen(c, placed(matrix, q)));
          if ((i || chain.length == 1) && ends[0] && ends[1]) list.push([Math.min(ends[0][2], ends[1][2]) - 0.03 * c.half, ends, css(color), width]);
        });
      }
    };
    for (const {s, matrix} of items) {
      const at = i => s.position.subarray(3 * i, 3 * i + 3);
      for (let i = 0; i < s.drawn.length; i += 3) {
        const world = [0, 1, 2].map(k => placed(matrix, at(s.drawn[i + k])));
        const ends = world.map(p => onScreen(c, p));
        if (!ends.every(Boolean)) continue;
        const eyes = world.map(p => inEye(c, p));
        const n = unit(cross(plus(eyes[1], eyes[0], -1), plus(eyes[2], eyes[0], -1)));
        const front = dot(n, eyes[0]) < 0 || (c.ortho && n[2] > 0);
        let base = s.look[(front || !s.look.back_diffuse ? 'front' : 'back') + '_diffuse'];
        if (s.colored) {
          const place = Math.min(Math.max(s.onScale[0] * share(s, s.numbers[0][s.drawn[i]]) + s.onScale[1], 0), 1);
          base = Array.from(scene.maps[s.scale].slice(3 * Math.round(place * 255)).slice(0, 3), x => x / 255);
        }
        if (s.texture) base = texelOf(s, s.drawn.subarray(i, i + 3), base);
        let lit = s.unlit ? [1, 1, 1] : [0, 0, 0];
        for (const light of s.unlit ? [] : lights) {
          const way = light.directional ? light.light_position : unit(plus(light.light_position, times(eyes[0], 1 / scene.unit), -1));
          lit = plus(lit, light.light_color, Math.max(0, dot(n, way) * (front ? 1 : -1)));
        }
        const color = css(base.map((x, k) => x * lit[k])).replace(')', `,${s.look.opacity})`).replace('rgb', 'rgba');
        list.push([(ends[0][2] + ends[1][2] + ends[2][2]) / 3, ends, color, 0]);
      }
      if (grid || s.stroke) lines(s.chains.map(chain => chain.map(at)), matrix, s.look.line_color, s.look.line_width);
      lines(s.contours, matrix, s.look.levels, s.look.line_width * s.look.wider);
    }
    lines(edges, diagonal([1, 1, 1]), scene.ink.map(x => 0.35 + 0.3 * x), line);
    context.setTransform(per, 0, 0, per, 0, 0);
    context.clearRect(0, 0, c.width, c.height);
    context.fillStyle = css(scene.background.slice(0, 3)).replace(')', `,${scene.background[3]})`).replace('rgb', 'rgba');
    context.fillRect(0, 0, c.width, c.height);
    context.lineCap = 'round';
    for (const [, ends, color, width] of list.sort((a, b) => b[0] - a[0])) {
      context.beginPath();
      ends.forEach(p => context.lineTo(p[0], p[1]));
      context.closePath();
      context.strokeStyle = context.fillStyle = color;
      context.lineWidth = width || 0.7;  // of triangles: no seams between them
      if (!width) context.fill();
      context.stroke();
    }
  }
  return {draw, scale: 1, coarse: 1, isLost: () => false};
}
