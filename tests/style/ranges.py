#!/usr/bin/python3 -B
"""The table of ranges in docs/LIGHTING.md is that of src/render/shading/shader_lights.cpp, its last
column is what the attenuation leaves, and docs/range.svg has its curves: --write makes them."""
import math
import re
import sys

import tree

PAGE = "docs/LIGHTING.md"
SOURCE = "src/render/shading/shader_lights.cpp"
CHART = tree.ROOT / "docs/range.svg"
ROW = re.compile(r"\| ([0-9.]+) \| ([0-9.]+) \| ([0-9.]+) \| ([0-9.]+) % \|$", re.M)
SOURCE_ROW = re.compile(r"\{+([0-9.]+), ([0-9.]+), ([0-9.]+)\}")

WIDTH, HEIGHT, MARGIN = 640, 400, 50
NEAREST, FARTHEST = 1, 10_000  # distances on the chart
LEAST = 0.001  # light on the chart
STEPS = 60  # of a curve


def light(distance, linear, quadratic):
    return 1 / (1 + linear * distance + quadratic * distance**2)


def x_of(distance):
    share = math.log(distance / NEAREST) / math.log(FARTHEST / NEAREST)
    return MARGIN + share * (WIDTH - 2 * MARGIN)


def y_of(brightness):
    share = math.log(brightness) / math.log(LEAST)
    return MARGIN + share * (HEIGHT - 2 * MARGIN)


def curve(reach, linear, quadratic):
    """A row's curve down to the chart's lower edge, with a dot at its range."""
    points = []
    for k in range(STEPS + 1):
        distance = NEAREST * (FARTHEST / NEAREST)**(k / STEPS)
        brightness = light(distance, linear, quadratic)
        if brightness >= LEAST:
            points.append(f"{x_of(distance):.1f},{y_of(brightness):.1f}")
    dot = f'cx="{x_of(reach):.1f}" cy="{y_of(light(reach, linear, quadratic)):.1f}"'
    return (f'<polyline points="{" ".join(points)}" fill="none" stroke="#3060c0"/>\n'
            f'<circle {dot} r="3" fill="#c03030"/>\n')


def axes():
    lines = ""
    for distance in (1, 10, 100, 1000, 10_000):
        x = x_of(distance)
        lines += (f'<line x1="{x:.1f}" y1="{MARGIN}" x2="{x:.1f}" y2="{HEIGHT - MARGIN}" stroke="#ccc"/>\n'
                  f'<text x="{x:.1f}" y="{HEIGHT - MARGIN + 18}" text-anchor="middle">{distance}</text>\n')
    for brightness in (1, 0.1, 0.01, 0.001):
        y = y_of(brightness)
        lines += (f'<line x1="{MARGIN}" y1="{y:.1f}" x2="{WIDTH - MARGIN}" y2="{y:.1f}" stroke="#ccc"/>\n'
                  f'<text x="{MARGIN - 6}" y="{y + 4:.1f}" text-anchor="end">{brightness:g}</text>\n')
    return lines


def chart(rows):
    title = "light left at a distance; dots: at the range"
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
            f'font-family="sans-serif" font-size="12">\n<rect width="100%" height="100%" fill="white"/>\n'
            f'<text x="{WIDTH // 2}" y="28" text-anchor="middle">{title}</text>\n'
            + axes() + "".join(curve(*row[:3]) for row in rows)
            + f'<text x="{WIDTH // 2}" y="{HEIGHT - 10}" text-anchor="middle">distance</text>\n</svg>\n')


def complaints(rows):
    source = (tree.ROOT / SOURCE).read_text(encoding="utf-8")
    table = source[source.index("kRows = "):source.index("// Powers of the range")]
    known = [tuple(map(float, row)) for row in SOURCE_ROW.findall(table)]
    if [row[:3] for row in rows] != known or len(known) != 12:
        yield f"{PAGE} does not have the rows of {SOURCE}"
    for reach, linear, quadratic, percent in rows:
        left = 100 * light(reach, linear, quadratic)
        if abs(left - percent) > 0.0051:
            yield f"{PAGE}: at {reach:g} {left:.2f} % are left"
    if not CHART.exists() or CHART.read_text(encoding="utf-8") != chart(rows):
        yield f"{CHART.name} is another chart: tests/style/ranges.py --write"


found = [tuple(map(float, row)) for row in ROW.findall((tree.ROOT / PAGE).read_text(encoding="utf-8"))]
if "--write" in sys.argv[1:]:
    CHART.write_text(chart(found), encoding="utf-8")
tree.finish(list(complaints(found)), len(found), "ranges")
