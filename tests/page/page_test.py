"""Exported pages: the picture against saddle's own, one request, no error, and how many bytes.
Usage: page_test.py PROGRAM"""
import pathlib
import re
import subprocess
import sys
import tempfile

from browser import Browser
from compare import difference, read

WIDTH, HEIGHT = 480, 360
# Levels, three pixels inside of the outline: another driver, and formulas in JavaScript.
MOST_LEVELS = 2
MOST_BYTES = 25_000  # beside the meshes
DRAWN = "document.querySelector('.saddle').dataset.drawn > 0"
BRICKS = str(pathlib.Path(__file__).resolve().parents[2] / "examples" / "bricks.png")
SURFACES = {
    "torus": ["torus"],
    "boy": ["boy"],
    "sine": ["z=sin(3*x)*cos(2*y)", "--view", "1,-2,2"],
    "disc": ["z=x*y", "x=-1:1", "y=-sqrt(1-x^2):sqrt(1-x^2)"],
    "pole": ["z=1/(x^2+y^2)", "--clip", "auto"],
    "colored": ["torus", "--color", "z", "--shading", "pixel"],
    "orthographic": ["torus", "--ortho", "--view", "1,2,3"],
    "blinn": ["torus", "--specular", "blinn"],
    "vertex": ["torus", "--shading", "vertex"],
    "see-through": ["sphere", "--opacity", "0.5"],
    "textured": ["torus", "--texture", BRICKS, "--texture-repeat", "6x2"],
    "pixels": ["z=x*y", "--texture", BRICKS, "--texture-filter", "nearest", "--texture-wrap",
               "mirror", "--texture-repeat", "3x2", "--shading", "vertex"],
    "special": ["z=0.1*(erf(3*x)+gamma(2+x)+lgamma(2+y)+sinc(x))+0.1*besselj0(3*y)+0*diff(gamma(x+3),x)"],
    "sum": ["z=0.5*sum(sin(n*x)/n, n=1:5)", "x=-2:2", "y=-2:2", "--view", "1,-2,2"],
    "checker": ["sphere", "--texture", "checker"],
}

program = sys.argv[1]
failures = []


def expect(condition, what):
    if not condition:
        failures.append(what)
        print("FAILED:", what, flush=True)


def saddle(*words):
    subprocess.run([program, *words, "-q"], check=True)


def full_size(browser, width=WIDTH, height=HEIGHT):
    """The picture alone, in the size of saddle's."""
    browser.value(f"""(s => {{ s.position = 'fixed'; s.left = s.top = '0'; s.zIndex = '9';
        s.width = '{width}px'; s.height = '{height}px'; }})(
        document.querySelector('.saddle-view').style)""")
    browser.settle()
    return browser.picture((0, 0, width, height))


def check_pictures(browser, folder):
    for name, words in SURFACES.items():
        page, picture = folder / f"{name}.html", folder / f"{name}.png"
        size = ["--size", f"{WIDTH}x{HEIGHT}", "--grid", "off"]
        saddle(*words, *size, "-o", str(page), "-o", str(picture))
        browser.open(page.as_uri())
        browser.wait_for(DRAWN)
        shown = full_size(browser)
        (folder / f"{name}-page.png").write_bytes(shown)
        expect(browser.requests == [page.as_uri()], f"{name}: one request, not {browser.requests}")
        expect(not browser.errors, f"{name}: no error, not {browser.errors}")
        background = (0, 0, 0)
        pictures = [read(png)[:, :int(0.8 * WIDTH)] for png in (shown, picture)]  # without bars
        most, mean, share = difference(*pictures, background)
        print(f"{name}: largest difference {most}, mean {mean:.2f} over {share:.0%}", flush=True)
        expect(most <= MOST_LEVELS, f"{name}: {most} levels from saddle's picture")
        text = re.sub("data:image/png;base64,[^&]*", "", page.read_text())  # a texture's
        meshes = re.search(r'saddle-meshes">([^<]*)<', text)[1]
        kilobytes = (len(text) - len(meshes)) / 1000
        print(f"  {kilobytes:.1f} kB and {len(meshes) / 1000:.1f} kB of meshes", flush=True)
        if name != "special":  # whose functions JavaScript lacks
            expect(len(text) - len(meshes) <= MOST_BYTES, f"{name}: {kilobytes} kB")


def check_flat_texture(browser, folder):
    """Without WebGL2: bricks are red and mortar grey."""
    page = folder / "flat.html"
    saddle("z=0*x", "--texture", BRICKS, "--grid", "off", "--view", "0,0,1", "--samples", "64x64",
           "--shading", "unlit", "-o", str(page))
    browser.open(page.as_uri())
    browser.wait_for(DRAWN)
    shown = read(full_size(browser))
    red = (shown[:, :, 0] > shown[:, :, 1] + 60).mean()
    grey = ((abs(shown[:, :, 0] - shown[:, :, 1]) < 30) & (shown[:, :, 0] > 100)).mean()
    expect(red > 0.2 and grey > 0.03, f"a texture without WebGL2: {red:.2f} red, {grey:.2f} grey")
    expect(not browser.errors, f"flat: no error, not {browser.errors}")


with tempfile.TemporaryDirectory() as name:
    path = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else name)
    chromium = Browser()
    try:
        chromium.size(WIDTH, HEIGHT + 200)
        check_pictures(chromium, path)
    finally:
        chromium.close()
    chromium = Browser("--disable-3d-apis")
    try:
        chromium.size(WIDTH, HEIGHT + 200)
        check_flat_texture(chromium, path)
    finally:
        chromium.close()
sys.exit(1 if failures else 0)
