#!/usr/bin/python3 -B
"""A torus on a web page: saddle's, plotly's and three.js's, in one browser, in turns. Usage: pages.py
SADDLE NODE_MODULES

All pages are files on the disk, of 800x600 pixels. The others' meshes are grids of about as many
vertices as saddle's mesh, within half a pixel, has. First frame: from the begin of navigation until
the first picture can be read back. Slider: a new value of r until the new picture can be read back;
plotly and three.js get points, and three.js normals, that JavaScript computes, as saddle's page does.
Medians of three rounds."""
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "page"))
from browser import Browser

ROUNDS = 3
STEPS = 6  # of the slider in a round

POINTS = """
const N = GRID;
const grid = (r, take) => {
  for (let i = 0; i < N; ++i) {
    for (let j = 0; j < N; ++j) {
      const u = 2 * Math.PI * i / (N - 1), v = 2 * Math.PI * j / (N - 1), c = Math.cos(v), s = Math.sin(v);
      take(i, j, [(2 + r * c) * Math.cos(u), (2 + r * c) * Math.sin(u), r * s], [c * Math.cos(u), c * Math.sin(u), s]);
    }
  }
};
"""

PLOTLY = """<!DOCTYPE html><meta charset="utf-8"><title>plotly</title><body style="margin:0"><div id="plot"></div>
<script src="LIBRARY"></script><script>POINTS
const arrays = r => {
  const all = [0, 1, 2].map(() => Array.from({length: N}, () => Array(N)));
  grid(r, (i, j, p) => p.forEach((x, k) => all[k][i][j] = x));
  return all;
};
const [x, y, z] = arrays(1);
Plotly.newPlot('plot', [{type: 'surface', x, y, z, showscale: false}],
  {width: 800, height: 600, scene: {aspectmode: 'data'}}).then(() => window.isDrawn = true);
window.slide = r => {
  const [x, y, z] = arrays(r);
  return Plotly.restyle('plot', {x: [x], y: [y], z: [z]});
};
window.picture = () => document.querySelector('.gl-container canvas') || document.querySelector('#plot canvas');
</script>"""

THREE = """<!DOCTYPE html><meta charset="utf-8"><title>three.js</title><body style="margin:0">
<script type="module">
import * as THREE from 'LIBRARY';
POINTS
const renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
renderer.setSize(800, 600);
document.body.append(renderer.domElement);
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(30, 4 / 3, 1, 50);
camera.up.set(0, 0, 1);
camera.position.set(5, -8, 6);
camera.lookAt(0, 0, 0);
const light = new THREE.DirectionalLight(0xffffff, 2);
camera.add(light);
scene.add(camera, new THREE.AmbientLight(0xffffff, 0.5));
const geometry = new THREE.BufferGeometry();
const place = new Float32Array(3 * N * N), normal = new Float32Array(3 * N * N), index = [];
geometry.setAttribute('position', new THREE.BufferAttribute(place, 3));
geometry.setAttribute('normal', new THREE.BufferAttribute(normal, 3));
for (let i = 0; i + 1 < N; ++i) {
  for (let j = 0; j + 1 < N; ++j) {
    const a = i * N + j;
    index.push(a, a + N, a + 1, a + 1, a + N, a + N + 1);
  }
}
geometry.setIndex(index);
const material = new THREE.MeshPhongMaterial({color: 0xffff80, side: THREE.DoubleSide});
scene.add(new THREE.Mesh(geometry, material));
window.slide = r => {
  grid(r, (i, j, p, n) => {
    place.set(p, 3 * (i * N + j));
    normal.set(n, 3 * (i * N + j));
  });
  geometry.attributes.position.needsUpdate = geometry.attributes.normal.needsUpdate = true;
  renderer.render(scene, camera);
};
slide(1);
window.picture = () => renderer.domElement;
window.isDrawn = true;
</script>"""

# What the browser runs in each page before its own scripts.
WATCH = """
window.readBack = canvas => {
  const gl = canvas.getContext('webgl2') || canvas.getContext('webgl'), pixel = new Uint8Array(4);
  gl.readPixels(gl.drawingBufferWidth >> 1, gl.drawingBufferHeight >> 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
};
window.firstFrame = new Promise(done => {
  const look = () => {
    if (!window.isDrawn && !(document.querySelector('.saddle')?.dataset.drawn > 0)) return requestAnimationFrame(look);
    readBack(window.picture ? picture() : document.querySelector('.saddle-canvas'));
    done(performance.now());
  };
  requestAnimationFrame(look);
});
"""

