// The page's state, its sliders, and when it is drawn.

const root = document.currentScript.parentElement;
const find = name => root.querySelector('.' + name);
const element = (name, parent, properties) => parent.appendChild(Object.assign(document.createElement(name), properties));
const canvas = find('saddle-canvas'), over = find('saddle-over'), context = over.getContext('2d'), view = canvas.parentElement;
const home = scene.sliders.map(s => s[1]);
const page = {p: home.slice(), grid: true, axes: scene.axes, items: [], note: null};
const still = matchMedia('(prefers-reduced-motion: reduce)');
let painter, playing = false, last, frame = 0;

// Where a mesh has corners that formulas do not give, other parameters show it approximately.
const approximate = () => !scene.surfaces.some(s => s.known.length && !s.isHome) ? '' : 'approximate: mesh made at ' +
  scene.sliders.flatMap(([name,,,,, hidden], k) => hidden ? [] : [`${name} = ${home[k]}`]).join(', ');
function changed() {
  if (frame) return;
  askedAt = performance.now();
  frame = requestAnimationFrame(draw);
}

// At first, and while something moves and the screen does not keep up, half of the samples each way
// are drawn; all of them follow at rest.
let isSlow = true, late = 0, askedAt, resting;
function rest() {
  frame ||= requestAnimationFrame(now => draw(now, true));
}

function draw(now, fine) {
  cancelAnimationFrame(frame);
  frame = 0;
  if (painter.isLost()) return;
  const wait = performance.now() - askedAt;
  late = !fine && wait > 45 && wait < 1000 ? late + 1 : 0;
  fine ||= !isSlow && late < 2;
  isSlow = late > 1 || (isSlow && root.dataset.drawn > 0);
  clearTimeout(resting);
  if (!fine) resting = setTimeout(rest, 150);
  if (playing) {
    const [, , from, to] = scene.sliders[0], step = (now - (last ?? now)) / 1000;
    page.p[0] += step;
    if (page.p[0] >= to) page.p[0] = from + (page.p[0] - from) % (to - from);
    last = now;
    show();
    changed();
  }
  const isNew = scene.surfaces.map(s => evaluate(s, page.p, home)).includes(true);
  const {camera, nodes, lights} = scene.build(page.p), matrices = frames(nodes);
  page.items = scene.surfaces.flatMap(s => s.in.map(node => ({s, node, matrix: matrices[node]})));
  if (isNew && page.picked) page.tell(reading(page.picked, matrices[page.picked.node]));
  const width = view.clientWidth, height = view.clientHeight, dots = devicePixelRatio;
  const all = bounds(), boxes = page.items.filter(({s}) => s.bounds.low[0] <= s.bounds.high[0]);
  for (const {s, matrix} of boxes) corners(s.bounds).forEach(p => extend(all, placed(matrix, p)));
  if (scene.box) scene.box.forEach(p => extend(all, p));
  const inView = boxes.map(({s, matrix}) => ({box: s.bounds, matrix})).concat({box: all, matrix: diagonal([1, 1, 1])});
  page.refit = () => page.c = fitCamera(camera, width, height, inView, page.p[0]);
  const c = page.refit();
  for (const [target, scale] of [[canvas, dots * painter.scale * (fine ? 1 : painter.coarse)], [over, dots]]) {
    const size = [Math.round(width * scale), Math.round(height * scale)];
    if (target.width != size[0] || target.height != size[1]) [target.width, target.height] = size;
  }
  const line = Math.max(1, Math.min(height, width * 0.75) / 600);
  for (const s of scene.surfaces) s.look.line_width ||= line * (s.dot ? scene.dot : 1);
  const edges = page.axes ? boxEdges(c, all).filter(e => !e.front).map(e => e.ends) : [];
  const shown = page.picked && onScreen(c, page.picked.world);
  painter.draw({c, items: page.items, lights: lightUniforms(lights, matrices, c).map((u, i) => ({...u, directional: lights[i].directional})), edges, line, grid: page.grid});
  context.setTransform(dots, 0, 0, dots, 0, 0);
  drawOverlay(context, {c, items: page.items, box: all, axes: page.axes, line, note: shown});
  find('saddle-note').textContent = approximate();
  remember();
  root.dataset.drawn = +(root.dataset.drawn || 0) + 1;
  root.dataset.fine = fine;
}

// --- sliders ---

