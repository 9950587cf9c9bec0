"""Exported pages as a person reads them: mouse, fingers, keys, sliders, points, the address, print, a
fragment, screens without WebGL2. Usage: reader_test.py PROGRAM"""
import math
import pathlib
import re
import subprocess
import sys
import tempfile

from browser import Browser
from compare import numpy, read

WIDTH, HEIGHT = 480, 360
MIDDLE = (WIDTH / 2, HEIGHT / 2)
DRAWN = "document.querySelector('.saddle').dataset.drawn > 0"
RING = ["x=(2+r*cos(v))*cos(u)", "y=(2+r*cos(v))*sin(u)", "z=r*sin(v)+a*sin(t)", "u=0:tau", "v=0:tau",
        "r=1", "a=1"]
# Pixels differ that are so many levels apart.
MUCH = 20
AXE = pathlib.Path(__file__).resolve().parents[2] / "build/axe/node_modules/axe-core/axe.min.js"
NUMBER = re.compile(r"[-\u2212]?\d+\.?\d*(?:e-?\d+)?")


class Reader:
    def __init__(self, program, folder):
        self.program, self.folder, self.failures = program, folder, []
        self.browser = Browser()
        self.browser.size(WIDTH, HEIGHT + 200)

    def expect(self, condition, what):
        if not condition:
            self.failures.append(what)
            print("FAILED:", what, flush=True)

    def page(self, name, *words):
        path = self.folder / f"{name}.html"
        subprocess.run([self.program, *words, "-q", "-o", str(path)], check=True)
        return path

    def open(self, path, after="", fits=True):
        self.browser.open(path.as_uri() + after)
        self.browser.wait_for(DRAWN)
        if fits:
            self.fit()

    def fit(self):
        """The picture alone, in a size of its own."""
        self.browser.value(f"""(s => {{ s.position = 'fixed'; s.left = s.top = '0'; s.zIndex = '9';
            s.width = '{WIDTH}px'; s.height = '{HEIGHT}px'; }})(
            document.querySelector('.saddle-view').style)""")
        self.settle()

    def settle(self):
        self.browser.settle()

    def picture(self):
        self.settle()
        return read(self.browser.picture((0, 0, WIDTH, HEIGHT)))

    def text(self, name):
        return self.browser.value(f"document.querySelector('.saddle-{name}').textContent")

    def slide(self, name, value, kind="input"):
        self.browser.value(f"""(input => {{ input.value = {value}; input.dispatchEvent(new Event('input'));
            }})(document.querySelector('.saddle-panel {kind}[aria-label="{name}"]'))""")

    def differs(self, act, what, least=0.005):
        before = self.picture()
        act()
        share = (abs(before - self.picture()) > MUCH).any(axis=2).mean()
        self.expect(share > least, f"{what} changes the picture, not {share:.2%} of it")

    def is_same(self, before, what, most=0.002):
        share = (abs(before - self.picture()) > MUCH).any(axis=2).mean()
        self.expect(share <= most, f"{what}: {share:.2%} of the picture differs")

    def no_errors(self, what):
        self.expect(not self.browser.errors, f"{what}: no error, not {self.browser.errors}")

    # --- hands

    def hands(self):
        self.open(self.page("hands", *RING))
        browser = self.browser
        self.differs(lambda: browser.key("g"), "g before a click")
        browser.key("g")
        self.differs(lambda: browser.drag(MIDDLE, (WIDTH / 2 + 60, HEIGHT / 2 + 20)), "a drag")
        self.differs(lambda: browser.drag(MIDDLE, (WIDTH / 2 + 60, HEIGHT / 2), button="right"),
                     "the right button")
        self.differs(lambda: browser.mouse("mouseWheel", *MIDDLE, deltaX=0, deltaY=-300), "the wheel")
        for key in ("ArrowLeft", "ArrowUp", "+", "-", "g", "a", "Home"):
            self.differs(lambda pressed=key: browser.key(pressed), key, 0.001)
        # What is drawn stays in the middle while it turns.
        self.open(self.page("middle", *RING, "--axes"))
        for view in ("0,0,1", "0,-1,0", "3,1,-2"):
            self.browser.value(f"location.hash = 'view={view}&axes=off'")
            rows, columns = numpy.nonzero((self.picture() > 0).any(axis=2))
            middle = numpy.array([(rows.min() + rows.max()) / 2, (columns.min() + columns.max()) / 2])
            off = abs(middle - [HEIGHT / 2, WIDTH / 2]).max()
            self.expect(off < 0.16 * HEIGHT, f"from {view} the middle is {off:.0f} pixels off")
        self.no_errors("hands")

    def fingers(self):
        self.open(self.page("fingers", *RING))
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)
        x, y = MIDDLE
        self.differs(lambda: self.touch([[(x, y)], [(x + 30, y + 10)], [(x + 60, y + 20)]]), "a finger")
        size = (self.picture() > 0).any(axis=2).mean()
        self.touch([[(x - 40, y), (x + 40, y)], [(x - 60, y), (x + 60, y)], [(x - 80, y), (x + 80, y)]])
        larger = (self.picture() > 0).any(axis=2).mean()
        self.expect(larger > 1.2 * size, f"two fingers that part enlarge {size:.2f} to {larger:.2f}")
        self.differs(lambda: self.touch([[(x - 40, y), (x + 40, y)], [(x - 10, y + 60), (x + 70, y + 60)]]),
                     "two fingers that go together")
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=False)
        self.no_errors("fingers")

    def touch(self, moments):
        for kind, points in zip(["touchStart"] + ["touchMove"] * (len(moments) - 1), moments):
            self.browser.call("Input.dispatchTouchEvent", type=kind,
                              touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])
        self.browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    # --- sliders

    def sliders(self):
        scene = self.folder / "sliders.toml"
        scene.write_text("""[params]
r = { value = 0.8, min = 0.5, max = 1.5, step = 0.25 }
shape = { value = 1, choices = ["flat", "wavy"] }
[[surface]]
z = "0.3*r*shape*sin(3*u)"
""")
        self.open(self.page("sliders", str(scene)))
        asked = "JSON.stringify([...document.querySelectorAll('.saddle-panel input[type=range]')]" \
                ".map(i => [i.min, i.max, i.step]))"
        self.expect(self.browser.value(asked) == '[["0.5","1.5","0.25"]]',
                    f"the scene's range and step, not {self.browser.value(asked)}")
        choice = "document.querySelector('.saddle-panel select').selectedOptions[0].text"
        self.expect(self.browser.value(choice) == "wavy", "the scene's choice")
        self.differs(lambda: self.slide("shape", 0, "select"), "a choice")
        self.expect(self.text("note") == "", f"nothing is approximate, not {self.text('note')!r}")
        self.no_errors("sliders")
        # A surface that does not depend on the slider is neither made anew nor approximate.
        self.open(self.page("apart", "z=sqrt(1-x^2-y^2)", "+", "z=2+a*x*y", "a=1"))
        self.differs(lambda: self.slide("a", -1), "the slider of a")
        self.expect(self.text("note") == "", f"the dome stays, not {self.text('note')!r}")
        self.open(self.page("dome", "z=sqrt(a-x^2-y^2)", "a=1"))
        self.slide("a", 0.5)
        self.settle()
        self.expect(self.text("note") == "approximate: mesh made at a = 1", f"not {self.text('note')!r}")

    def tubes(self):
        words = ["curve", "x=2*cos(s)", "y=2*sin(s)", "z=a*sin(2*s)", "s=0:tau", "--radius", "0.3",
                 "--view", "1,-2,2", "--distance", "12", "--target", "0,0,0", "--size", f"{WIDTH}x{HEIGHT}"]
        self.open(self.page("tube", *words, "a=0"))
        self.slide("a", 1)
        moved = self.picture()
        self.open(self.page("other", *words, "a=1"))
        self.is_same(moved, "a tube that follows its curve", 0.02)

    def time(self):
        page = self.page("time", *RING)
        self.open(page)
        self.browser.value("document.querySelector('.saddle-panel button').click()")
        self.browser.wait_for("+document.querySelector('.saddle-panel input').value > 0", 20)
        self.browser.value("document.querySelector('.saddle-panel button').click()")
        self.settle()
        before = self.browser.value("document.querySelector('.saddle-panel input').value")
        self.settle()
        self.expect(before == self.browser.value("document.querySelector('.saddle-panel input').value"),
                    "t stops")
        # A film plays by itself, unless the reader prefers less motion.
        film = self.page("film", *RING, "t=0:4")
        for prefers, plays in (("no-preference", True), ("reduce", False)):
            self.browser.call("Emulation.setEmulatedMedia",
                              features=[{"name": "prefers-reduced-motion", "value": prefers}])
            self.open(film, fits=False)
            moves = "+document.querySelector('.saddle-panel input').value > 0"
            if plays:
                self.browser.wait_for(moves, 20)
            else:
                self.settle()
                self.expect(not self.browser.value(moves), "a film rests if less motion is preferred")
        self.browser.call("Emulation.setEmulatedMedia", features=[])

    # --- points

    def points(self):
        for name, words, formula in (
                ("ring", RING, lambda u, v, r: ((2 + r * math.cos(v)) * math.cos(u),
                                                (2 + r * math.cos(v)) * math.sin(u), r * math.sin(v))),
                ("names", ["xyz=spherical(r,theta,phi)", "theta=0:pi", "phi=0:tau", "r=1"],
                 lambda a, b, r: (r * math.sin(a) * math.cos(b), r * math.sin(a) * math.sin(b),
                                  r * math.cos(a))),
                ("bound", ["z=r*x*y", "x=-1:1", "y=-sqrt(1-x^2):sqrt(1-x^2)", "r=1"],
                 lambda x, y, r: (x, y, r * x * y))):
            self.open(self.page(f"points-{name}", *words))
            told = self.pick()
            self.expect(told and re.match(r"\S+: \S+ = .*, \S+ = .*; x, y, z = .*; normal .*", told),
                        f"{name}: a place, not {told!r}")
            self.check_place(name, told, formula, 1)
            self.slide("r", 0.5)  # the reading follows
            self.settle()
            later = self.text("place")
            self.expect(later != told, f"{name}: the reading follows r")
            self.check_place(name, later, formula, 0.5)
            self.no_errors(name)

    def pick(self):
        for x in range(30, WIDTH, 40):
            for count in (1, 2):
                self.browser.mouse("mousePressed", x, HEIGHT / 2, button="left", buttons=1, clickCount=count)
                self.browser.mouse("mouseReleased", x, HEIGHT / 2, button="left", clickCount=count)
            if self.text("place"):
                return self.text("place")
        return None

    def check_place(self, name, told, formula, r):
        numbers = [float(text.replace("\u2212", "-")) for text in NUMBER.findall(told.partition(":")[2])]
        u, v, *place = numbers[:5]
        normal = numpy.array(numbers[5:8])
        far = max(abs(a - b) for a, b in zip(formula(u, v, r), place))
        self.expect(far < 2e-5, f"{name}, r = {r}: {told} is {far} off")
        step = 1e-4
        tangents = [numpy.subtract(formula(u + a, v + b, r), formula(u - a, v - b, r))
                    for a, b in ((step, 0), (0, step))]
        exact = numpy.cross(*tangents)
        exact /= numpy.linalg.norm(exact)
        self.expect(abs(exact - normal).max() < 1e-4, f"{name}, r = {r}: the normal of {told} is {exact}")

    # --- the address

    def address(self):
        page = self.page("address", *RING, "--axes")
        self.open(page)
        self.slide("r", 0.4)
        self.slide("t", 0.5)
        self.browser.drag(MIDDLE, (WIDTH / 2 + 60, HEIGHT / 2 + 20))
        self.browser.mouse("mouseWheel", *MIDDLE, deltaX=0, deltaY=-200)
        self.browser.key("g")
        self.browser.key("a")
        self.browser.value("document.activeElement.blur()")  # and no ring around the picture
        sent = self.picture()
        self.browser.value("new Promise(done => setTimeout(done, 500))")
        link = self.browser.value("location.hash")
        for part in ("r=0.4", "t=0.5", "view=", "grid=off", "axes=off"):
            self.expect(part in link, f"{part} in {link}")
        self.open(page, link)
        self.is_same(sent, f"what {link} shows")
        self.open(page)
        fresh = self.picture()
        self.browser.value(f"location.hash = '{link}'")
        self.is_same(sent, "an address that is typed")
        self.browser.value("location.hash = ''")
        self.is_same(fresh, "the empty address")
        for wrong in ("#r=&view=0,0,0&t=x&distance=-1&=&a=1e999", "#" + "%" * 50):
            self.open(page, wrong)
            self.is_same(fresh, f"what {wrong} shows")
            self.no_errors(wrong)

    # --- other screens

    def without_webgl(self):
        browser, self.browser = self.browser, Browser("--disable-3d-apis")
        self.browser.size(WIDTH, HEIGHT + 200)
        try:
            # Coarse, as each triangle of each frame is drawn by JavaScript.
            page = self.page("flat", *RING, "--samples", "32x16", "--size", f"{WIDTH}x{HEIGHT}", "-o",
                             str(self.folder / "flat.png"))
            self.open(page)
            drawn, expected = self.picture(), read(self.folder / "flat.png")
            self.expect((abs(drawn - expected).max(axis=2) > 60).mean() < 0.04, "the same picture without WebGL2")
            self.differs(lambda: self.browser.drag(MIDDLE, (WIDTH / 2 + 60, HEIGHT / 2)), "a drag without WebGL2")
            self.differs(lambda: self.slide("r", 0.5), "a slider without WebGL2")
            self.no_errors("without WebGL2")
        finally:
            self.browser.close()
            self.browser = browser

    def lost_context(self):
        self.open(self.page("lost", *RING, "--color", "z"))
        before = self.picture()
        self.browser.value("""window.lose = document.querySelector('.saddle-canvas').getContext('webgl2')
            .getExtension('WEBGL_lose_context'), lose.loseContext()""")
        self.settle()
        self.slide("r", 0.5)
        self.slide("r", 1)
        self.browser.value("lose.restoreContext()")
        self.settle()
        self.is_same(before, "a lost context that is back")
        self.no_errors("a lost context")

    def print(self):
        self.open(self.page("print", *RING), fits=False)
        import base64
        pdf = self.folder / "printed.pdf"
        pdf.write_bytes(base64.b64decode(self.browser.call("Page.printToPDF", printBackground=True)["data"]))
        subprocess.run(["pdftoppm", "-r", "48", "-png", "-singlefile", str(pdf), str(pdf.with_suffix(""))],
                       check=True)
        sheet = read(pdf.with_suffix(".png"))
        yellow = (sheet[:, :, 0] > 150) & (sheet[:, :, 2] < 140) & (sheet[:, :, 1] > 120)
        rows, columns = numpy.nonzero(yellow)
        self.expect(len(rows) > 500, f"a still in print, not {len(rows)} pixels")
        # As wide as on the screen for its height.
        shown = read(self.browser.picture())
        there = numpy.nonzero((shown[:, :, 0] > 150) & (shown[:, :, 2] < 140) & (shown[:, :, 1] > 120))
        shapes = [numpy.ptp(c) / numpy.ptp(r) for r, c in ((rows, columns), there)]
        self.expect(abs(shapes[0] / shapes[1] - 1) < 0.05, f"print has the screen's shape: {shapes}")

    def light_and_dark(self):
        page = self.page("scheme", *RING)
        inks = []
        for scheme in ("light", "dark"):
            self.browser.call("Emulation.setEmulatedMedia",
                              features=[{"name": "prefers-color-scheme", "value": scheme}])
            self.open(page, fits=False)
            inks.append(self.browser.value("""(s => [s.color, s.backgroundColor].map(c =>
                c.match(/\\d+/g).slice(0, 3).reduce((sum, x) => sum + +x, 0)))(
                getComputedStyle(document.querySelector('.saddle')))"""))
        self.browser.call("Emulation.setEmulatedMedia", features=[])
        (ink, paper), (bright, dark) = inks
        self.expect(paper - ink > 400 and bright - dark > 400, f"both can be read: {inks}")

    def accessible(self):
        if not AXE.exists():
            print("  without axe-core, which ./dev test gets by npm: not checked", flush=True)
            return
        page = self.page("accessible", *RING, "--color", "z", "--axes", "t=0:3")
        part = self.page("accessible-part", *RING, "--fragment")
        host = self.folder / "accessible-host.html"
        host.write_text('<!DOCTYPE html><html lang="en"><title>host</title><main><h1>Host</h1>' + part.read_text() +
                        "</main></html>")
        for scheme in ("light", "dark"):
            self.browser.call("Emulation.setEmulatedMedia",
                              features=[{"name": "prefers-color-scheme", "value": scheme},
                                        {"name": "prefers-reduced-motion", "value": "reduce"}])
            for path in (page, host):
                self.open(path, fits=False)
                self.pick()
                self.browser.value(AXE.read_text() + ";0")
                passed, found = self.browser.value("axe.run().then(result => [result.passes.length, "
                                                   "result.violations.map(v => [v.id, v.nodes.map(n => n.html)])])")
                self.expect(passed > 10 and not found, f"{path.name} in {scheme}: {found}, {passed} passed")
        self.browser.call("Emulation.setEmulatedMedia", features=[])

    # --- inside of other pages

    def fragment(self):
        parts = [self.page(f"part-{name}", *words, "--fragment").read_text()
                 for name, words in (("a", RING), ("b", ["z=x*y*b", "b=1"]))]
        self.expect("\n\n" not in parts[0], "no empty line ends a block of HTML in Markdown")
        host = self.folder / "host.html"
        host.write_text("<!DOCTYPE html><title>host</title><h1>Two</h1><script>function draw() { return 7 }"
                        "</script>" + parts[0] + "<p>and</p>" + parts[1])
        names = "Object.keys(window).length"
        self.browser.open(host.as_uri())
        self.browser.wait_for("[...document.querySelectorAll('.saddle')].every(e => e.dataset.drawn > 0)")
        self.expect(self.browser.value("draw()") == 7, "a fragment leaves the page's functions alone")
        empty = self.folder / "empty.html"
        empty.write_text("<!DOCTYPE html><title>host</title><script>function draw() { return 7 }</script>")
        count = self.browser.value(names)
        self.browser.open(empty.as_uri())
        self.expect(self.browser.value(names) == count, "a fragment adds no name to the page")
        self.browser.open(host.as_uri())
        self.browser.wait_for("[...document.querySelectorAll('.saddle')].every(e => e.dataset.drawn > 0)")
        self.expect(self.browser.value("location.hash") == "", "a fragment leaves the address alone")
        self.expect(self.browser.value("document.querySelectorAll('.saddle-panel')[1].textContent") == "b",
                    "each fragment has its own sliders")
        self.no_errors("fragments")

    def frame(self):
        page = self.page("framed", *RING)
        host = self.folder / "frame.html"
        host.write_text(f'<!DOCTYPE html><title>host</title><iframe src="{page.name}" width="400" '
                        'height="300" title="ring"></iframe>')
        self.browser.open(host.as_uri())
        self.settle()
        self.browser.value("new Promise(done => setTimeout(done, 1500))")
        shown = read(self.browser.picture())
        yellow = ((shown[:, :, 0] > 150) & (shown[:, :, 2] < 140) & (shown[:, :, 1] > 120)).mean()
        self.expect(yellow > 0.02, f"a page in a frame is drawn: {yellow:.2%}")
        self.expect(len(self.browser.requests) <= 3, f"and asks for nothing else: {self.browser.requests}")
        self.no_errors("a frame")

    # --- input that is hostile

    def hostile(self):
        title = "</script><script>alert(1)</script> \"ü\" '& <!-- \u2028 日本 </template>"
        scene = self.folder / "hostile.toml"
        scene.write_text("""title = '''%s'''
[params]
"γ" = 1
"constructor" = 1
[functions]
"f(s)" = "s < 0 ? 1 : 2 > 1 && s <= 3"
[[surface]]
name = "</template></script><img src=x onerror=alert(2)> `${1}`"
label = '<b>"\\x'
z = '''
γ*u*v
+ f(u)*0*constructor

'''
""" % title)
        page = self.page("hostile", str(scene))
        self.open(page, fits=False)
        self.expect(self.browser.value("document.title") == title, "the title is the scene's")
        self.expect(self.browser.value("document.images.length") == 0, "names are no markup")
        self.expect("γ" in self.browser.value("document.querySelector('.saddle-panel').textContent"),
                    "letters of all languages")
        self.no_errors("hostile")
        again = [subprocess.run([self.program, str(path), "-o", "-", "--format", "toml"], capture_output=True,
                                check=True).stdout for path in (page, scene)]
        self.expect(again[0] == again[1], "the page holds its scene")
        part = self.page("hostile-part", str(scene), "--fragment").read_text()
        self.expect("\n\n" not in part, "a fragment has no empty line, whatever its formulas have")


def main(program, folder):
    reader = Reader(program, folder)
    try:
        for check in (reader.hands, reader.fingers, reader.sliders, reader.tubes, reader.time, reader.points,
                      reader.address, reader.without_webgl, reader.lost_context, reader.print,
                      reader.light_and_dark, reader.accessible, reader.fragment, reader.frame, reader.hostile):
            if len(sys.argv) > 3 and check.__name__ not in sys.argv[3:]:
                continue
            print(check.__name__, flush=True)
            check()
    finally:
        reader.browser.close()
    return 1 if reader.failures else 0


with tempfile.TemporaryDirectory() as name:
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else name)))
