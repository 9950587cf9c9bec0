#!/usr/bin/python3 -B
"""What saddle does where graphers fail, case by case: runs each, holds it to what must come out,
and holds docs/STABILITY.md to what did. With --write, makes the page. What a plain grid does is
measured here, too: 64 x 64 cells over the domain, corners joined by triangles, cells with a corner
that is no number dropped, normals from central differences. The program is $SADDLE_PROGRAM, or
build/release/saddle."""
import json
import math
import os
import pathlib
import struct
import subprocess
import tempfile

import glsl_cases
import tree

N = 64  # cells of the plain grid each way
GIB = 2**30
# Sanitizers, whose presets set their options, take memory of their own.
IS_SANITIZED = not {"ASAN_OPTIONS", "TSAN_OPTIONS"}.isdisjoint(os.environ)


# --- the plain grid ------------------------------------------------------------------------------

def lines(first, last, n=N):
    return [first + (last - first) * k / n for k in range(n + 1)]


def value(f, *arguments):
    """f as IEEE arithmetic has it: infinite or NaN where Python raises."""
    try:
        return f(*arguments)
    except OverflowError:
        return math.inf
    except (ZeroDivisionError, ValueError):
        return math.nan


def cells(f, u, v):
    """The four corner heights of each cell of a grid."""
    heights = [[value(f, a, b) for b in v] for a in u]
    for i in range(len(u) - 1):
        for j in range(len(v) - 1):
            yield (heights[i][j], heights[i + 1][j], heights[i + 1][j + 1], heights[i][j + 1])


def dropped(f, u, v):
    return sum(not all(map(math.isfinite, c)) for c in cells(f, u, v))


def walls(f, u, v, height):
    """Cells that rise by more than `height`."""
    kept = [c for c in cells(f, u, v) if all(map(math.isfinite, c))]
    return sum(max(c) - min(c) > height for c in kept)


def chord_error(f, u, steps=16):
    """The largest distance in z of f(u) from the chords between its samples."""
    worst = 0
    for a, b in zip(u, u[1:]):
        fa, fb = value(f, a), value(f, b)
        for k in range(1, steps):
            s = k / steps
            off = abs(value(f, a + (b - a) * s) - (fa * (1 - s) + fb * s))
            worst = max(worst, off if math.isfinite(off) else 0)
    return worst


def as_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def torus(u, v, size=1.0, offset=0.0):
    ring = 2 + math.cos(v)
    return [offset + size * ring * math.cos(u), offset + size * ring * math.sin(u),
            offset + size * math.sin(v)]


def cross(a, b, c):
    """Twice the vector area of a triangle."""
    p, q = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def count(things):
    """How many, to three digits: where work ends at a bound, the others change with every mesh."""
    return int(float(f"{len(things):.3g}"))


def number(x):
    return f"{x:.3g}"


def percent(share):
    return f"{100 * share:.3g} %"


# --- saddle --------------------------------------------------------------------------------------

class Run:
    """One run with a mesh and a report."""

    def __init__(self, arguments):
        with tempfile.TemporaryDirectory() as folder:
            mesh, report = pathlib.Path(folder, "a.ply"), pathlib.Path(folder, "a.json")
            done = subprocess.run([tree.program(), *arguments, "-o", mesh, "--report", report],
                                  capture_output=True, text=True)
            self.status, self.said = done.returncode, done.stderr
            self.report = json.loads(report.read_text()) if report.exists() else None
            self.surface = self.report["surfaces"][0] if self.report else {}
            self.corners, self.triangles = read_ply(mesh) if mesh.exists() else ([], [])

    def across(self, side):
        """Triangles with corners on both sides: side(u, v) is a number for each."""
        names = [side(c[-2], c[-1]) for c in self.corners]
        return sum(len({names[k] for k in t} - {None}) > 1 for t in self.triangles)

    def area(self):
        corners = [c[:3] for c in self.corners]
        return sum(math.hypot(*cross(corners[a], corners[b], corners[c])) / 2
                   for a, b, c in self.triangles)

    def volume(self):
        """Inside of a closed surface, by the divergence theorem."""
        at = [c[:3] for c in self.corners]
        return sum(sum(x * y for x, y in zip(at[a], cross(at[a], at[b], at[c]))) / 6
                   for a, b, c in self.triangles)

    def open_edges(self):
        """Edges, by their places, of an odd number of triangles."""
        odd = set()
        for t in self.triangles:
            for a, b in zip(t, t[1:] + t[:1]):
                odd ^= {frozenset((self.corners[a][:3], self.corners[b][:3]))}
        return len(odd)

    def extent(self, axis):
        low, high = self.surface["bounds"]
        return high[axis] - low[axis]

    def within(self):
        tolerance = self.surface["tolerance"]
        return tolerance is not None and self.surface["max_error"] <= tolerance

    def fulfils(self, condition):
        """A run that failed has no report to hold to anything."""
        try:
            return condition(self)
        except KeyError:
            return False


