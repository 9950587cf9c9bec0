"""Exported pages as a person meets them: the picture against saddle's own, one request, no error,
mouse, keys, sliders, the address. Usage: page_test.py PROGRAM"""
import json
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
    browser.value("new Promise(done => setTimeout(() => requestAnimationFrame(() => "
                  "requestAnimationFrame(done)), 100))")
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
        text = page.read_text()
        meshes = re.search(r'saddle-meshes">([^<]*)<', text)[1]
        kilobytes = (len(text) - len(meshes)) / 1000
        print(f"  {kilobytes:.1f} kB and {len(meshes) / 1000:.1f} kB of meshes", flush=True)
        expect(len(text) - len(meshes) <= MOST_BYTES, f"{name}: {kilobytes} kB")


def differs(browser, act, what):
    before = read(full_size(browser))
    act()
    browser.value("new Promise(done => setTimeout(done, 200))")
    after = read(full_size(browser))
    expect((abs(before - after) > 20).mean() > 0.005, f"{what} changes the picture")


def check_hands(browser, folder):
    page = folder / "hands.html"
    saddle("x=(2+r*cos(v))*cos(u)", "y=(2+r*cos(v))*sin(u)", "z=r*sin(v)+sin(t)", "u=0:tau",
           "v=0:tau", "r=1", "-o", str(page))
    browser.open(page.as_uri())
    browser.wait_for(DRAWN)
    full_size(browser)
    middle = (WIDTH / 2, HEIGHT / 2)
    differs(browser, lambda: browser.drag(middle, (WIDTH / 2 + 60, HEIGHT / 2 + 20)), "a drag")
    differs(browser, lambda: browser.mouse("mouseWheel", *middle, deltaX=0, deltaY=-300), "the wheel")
    browser.value("document.querySelector('.saddle-canvas').focus()")
    differs(browser, lambda: browser.key("ArrowLeft"), "an arrow")
    differs(browser, lambda: browser.key("g"), "g")
    differs(browser, lambda: browser.key("Home"), "Home")
    slide = """(input => { input.value = 0.4; input.dispatchEvent(new Event('input')); })(
        document.querySelector('.saddle-panel input[aria-label="r"]'))"""
    differs(browser, lambda: browser.value(slide), "a slider")
    browser.wait_for("location.hash.includes('r=0.4')")
    browser.mouse("mousePressed", 300, 180, button="left", buttons=1, clickCount=2)
    browser.mouse("mouseReleased", 300, 180, button="left", clickCount=2)
    for number in range(9):  # somewhere along this line is the torus
        x = 40 + 50 * number
        for count in (1, 2):
            browser.mouse("mousePressed", x, 180, button="left", buttons=1, clickCount=count)
            browser.mouse("mouseReleased", x, 180, button="left", clickCount=count)
        if browser.value("document.querySelector('.saddle-place').textContent"):
            break
    told = browser.value("document.querySelector('.saddle-place').textContent")
    expect(re.match(r"surface: u = .*, v = .*; x, y, z = .*; normal", told), f"a place, not {told!r}")
    if told:
        u, v, x, y, z = (float(n.replace("−", "-")) for n in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", told)[:5])
        import math
        expect(abs((2 + 0.4 * math.cos(v)) * math.cos(u) - x) < 1e-4, f"x of {told}")
    # The reduced motion that headless Chromium has by default is off: t plays.
    browser.value("document.querySelector('.saddle-panel button').click()")
    browser.wait_for("+document.querySelector('.saddle-panel input').value != 0", 20)
    expect(not browser.errors, f"hands: no error, not {browser.errors}")
    # The address brings the picture back.
    saddle("torus", "-o", str(folder / "address.html"))
    browser.open((folder / "address.html").as_uri() + "#view=0,0,1")
    browser.wait_for(DRAWN)
    above = read(full_size(browser))
    saddle("torus", "--view", "0,0,1", "-o", str(folder / "above.html"))
    browser.open((folder / "above.html").as_uri() + "?")
    browser.wait_for(DRAWN)
    # Its own distance is fitted to that view: the middle is alike.
    other = read(full_size(browser))
    expect(abs(above[HEIGHT // 2, WIDTH // 2] - other[HEIGHT // 2, WIDTH // 2]).max() < 20, "the address's view")
    browser.open((folder / "above.html").as_uri() + "?flat")
    browser.wait_for(DRAWN)
    flat = read(full_size(browser))
    expect((flat > 60).any(axis=2).mean() > 0.2, "a picture without WebGL2")


def check_hostile(browser, folder):
    title = "</script><script>alert(1)</script> \"ü\" '& <!-- \u2028 日本"
    page = folder / "hostile.html"
    saddle("z=x*y", "--name", "größe", "--title", title, "-o", str(page))
    browser.open(page.as_uri())
    browser.wait_for(DRAWN)
    expect(browser.value("document.title") == title, "the title is the scene's")
    expect(not browser.errors, f"hostile: no error, not {browser.errors}")
    again = subprocess.run([program, str(page), "-o", "-", "--format", "toml"], capture_output=True,
                           check=True).stdout.decode()
    expect(json.dumps(title, ensure_ascii=False)[1:-1] in again or "日本" in again, "the scene again")


with tempfile.TemporaryDirectory() as name:
    path = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else name)
    chromium = Browser()
    try:
        chromium.size(WIDTH, HEIGHT + 200)
        check_pictures(chromium, path)
        check_hands(chromium, path)
        check_hostile(chromium, path)
    finally:
        chromium.close()
sys.exit(1 if failures else 0)
