"""What GLSL leaves undefined, case by case, for tests/style/stability.py: a scene in which one light or
one surface asks for it, and the colour that the middle of the picture must have, from the lighting
equation of docs/LIGHTING.md. A first light is on in all of them, so that a NaN of the other would be
seen: it would blacken the pixel."""
import pathlib
import struct
import subprocess
import tempfile
import zlib

import tree

SIZE = 21  # pixels each way: one is in the middle
LEVELS = 1.5  # of 255: rounding to 8 bits, and floats

DIFFUSE, SPECULAR = 0.4, 0.2  # of the material
FIRST = 0.5  # the first light's colour, and the other's

BASE = """background = "black"
[[light]]
direction = [0, 0, 1]
color = [0.5, 0.5, 0.5]
[camera]
view = [0, 0, 1]
up = [0, 1, 0]
target = [0, 0, 0]
distance = 4
ortho = true
"""
PLANE = """[[surface]]
x = "u"
y = "v"
z = "0"
grid = "off"
front = { diffuse = [0.4, 0.4, 0.4], specular = [0.2, 0.2, 0.2] }
"""
CONE = """[[surface]]
x = "v*cos(u)"
y = "v*sin(u)"
z = "-v"
u = [0, "2*pi"]
v = [0, 1]
grid = "off"
front = { diffuse = [0.4, 0.4, 0.4], specular = "black" }
back = { diffuse = [0.4, 0.4, 0.4], specular = "black" }
"""


def other(lines):
    """A second light of the world."""
    return f'[[light]]\nframe = "world"\ncolor = [0.5, 0.5, 0.5]\n{lines}\n'


FULL = FIRST * (DIFFUSE + SPECULAR)  # of a light above the middle

# Each: what is undefined, its case, the scene beside BASE, how bright the middle is.
CASES = [
    ("`pow(x, 0)` at 0", "a shininess of 0", PLANE.replace("front = {", "front = { shininess = 0,"), FULL),
    ("`pow(0, 0)`", "a cone of 90 degrees without an exponent, whose rim is the point",
     PLANE + other("position = [0, 0, 1]\nspot = { direction = [1, 0, 0], cutoff = 90 }"), FULL),
    ("`pow(x, y)` for x < 0", "a cone of 180 degrees with an exponent, seen from behind",
     PLANE + other("position = [0, 0, 1]\nspot = { direction = [0, 0, 1], cutoff = 180, exponent = 3 }"),
     FULL),
    ("`normalize` of a zero vector", "a light at the point that it lights",
     PLANE + other("position = [0, 0, 0]"), FULL),
    ("`normalize` of a zero vector", "the half vector where the light is opposite the eye",
     'specular = "blinn"\n' + PLANE + other("direction = [0, 0, -1]"), FULL),
    ("`normalize` of a zero vector", "a normal of length 0: a cone's tip", CONE,
     FIRST * DIFFUSE / 2**0.5),
    ("`smoothstep(a, b, x)` for a = b", "a smooth edge with the inner angle at the cutoff",
     PLANE + other('position = [0, 0, 2]\n'
                   'spot = { cutoff = 30, inner = 30, falloff = "smooth" }'), 2 * FULL),
    ("division by 0", "an attenuation without a constant, at distance 0",
     PLANE + other("position = [0, 0, 0]\nattenuation = [0, 1, 1]"), FULL),
    ("`inverse` of a singular matrix", "a node of scale 0 around another surface",
     PLANE + PLANE.replace('z = "0"', 'z = "1"') + 'in = "flat"\n'
     '[[node]]\nname = "flat"\ntransform = [{ scale = 0 }]\n', FULL),
    ("`pow(0, y)` for y = 0", "an exponent of 0 in the middle of a cone",
     PLANE + other("position = [0, 0, 2]\nspot = { cutoff = 45, exponent = 0 }"), 2 * FULL),
]


def pixels(path):
    """The rows of an 8-bit RGB or RGBA PNG. Source: PNG specification, 9.2 filter types."""
    data = path.read_bytes()
    at, packed, head = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            head = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    width, height, _, color = head
    step = 4 if color == 6 else 3
    raw, rows, above = zlib.decompress(packed), [], bytes(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        row = bytearray(raw[start + 1:start + 1 + width * step])
        for i, value in enumerate(row):
            left = row[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            up = above[i]
            near = min((left, up, corner), key=lambda p: abs(left + up - corner - p))
            row[i] = value + (0, left, up, (left + up) // 2, near)[raw[start]] & 255
        rows.append([tuple(row[k:k + 3]) for k in range(0, len(row), step)])
        above = row
    return rows


def middle(scene):
    """The red of the picture's middle, and what saddle said."""
    keys = [line for line in scene.splitlines() if line.startswith("specular = \"")][:1]
    rest = scene.replace(keys[0] + "\n", "", 1) if keys else scene
    text = "\n".join(keys) + "\n" + BASE + rest
    with tempfile.TemporaryDirectory() as folder:
        file, picture = pathlib.Path(folder, "a.toml"), pathlib.Path(folder, "a.png")
        file.write_text(text, encoding="utf-8")
        done = subprocess.run([tree.program(), file, "-s", f"{SIZE}x{SIZE}", "--antialias", "1", "-q",
                               "-o", picture], capture_output=True, text=True)
        if done.returncode != 0:
            return None, done.stderr
        return pixels(picture)[SIZE // 2][SIZE // 2][0], ""


def complaints():
    """The page's section about them is what comes out."""
    rows = ["| GLSL leaves undefined | where it happens | the pixel |\n| --- | --- | --- |\n"]
    for undefined, where, scene, brightness in CASES:
        red, said = middle(scene)
        if red is None or abs(red - 255 * brightness) > LEVELS:
            yield f"{undefined}, {where}: {red} in place of {255 * brightness:.1f} {said}"
            continue
        rows.append(f"| {undefined} | {where} | {red}, as the equation has it: {255 * brightness:.1f} |\n")
    if len(rows) == len(CASES) + 1:
        yield from tree.check_page("docs/STABILITY.md", "pictures of single pixels", "".join(rows) + "\n")
