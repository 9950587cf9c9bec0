// The camera: scene/model/camera.cpp, for a picture whose shape the window decides.

// Its own axes: right, up, and back toward the eye.
function axesOf(view, up) {
  const back = unit(view);
  const upward = [up, [0, 1, 0], [0, 0, 1]].find(u => length(cross(unit(u), back)) > 1e-8);
  const right = unit(cross(upward, back));
  return [right, cross(back, right), back];
}
// Where a point goes that turns around the pivot as the axes do.
const carried = (pivot, point, before, after) =>
  before.reduce((sum, axis, k) => plus(sum, after[k], dot(axis, plus(point, pivot, -1))), pivot);

// Null, and not moved: the scene's own.
const eye = {view: null, target: scene.target, distance: scene.distance};

// `items`: boxes in the world that the near and far plane enclose.
function fitCamera(camera, width, height, items, time) {
  let view = camera.view;
  if (!eye.view && camera.turntable && scene.time) {
    view = rotated(view, camera.up, 2 * Math.PI * (time - scene.time[1]) / (scene.time[2] - scene.time[1]));
  }
  const own = axesOf(view, camera.up), axes = axesOf(eye.view || view, camera.up), back = axes[2];
  const target = eye.moved ? eye.target : carried(scene.centre, camera.target || eye.target, own, axes);
  const distance = eye.moved || !camera.distance ? eye.distance : camera.distance;
  const aspect = width / height;
  // Bars keep their share of the picture, whose shape the window may widen.
  const middle = scene.middle * Math.min(1, scene.width / scene.height / aspect);
  const slope = Math.tan(camera.fov * Math.PI / 360) / camera.zoom * Math.max(1, scene.width / scene.height / aspect);
  let near = 1 / 0, far = -1 / 0, radius = 0;
  for (const {box, matrix} of items) {
    for (const corner of corners(box)) {
      const depth = distance - dot(back, plus(placed(matrix, corner), target, -1));
      near = Math.min(near, depth);
      far = Math.max(far, depth);
    }
    radius = Math.max(radius, far - near);
  }
  near -= 0.01 * radius + 1e-12 * distance;
  far += 0.01 * radius + 1e-12 * distance;
  const half = camera.ortho ? slope * distance : slope;
  if (!camera.ortho) near = Math.max(near, Math.min(1e-3 * far, 0.1 * distance));
  const n = near, f = far, m = Array(16).fill(0);
  m[0] = 1 / (half * aspect);
  m[5] = 1 / half;
  m[10] = (camera.ortho ? -2 : -(f + n)) / (f - n);
  m[11] = camera.ortho ? 0 : -1;
  m[14] = camera.ortho ? -(f + n) / (f - n) : -2 * f * (n / (f - n));
  m[15] = camera.ortho ? 1 : 0;
  m[8] = middle * m[11];
  m[12] = middle * m[15];
  return {axes, target, distance, middle, half: slope * distance, toClip: m, ortho: camera.ortho, width, height, up: camera.up};
}

const inEye = (c, p) => {
  const way = plus(p, c.target, -1);
  return plus(c.axes.map(a => dot(a, way)), [0, 0, c.distance], -1);
};
// Pixels of the page from the picture's upper left, and the depth; nothing behind the eye.
const onScreen = (c, p) => {
  const q = inEye(c, p), m = c.toClip, w = m[11] * q[2] + m[15];
  return w > 0 ? [(1 + c.middle + m[0] * q[0] / w) / 2 * c.width, (1 - m[5] * q[1] / w) / 2 * c.height, -q[2]] : null;
};
// How far right of the target and above it a pixel is, in the plane through the target.
const beside = (c, x, y) => [(2 * x / c.width - 1 - c.middle) * c.half * c.width / c.height, (1 - 2 * y / c.height) * c.half];
// A line of sight through a pixel: a point and a direction.
const sight = (c, x, y) => {
  const [across, up] = beside(c, x, y);
  const point = plus(plus(c.target, c.axes[0], across), c.axes[1], up);
  const origin = plus(c.ortho ? point : c.target, c.axes[2], c.distance);
  return [origin, plus(point, origin, c.ortho ? 0 : -1).map((x, k) => c.ortho ? -c.axes[2][k] : x)];
};

// From the mesh's coordinates to the eye's, and to the screen, in units of the scene.
function place(s, matrix, c) {
  const {centre, size} = s.frame;
  const axes = [0, 1, 2].map(k => {
    const world = times(column(matrix, k), size / scene.unit);
    return c.axes.map(a => dot(a, world));
  });
  const toEye = columns(...axes, times(inEye(c, placed(matrix, centre)), 1 / scene.unit));
  const clip = c.toClip.map((x, i) => i < 12 ? x * scene.unit : x);
  const whole = clip[11] ? times(clip, 1 / scene.unit) : clip;
  const m3 = [0, 1, 2].map(k => column(toEye, k));
  let cofactors = [cross(m3[1], m3[2]), cross(m3[2], m3[0]), cross(m3[0], m3[1])];
  const det = dot(m3[0], cofactors[0]);
  const most = Math.max(...cofactors.flat().map(Math.abs)) * (det < 0 ? -1 : 1);
  cofactors = cofactors.map(v => times(v, 1 / (most || 1)));
  return {toEye, toClip: product(whole, toEye), normals: cofactors.flat(), mirrored: det < 0};
}