const inputs = scene.sliders.map(([name, value, min, max, step, hidden, choices], k) => {
  if (hidden) return [];
  const row = element('label', find('saddle-panel'), {});
  if (k == 0) {
    page.button = element('button', row, {type: 'button', textContent: '\u25b6', onclick: () => page.play()});
    page.button.setAttribute('aria-label', 'play or stop');
  }
  element('span', row, {textContent: name});
  const pair = (choices.length ? ['select'] : ['range', 'number']).map(type => {
    const input = type == 'select' ? element(type, row, {})
      : element('input', row, {type, min, max, step: type == 'range' ? step || (max - min) / 1000 : 'any'});
    choices.forEach((text, i) => element('option', input, {value: i, text}));
    input.value = value;
    input.setAttribute('aria-label', name);
    input.oninput = () => {
      if (input.value === '' || !isFinite(input.value)) return;
      page.p[k] = +input.value == +(+home[k]).toPrecision(12) ? home[k] : +input.value;
      show();
      changed();
    };
    return input;
  });
  return pair;
});
function show() {
  inputs.forEach((pair, k) => pair.forEach(input => {
    if (input != root.getRootNode().activeElement || input.type == 'range') input.value = +page.p[k].toPrecision(6);
  }));
}
page.play = () => {
  if (!inputs[0].length) return;
  playing = !playing;
  last = undefined;
  page.button.textContent = playing ? '\u25a0' : '\u25b6';
  changed();
};
still.addEventListener('change', () => { if (still.matches && playing) page.play(); });

page.tell = found => {
  page.picked = found;
  const number = x => +x.toPrecision(6);
  find('saddle-place').textContent = found
    ? `${found.s.name}: ${found.s.parameters.map((name, k) => `${name} = ${number(found.uv[k])}`).join(', ')}; x, y, z = ${found.position.map(number).join(', ')}; normal ${found.normal.map(number).join(', ')}`
    : '';
};

// --- the address ---

let timer;
function remember() {
  if (root.dataset.fragment !== undefined) return;
  clearTimeout(timer);
  timer = setTimeout(() => {
    const parts = scene.sliders.flatMap(([name], k) => page.p[k] == home[k] || (playing && !k) ? [] : [encodeURIComponent(name) + '=' + page.p[k]]);
    const list = v => v.map(x => +x.toPrecision(6)).join();
    if (eye.view) parts.push('view=' + list(eye.view));
    if (eye.moved) parts.push('target=' + list(eye.target), 'distance=' + +eye.distance.toPrecision(6));
    if (!page.grid) parts.push('grid=off');
    if (page.axes != scene.axes) parts.push('axes=' + (page.axes ? 'on' : 'off'));
    const hash = parts.join('&');
    if (hash != location.hash.slice(1)) {
      // A frame may not.
      try { history.replaceState(null, '', '#' + hash); } catch {}
    }
  }, 300);
}
function recall() {
  if (root.dataset.fragment !== undefined) return;
  page.p = home.slice();
  Object.assign(page, {grid: true, axes: scene.axes});
  goHome();
  for (const part of location.hash.slice(1).split('&')) {
    const [name, text = ''] = part.split('='), numbers = text.split(',').map(Number);
    if (/^(on|off)$/.test(text) && /^(grid|axes)$/.test(name)) page[name] = text == 'on';
    if (!text || !numbers.every(isFinite)) continue;
    const k = scene.sliders.findIndex(s => encodeURIComponent(s[0]) == name);
    if (k >= 0) page.p[k] = numbers[0];
    else if (name == 'view' && numbers.length == 3 && length(numbers)) eye.view = numbers;
    else if (name == 'target' && numbers.length == 3) Object.assign(eye, {target: numbers, moved: true});
    else if (name == 'distance' && numbers[0] > 0) Object.assign(eye, {distance: numbers[0], moved: true});
  }
  show();
}

// --- start ---

unpack(find('saddle-meshes').textContent).then(() => {
  painter = glPainter(canvas) || flatPainter(canvas);
  recall();
  addEventListener('hashchange', () => { recall(); changed(); });
  new ResizeObserver(changed).observe(view);
  listen(canvas, page);
  if (scene.plays && !still.matches && !/(^#|&)t=/.test(location.hash)) page.play();
  changed();
}).catch(error => {
  find('saddle-note').textContent = 'Cannot be drawn here: ' + error.message;
  throw error;
});