def read_ply(path):
    head, _, body = path.read_bytes().partition(b"end_header\n")
    kinds, counts = "", []
    for line in head.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            counts.append(int(words[2]))
        if words[0] == "property" and words[1] in ("float", "double"):
            kinds += words[1][0]
    corner = struct.Struct("<" + kinds)
    face = struct.Struct("<B3i")
    middle = counts[0] * corner.size
    return (list(corner.iter_unpack(body[:middle])),
            [t[1:] for t in face.iter_unpack(body[middle:middle + counts[1] * face.size])])


# --- the cases -----------------------------------------------------------------------------------
# Each: a title, the arguments, what the plain grid does (measured), what must be true of the run,
# and what to say about it.

U1 = lines(-1, 1)
TAU = 2 * math.pi


def near(x, expected, share=0.01):
    return abs(x - expected) <= share * abs(expected)


def nothing(run, word):
    return run.status == 3 and word in run.said


def noise(u, v):
    return math.sin(u * 12.9898 + v * 78.233) * 43758 % 1


def steps(u, v):
    return math.floor(1 / u) + math.floor(1 / v)


WEIERSTRASS = "+".join(f"cos({3**k}*t)/{2**k}" for k in range(1, 8))


def weierstrass(t):
    return sum(math.cos(3**k * t) / 2**k for k in range(1, 8))


def says_how_far_off(r):
    """The mesh is off, and a warning tells by how much."""
    return r.surface["max_error"] > r.surface["tolerance"] and "off by at least" in r.said


def ends_in_time(run):
    """Says why work has ended, and where the mesh is off."""
    ends = ("stopped refinement", "oscillates faster than its tolerance shows")
    return (any(end in run.said for end in ends) and "as at u = " in run.said
            and not run.within() and 0 < len(run.triangles) <= 1000000)


