#!/usr/bin/python3 -B
"""Every surface of the gallery whose camera is automatic fills its picture: it is inside of the
margin, and touches it on two opposite sides. A colour bar takes its room from one side alone. With
--table, prints the extents. The program is $SADDLE_PROGRAM, or build/release/saddle."""
import struct
import subprocess
import sys
import zlib

import tree

WIDTH, HEIGHT = 240, 160
MARGIN = 0.04  # of each side, as kPictureMargin in src/scene/model/camera.h
# An edge of a surface covers a part of a pixel, and its line is half a pixel beyond it.
PIXELS = 1.6


def run(arguments):
    return subprocess.run([tree.program(), *arguments], capture_output=True, check=True).stdout


def alpha_of(png):
    """Rows of a PNG's alpha, of four channels of eight bits."""
    at, data = 8, b""
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at : at + 8])
        data += png[at + 8 : at + 8 + size] if kind == b"IDAT" else b""
        at += size + 12
    data = zlib.decompress(data)
    stride = 4 * WIDTH
    assert len(data) == HEIGHT * (stride + 1), "the picture has no alpha"
    before = bytearray(stride)
    for row in range(HEIGHT):
        start = row * (stride + 1)
        method, line = data[start], bytearray(data[start + 1 : start + 1 + stride])
        for i in range(3, stride, 4):
            left = line[i - 4] if i >= 4 else 0
            corner = before[i - 4] if i >= 4 else 0
            line[i] = (line[i] + predicted(method, left, before[i], corner)) % 256
        before = line
        yield line[3::4]


def predicted(method, left, above, corner):
    """Source: W3C, "Portable Network Graphics (PNG) Specification", 2003, section 9.2."""
    if method == 4:
        guess = left + above - corner
        return min((left, above, corner), key=lambda v: abs(guess - v))
    return (0, left, above, (left + above) // 2)[method]


def margins(arguments):
    """Free pixels at the left, right, top and bottom."""
    size = ["-s", f"{WIDTH}x{HEIGHT}", "--background", "none", "--quiet"]
    rows = list(alpha_of(run([*arguments, *size, "-o", "-", "--format", "png"])))
    filled = [y for y, row in enumerate(rows) if any(row)]
    columns = [x for x in range(WIDTH) if any(row[x] for row in rows)]
    return columns[0], WIDTH - 1 - columns[-1], filled[0], HEIGHT - 1 - filled[-1]


def complaints(table):
    for name in NAMES:
        left, right, top, bottom = margins([name])
        # How far each side is from the margin.
        off = [left - MARGIN * WIDTH, right - MARGIN * WIDTH]
        off += [top - MARGIN * HEIGHT, bottom - MARGIN * HEIGHT]
        across = (WIDTH - left - right) / WIDTH
        down = (HEIGHT - top - bottom) / HEIGHT
        if table:
            print(f"{name:30} {100 * across:5.1f} % across {100 * down:5.1f} % down")
        if b"distance" in run(["show", name]):
            continue
        if min(off) < -PIXELS:
            yield f"{name}: it reaches into the margin, {off}"
        if max(off[0], off[1]) > PIXELS and max(off[2], off[3]) > PIXELS:
            yield f"{name}: it touches no two opposite sides, {off}"
    left = margins(["torus", "--color", "z"])[0]
    if abs(left - MARGIN * WIDTH) > PIXELS:
        yield f"torus beside a colour bar: {left} pixels are free at the left"


NAMES = [line.split()[0] for line in run(["list"]).decode().splitlines()]
tree.finish(complaints("--table" in sys.argv), len(NAMES), "surfaces")
