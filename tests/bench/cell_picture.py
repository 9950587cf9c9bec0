#!/usr/bin/python3 -B
"""Draws the leaves of a mesh in the plane of its parameters, as SVG: sides of leaves dark, diagonals
light, boundaries and jumps red, hanging vertices as dots.

    cell_picture.py PROGRAM OUT.svg [FORMULA OPTION...]    default: the picture of src/mesh/README.md"""
import collections
import pathlib
import struct
import subprocess
import sys
import tempfile

DEFAULT = ["z=sqrt(1.2-u^2-v^2)+sign(u-v/3)/4", "--tolerance", "0.02", "--grid", "off"]
SIZE = 420  # pixels
VERTEX = struct.Struct("<6f2d")
FACE = struct.Struct("<B3i")
ROUNDING = 1e-9  # of parameters: sides of leaves are exact, features are not


def read_ply(path):
    """The parameters of the vertices, and the triangles."""
    data = path.read_bytes()
    header, body = data[:data.index(b"end_header\n")].decode(), data[data.index(b"end_header\n") + 11:]
    count = {line.split()[1]: int(line.split()[2]) for line in header.splitlines()
             if line.startswith("element")}
    size = VERTEX.size * count["vertex"]
    places = [vertex[6:] for vertex in VERTEX.iter_unpack(body[:size])]
    return places, [face[1:] for face in FACE.iter_unpack(body[size:])]


def is_along_axis(a, b):
    return min(abs(a[0] - b[0]), abs(a[1] - b[1])) < ROUNDING


def hanging(edges):
    """The vertices at which three of the four directions along the axes have an edge."""
    ways = collections.defaultdict(set)
    for a, b in edges:
        for here, there in ((a, b), (b, a)):
            ways[here].add((round(there[0] - here[0], 9) > 0, round(there[0] - here[0], 9) < 0,
                            round(there[1] - here[1], 9) > 0))
    ends = [max(place[k] for place in ways) for k in (0, 1)]
    starts = [min(place[k] for place in ways) for k in (0, 1)]
    return [place for place, found in ways.items()
            if len(found) == 3 and all(starts[k] < place[k] < ends[k] for k in (0, 1))]


def picture(places, triangles):
    counts = collections.Counter()
    for t in triangles:
        for k in range(3):
            counts[tuple(sorted((places[t[k]], places[t[(k + 1) % 3]])))] += 1
    low = [min(place[k] for place in places) for k in (0, 1)]
    high = [max(place[k] for place in places) for k in (0, 1)]

    def at(place):
        part = [(place[k] - low[k]) / (high[k] - low[k]) for k in (0, 1)]
        return round(8 + (SIZE - 16) * part[0], 1), round(SIZE - 8 - (SIZE - 16) * part[1], 1)

    groups = collections.defaultdict(list)
    for (a, b), count in counts.items():
        kind = "side" if is_along_axis(a, b) else "diagonal" if count > 1 else "feature"
        groups[kind].append((a, b))
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{SIZE}" height="{SIZE}">',
             '<rect width="100%" height="100%" fill="white"/>']
    for kind, style in (("diagonal", "#ccc"), ("side", "#224"), ("feature", "#d22")):
        path = "".join(f"M{at(a)[0]} {at(a)[1]}L{at(b)[0]} {at(b)[1]}" for a, b in groups[kind])
        width = 2 if kind == "feature" else 1
        lines.append(f'<path d="{path}" stroke="{style}" stroke-width="{width}" fill="none"/>')
    lines += [f'<circle cx="{at(p)[0]}" cy="{at(p)[1]}" r="3" fill="#07c"/>'
              for p in sorted(hanging(groups["side"]))]
    return "\n".join([*lines, "</svg>", ""])


def main():
    program, out, *arguments = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        mesh = pathlib.Path(folder) / "mesh.ply"
        subprocess.run([program, *(arguments or DEFAULT), "-o", str(mesh)], check=True)
        pathlib.Path(out).write_text(picture(*read_ply(mesh)), encoding="utf-8")


main()