CASES = [
    ("a slope without end", ["z=sin(1/u)"],
     lambda: f"off by {number(chord_error(lambda u: math.sin(1 / u), U1))}, without a word",
     lambda r: "the mesh is off by at least" in r.said and len(r.triangles) <= 100000,
     lambda r: f"{count(r.triangles)} triangles: leaves waves alone that are finer than its tolerance, "
               "and says how far off that is"),
    ("poles", ["z=tan(u)", "u=-5:5"],
     lambda: str(sum(min(c) < -1 and max(c) > 1 for c in cells(
         lambda u, v: math.tan(u), lines(-5, 5), U1))) + " cells are walls from below to above",
     lambda r: r.surface["poles_count"] > 0 and "goes to infinity" in r.said
     and r.across(lambda u, v: math.floor(u / math.pi + 0.5)) == 0,
     lambda r: "five pieces, no triangle across a pole; clipped to "
               f"{number(r.extent(2))} high, and said so"),
    ("poles that cross", ["z=1/(u*v)", "u=-2:2", "v=-2:2"],
     lambda: str(dropped(lambda u, v: 1 / (u * v), lines(-2, 2), lines(-2, 2)))
             + f" cells dropped, heights up to {number(1 / (4 / N)**2)}",
     lambda r: r.surface["poles_count"] > 0
     and r.across(lambda u, v: None if u * v == 0 else 2 * (u > 0) + (v > 0)) == 0,
     lambda r: "four pieces, no triangle across an axis; clipped, and said so"),
    ("a pole that comes back", ["z=1/(u-0.3)^2"],
     lambda: f"no cell dropped, heights up to {number(max(1 / (u - 0.3)**2 for u in U1))}",
     lambda r: r.surface["poles_count"] > 0 and "goes to infinity" in r.said
     and r.across(lambda u, v: u > 0.3) == 0,
     lambda r: f"two pieces, none across the pole; clipped to {number(r.extent(2))} high"),
    ("a pole of a logarithm", ["z=ln(abs(u-0.3))"],
     lambda: f"no cell dropped, depths down to {number(min(math.log(abs(u - 0.3)) for u in U1))}",
     lambda r: r.surface["poles_count"] > 0 and "goes to infinity" in r.said
     and r.across(lambda u, v: u > 0.3) == 0,
     lambda r: f"two pieces, none across the pole; clipped to {number(r.extent(2))} high"),
    ("a pole that is none along the axes", ["z=u*v/(u^2+v^2)^2"],
     lambda: str(dropped(lambda u, v: u * v / (u * u + v * v)**2, U1, U1))
             + " cells dropped, heights up to " + number(max(
                 value(lambda u, v: u * v / (u * u + v * v)**2, u, v) for u in U1 for v in U1
                 if u or v)),
     lambda r: r.surface["poles_count"] > 0 and "goes to infinity" in r.said
     and r.extent(2) < 10,
     lambda r: f"recognised, and clipped to {number(r.extent(2))} high"),
    ("a limit for each way", ["z=2*u*v/(u^2+v^2)"],
     lambda: str(dropped(lambda u, v: 2 * u * v / (u * u + v * v), U1, U1))
             + " cells dropped, nothing said",
     lambda r: "has no limit at u = 0, v = 0" in r.said and r.within()
     and r.surface["undefined_fraction"] == 0
     and min(math.hypot(c[-2], c[-1]) for c in r.corners) < 2e-3,
     lambda r: "named, and left out; within tolerance around it"),
    ("a hole that has a limit", ["z=sin(sqrt(u^2+v^2))/sqrt(u^2+v^2)", "u=-20:20", "v=-20:20"],
     lambda: str(dropped(lambda u, v: math.sin(math.hypot(u, v)) / math.hypot(u, v),
                         lines(-20, 20), lines(-20, 20))) + " cells dropped around the top",
     lambda r: r.surface["undefined_fraction"] == 0 and near(r.surface["bounds"][1][2], 1, 1e-9),
     lambda r: f"no hole; the top is at z = {number(r.surface['bounds'][1][2])}"),
    ("a jump", ["z=sign(u)"],
     lambda: f"{walls(lambda u, v: (u > 0) - (u < 0), U1, U1, 0.5)} cells are a ramp",
     lambda r: r.surface["jumps_count"] > 0 and "jumps" in r.said
     and not any(-1 < c[2] < 1 and c[2] != 0 for c in r.corners)
     and r.across(lambda u, v: (u > 0) - (u < 0) or None) == 0,
     lambda r: "two sheets with nothing between them, and said so"),
    ("jumps that look alike", ["x=floor(v)*0.01", "y=u", "z=2*(v-floor(v))-1", "v=0:30",
                               "--tolerance", "0.05", "--grid", "off"],
     lambda: str(2 * N * walls(lambda u, v: math.floor(v), [0, 1], lines(0, 30), 0.5))
             + f" of {2 * N * N} triangles go from one sheet to another",
     lambda r: r.surface["jumps_count"] > 0 and "jumps" in r.said
     and near(r.area(), 120, 1e-6),
     lambda r: "thirty sheets, none joined, none missing: area " + number(r.area())),
    ("a branch cut", ["z=atan2(v,u)"],
     lambda: f"{walls(lambda u, v: math.atan2(v, u), U1, U1, 5)} cells are walls, 2 pi high",
     lambda r: r.surface["jumps_count"] > 0
     and max(abs(r.corners[a][2] - r.corners[b][2]) for t in r.triangles for a in t for b in t) < 5,
     lambda r: "cut along v = 0, u < 0; no wall"),
    ("a rim", ["z=sqrt(1-u^2-v^2)", "u=-1.2:1.2", "v=-1.2:1.2"],
     lambda: percent(1 - sum(all(map(math.isfinite, c)) for c in cells(
         lambda u, v: math.sqrt(1 - u * u - v * v), lines(-1.2, 1.2), lines(-1.2, 1.2)))
                     * (2.4 / N)**2 / math.pi) + " of the disc is missing along a jagged edge",
     lambda r: near(r.surface["undefined_fraction"], 1 - math.pi / 5.76, 0.01) and r.within()
     and min(c[2] for c in r.corners) < 1e-6,
     lambda r: "ends on the rim, its lowest corners below z = 1e-6; within tolerance"),
    ("a sliver", ["z=sqrt(u-0.999)"],
     lambda: str(N * N - dropped(lambda u, v: math.sqrt(u - 0.999), U1, U1)) + " cells are left",
     lambda r: near(r.surface["undefined_fraction"], 0.9995, 1e-6) and r.within()
     and near(min(c[0] for c in r.corners), 0.999, 1e-7),
     lambda r: "all of it, from u = 0.999 to 1"),
    ("a sliver beside a pole", ["z=ln(u-0.9999)"],
     lambda: str(N * N - dropped(lambda u, v: math.log(u - 0.9999), U1, U1)) + " cells are left",
     lambda r: r.surface["poles_count"] > 0 and near(r.surface["undefined_fraction"], 0.99995, 1e-4)
     and near(r.surface["bounds"][1][2], math.log(1e-4), 1e-3),
     lambda r: f"all of it, clipped to {number(r.extent(2))} high"),
    ("an island", ["z=sqrt(1e-6-(u-0.3)^2-(v+0.2)^2)"],
     lambda: str(N * N - dropped(
         lambda u, v: math.sqrt(1e-6 - (u - .3)**2 - (v + .2)**2), U1, U1)) + " cells are left",
     lambda r: near(4 - 4 * r.surface["undefined_fraction"], math.pi * 1e-6)
     and near(r.extent(0), 2e-3) and r.within(),
     lambda r: f"found by interval bounds: {number(r.extent(0))} across, within tolerance"),
    ("nothing at all", ["z=sqrt(-1-u^2)"],
     lambda: "an empty picture", lambda r: nothing(r, "undefined everywhere"),
     lambda r: "status 3: the surface is undefined everywhere"),
    ("a curve", ["x=cos(u)", "y=sin(u)", "z=u/4", "u=0:2*pi", "v=0:1"],
     lambda: f"{2 * N * N} triangles without area, normals 0/0",
     lambda r: nothing(r, "is a curve"), lambda r: "status 3: the surface is a curve"),
    ("a point", ["x=1", "y=2", "z=3", "u=0:1", "v=0:1"],
     lambda: f"{2 * N * N} triangles without area, an empty bounding box",
     lambda r: nothing(r, "single point"), lambda r: "status 3: a single point, (1, 2, 3)"),
    ("a line", ["x=u+v", "y=u+v", "z=u+v"],
     lambda: f"{2 * N * N} triangles without area, normals 0/0",
     lambda r: nothing(r, "straight line"), lambda r: "status 3: the surface is a straight line"),
    ("a size of 1e8", [f"{k}=1e8*({f})" for k, f in (
        ("x", "(2+cos(v))*cos(u)"), ("y", "(2+cos(v))*sin(u)"), ("z", "sin(v)"))] +
     ["u=0:2*pi", "v=0:2*pi"],
     lambda: "seams gape by " + number(max(abs(a - b) for a, b in zip(
         torus(0, 0, 1e8), torus(TAU, 0, 1e8)))) + ": more than a fixed 1e-9",
     lambda r: r.within() and r.surface["closed_u"] == r.surface["closed_v"] == "join"
     and r.surface["certified"],
     lambda r: "as a torus of size 1: closed, within tolerance, certified"),
    ("a size of 1e-8", [f"{k}=1e-8*({f})" for k, f in (
        ("x", "(2+cos(v))*cos(u)"), ("y", "(2+cos(v))*sin(u)"), ("z", "sin(v)"))] +
     ["u=0:2*pi", "v=0:2*pi"],
     lambda: "all normals are shorter than a fixed 1e-12 and count as none: the longest is "
             + number(1e-8**2 * max(2 + math.cos(v) for v in lines(0, TAU))),
     lambda r: r.within() and r.surface["closed_u"] == r.surface["closed_v"] == "join"
     and r.surface["singular_points_count"] == 0 and r.surface["certified"],
     lambda r: "as a torus of size 1: closed, within tolerance, certified"),
    ("far from the origin", [f"{k}=1e7+({f})" for k, f in (
        ("x", "(2+cos(v))*cos(u)"), ("y", "(2+cos(v))*sin(u)"), ("z", "sin(v)"))] +
     ["u=0:2*pi", "v=0:2*pi"],
     lambda: "floats move corners by up to " + number(max(
         abs(as_float(x) - x) for u in lines(0, TAU) for v in lines(0, TAU)
         for x in torus(u, v, 1, 1e7))) + " of a size of 6",
     lambda r: r.within() and near(r.extent(0), 6, 1e-6),
     lambda r: "doubles in the file, floats around the middle in the picture"),
    ("a height of 1e43", ["z=exp(u*u)", "u=-10:10"],
     lambda: str(sum(value(lambda u: math.exp(u * u), u) > 1e-2 * math.exp(100)
                     for u in lines(-10, 10)))
             + f" of {N + 1} columns are above a hundredth of the box",
     lambda r: "out of proportion" in r.said and r.within() and 8 < r.extent(2) < 20
     and near(r.surface["bounds"][1][0]**2, math.log(r.surface["bounds"][1][2]), 0.01),
     lambda r: f"shows the part that is in proportion, {number(r.extent(2))} high, and says so"),
    ("a height beyond doubles", ["z=exp(u*u)", "u=-30:30"],
     lambda: str(sum(not math.isfinite(value(lambda u: math.exp(u * u), u))
                     for u in lines(-30, 30))) + f" of {N + 1} columns are infinite",
     lambda r: "out of proportion" in r.said and r.within() and 8 < r.extent(2) < 20
     and near(r.surface["undefined_fraction"], 1 - math.sqrt(math.log(2**1024 - 2**970)) / 30, 0.01)
     and "larger than doubles can hold" in r.said,
     lambda r: f"the same, and says that {percent(r.surface['undefined_fraction'])} of it is "
     "larger than doubles can hold"),
    ("a height without proportion", ["z=1e20*u*v"],
     lambda: f"a box of 2 x 2 x {number(2e20)}",
     lambda r: nothing(r, "as long along z"),
     lambda r: "status 3: it is a line in double precision; scale z down"),
    ("a frequency of the grid's own", ["z=sin(60*u)", "u=0:2*pi", "v=0:2*pi"],
     lambda: "with 60 cells a flat sheet: heights up to " + number(max(
         abs(math.sin(60 * u)) for u in lines(0, TAU, 60))),
     lambda r: r.within() and near(r.extent(2), 2, 1e-3),
     lambda r: "sixty waves, within tolerance"),
    ("a spike", ["z=exp(-1e4*((u-0.123)^2+(v+0.321)^2))"],
     lambda: "the highest sample is " + number(max(
         math.exp(-1e4 * ((u - .123)**2 + (v + .321)**2)) for u in U1 for v in U1)),
     lambda r: r.within() and near(r.extent(2), 1, 2e-3),
     lambda r: f"found: {number(r.extent(2))} high, within tolerance"),
    ("a spike a hundred times thinner", ["z=exp(-1e6*((u-0.123)^2+(v+0.321)^2))"],
     lambda: "the highest sample is " + number(max(
         math.exp(-1e6 * ((u - .123)**2 + (v + .321)**2)) for u in U1 for v in U1)),
     lambda r: r.within() and near(r.extent(2), 1, 2e-3),
     lambda r: f"found by interval bounds: {number(r.extent(2))} high, within tolerance"),
    ("a crease", ["z=abs(u)-abs(v)"],
     lambda: "normals on it are off by " + number(math.degrees(
         math.atan(1) - math.atan((abs(2 / N) - abs(-2 / N)) / (4 / N)))) + " degrees",
     lambda r: r.within() and r.surface["max_error"] < 1e-12
     and r.surface["max_normal_error"] < 1e-6,
     lambda r: "mesh edges on it, a normal for each side"),
    ("a steep slope", ["z=tanh(1e5*u)"],
     lambda: f"{walls(lambda u, v: math.tanh(1e5 * u), lines(-1, 1.01), U1, 1)} cells are a ramp "
             f"{number(2.01 / N)} wide",
     lambda r: r.surface["jumps_count"] == 0 and r.within(),
     lambda r: "not cut: it is steep, not a jump; within tolerance"),
    ("a steeper one", ["z=atan(1e6*u)"],
     lambda: f"{walls(lambda u, v: math.atan(1e6 * u), lines(-1, 1.01), U1, 2)} cells are a ramp "
             f"{number(2.01 / N)} wide",
     lambda r: r.surface["jumps_count"] == 0 and r.within() and near(r.extent(2), math.pi, 1e-5),
     lambda r: "not cut either; within tolerance"),
    ("tangents that stand upright", ["z=sqrt(abs(u))"],
     lambda: f"off by {number(chord_error(lambda u: math.sqrt(abs(u)), lines(-1, 1.01)))}",
     lambda r: r.surface["jumps_count"] == 0 and r.within()
     and any(abs(c[0]) < 1e-9 and abs(c[2]) < 1e-4 for c in r.corners),
     lambda r: "not cut: mesh edges on the crease, within tolerance"),
    ("steps", ["z=floor(3*u)"],
     lambda: f"{walls(lambda u, v: math.floor(3 * u), U1, U1, 0.5)} cells are ramps",
     lambda r: r.surface["jumps_count"] > 0 and "jumps" in r.said
     and {c[2] for c in r.corners} <= {-3, -2, -1, 0, 1, 2, 3}
     and r.across(lambda u, v: min(math.floor(3 * u), 2)) == 0 and near(r.area(), 4, 1e-6),
     lambda r: "six flat steps, nothing between them: area " + number(r.area())),
    ("noise", ["z=mod(sin(u*12.9898+v*78.233)*43758,1)"],
     lambda: f"{walls(noise, U1, U1, 0.5)} of {N * N} cells are walls, without a word",
     ends_in_time,
     lambda r: f"{count(r.triangles)} triangles: foreseen to be finer than any mesh, and it says so, "
               "where it is off, and by how much"),
    ("steps without end", ["z=floor(1/u)+floor(1/v)"],
     lambda: f"{dropped(steps, U1, U1)} cells dropped, {walls(steps, U1, U1, 0.5)} are walls",
     lambda r: says_how_far_off(r) and r.surface["poles_count"] > 0 and r.surface["jumps_count"] > 0,
     lambda r: f"{count(r.triangles)} triangles, and it says by how much they are off; "
               f"clipped to {number(r.extent(2))} high"),
    ("waves on waves", [f"f(t)={WEIERSTRASS}", "z=f(u)*f(v)"],
     lambda: f"off by {number(chord_error(weierstrass, U1))} along u alone, without a word",
     ends_in_time,
     lambda r: f"the same, with {count(r.triangles)} triangles, off by {number(r.surface['max_error'])}"),
    ("an edge that is folded", ["x=cos(u)", "y=cos(v)", "z=sin(u)*sin(v)/2", "u=0:pi", "v=-pi:pi"],
     lambda: f"{6 * N} open edges: the halves of u = 0 and of u = pi lie on each other unjoined",
     lambda r: r.within() and r.open_edges() == 0 and near(r.volume(), math.pi**2 / 4),
     lambda r: f"a closed pillow: no open edge, volume {number(r.volume())}"),
    ("lobes that meet in a point", ["r=abs(cos(v)^3*sin(v)*cos(3*u))", "x=r*cos(v)*cos(u)",
                                    "y=r*cos(v)*sin(u)", "z=r*sin(v)", "u=0:2*pi", "v=-pi/2:pi/2"],
     lambda: f"{4 * N} open edges; no corner at the point but those of the poles and the equator",
     lambda r: r.within() and r.open_edges() == 0
     and near(r.volume(), 8 / (9 * 5.5 * 6.5), 0.02),
     lambda r: f"closed, creases down to the point; volume {number(r.volume())}"),
    ("a range run backwards", ["z=u*v", "u=1:-1", "v=0:1"],
     lambda: "front and back change places without a word",
     lambda r: "runs backwards" in r.said and r.within(),
     lambda r: "they do, and it says so"),
    ("an empty range", ["z=u*v", "u=1:1", "v=0:1"],
     lambda: f"{2 * N * N} triangles without area",
     lambda r: r.status == 2 and "range of u is empty" in r.said,
     lambda r: "status 2: the range of u is empty"),
]


def command(arguments):
    return "`" + " ".join(arguments).replace("|", "\\|") + "`"


def table(rows):
    yield "| case | formula | a plain grid | saddle |\n| --- | --- | --- | --- |\n"
    for title, arguments, grid, saddle in rows:
        yield f"| {title} | {command(arguments)} | {grid} | {saddle} |\n"
    yield "\n"


def complaints():
    rows = []
    for title, arguments, plain, holds, say in CASES:
        run = Run(arguments)
        if not run.fulfils(holds):
            yield f"{title}: {' '.join(arguments)}: not as it must be, status {run.status}"
            yield run.said
            continue
        if run.report and run.report["peak_memory_bytes"] > GIB and not IS_SANITIZED:
            yield f"{title}: took more than 1 GiB"
        rows.append((title, arguments, plain(), say(run)))
    if len(rows) == len(CASES):
        yield from tree.check_page("docs/STABILITY.md", "its own runs", "".join(table(rows)))


def all_complaints():
    yield from complaints()
    yield from glsl_cases.complaints()


tree.finish(all_complaints(), len(CASES) + len(glsl_cases.CASES), "cases")