SADDLE_SLIDE = """
window.slide = r => {
  const root = document.querySelector('.saddle'), input = root.querySelector('input[aria-label="r"]'), before = root.dataset.drawn;
  input.value = r;
  input.dispatchEvent(new Event('input'));
  return new Promise(done => {
    const look = () => root.dataset.drawn != before ? done() : requestAnimationFrame(look);
    look();
  });
};
"""

SLIDES = """(async () => {
  const canvas = window.picture ? picture() : document.querySelector('.saddle-canvas'), begin = performance.now();
  for (let k = 1; k <= STEPS; ++k) {
    await slide(0.3 + k / STEPS);
    await new Promise(requestAnimationFrame);
    readBack(canvas);
  }
  return (performance.now() - begin) / STEPS;
})()""".replace("STEPS", str(STEPS))


def pages(saddle, modules, folder):
    """The page of each program, and how many bytes it loads."""
    torus, report = folder / "torus.html", folder / "report.json"
    subprocess.run([saddle, "x=(2+r*cos(v))*cos(u)", "y=(2+r*cos(v))*sin(u)", "z=r*sin(v)", "r=1", "u=0:tau",
                    "v=0:tau", "--grid", "off", "-q", "-o", str(torus), "--report", str(report)], check=True)
    vertices = json.loads(report.read_text(encoding="utf-8"))["surfaces"][0]["vertices"]
    points = POINTS.replace("GRID", str(round(vertices ** 0.5)))
    print(f"{vertices} vertices\n")
    plotly = modules / "plotly.js-gl3d-dist-min/plotly-gl3d.min.js"
    three = modules / "three/build/three.module.min.js"
    core = modules / "three/build/three.core.min.js"
    result = {"saddle": (torus, torus.stat().st_size)}
    for name, text, library, size in (("plotly.js, gl3d", PLOTLY, plotly, plotly.stat().st_size),
                                      ("three.js", THREE, three, three.stat().st_size + core.stat().st_size)):
        page = folder / re.sub(r"\W.*", ".html", name)
        page.write_text(text.replace("LIBRARY", library.as_uri()).replace("POINTS", points), encoding="utf-8")
        result[name] = (page, size + page.stat().st_size)
    return result


def measure(browser, page):
    """Milliseconds to the first frame, and for each value of the slider."""
    browser.open(page.as_uri())
    browser.wait_for("window.firstFrame !== undefined")
    first = browser.value("firstFrame")
    if not browser.value("window.slide !== undefined"):
        browser.value(SADDLE_SLIDE + "0")
    slide = browser.value(SLIDES)
    if browser.errors:
        sys.exit(f"{page.name}: {browser.errors}")
    return first, slide


def main(saddle, modules):
    with tempfile.TemporaryDirectory() as name:
        every = pages(saddle, pathlib.Path(modules).resolve(), pathlib.Path(name))
        browser = Browser("--allow-file-access-from-files")
        try:
            browser.socket.settimeout(600)
            browser.size(800, 700)
            browser.call("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
            rounds = [{key: measure(browser, page) for key, (page, _) in every.items()} for _ in range(ROUNDS)]
            shown = sys.argv[3] if len(sys.argv) > 3 else None
            if shown:
                for key, (page, _) in every.items():
                    measure(browser, page)
                    (pathlib.Path(shown) / f"{page.stem}.png").write_bytes(browser.picture())
        finally:
            browser.close()
    medians = {key: [statistics.median(turn[key][k] for turn in rounds) for k in range(2)] for key in every}
    mine = medians["saddle"]
    print("| page | kB | first frame, ms | times saddle's | a slider's step, ms | times saddle's |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    for key, (_, size) in every.items():
        first, slide = medians[key]
        print(f"| {key} | {size / 1000:.0f} | {first:.0f} | {first / mine[0]:.2f} | {slide:.1f} | "
              f"{slide / mine[1]:.2f} |")


main(*sys.argv[1:3])
