#!/usr/bin/python3 -B
"""docs/LIGHTING.md tells how far colours of a coarse torus are from those of a fine one, for each shading.
With --write, makes it so. The program is $SADDLE_PROGRAM, or build/release/saddle.
It is run by hand, as Debian's Python alone has numpy and PIL."""
import pathlib
import subprocess
import tempfile

import numpy
from PIL import Image

import tree

SCENE = tree.ROOT / "examples/exact-normals.toml"
SIZE = "600x450"
SHADINGS = ("vertex", "pixel", "exact")
CELLS = (8, 16, 32, 64)
FINE = 1000
# Pixels that are so near to the background in either picture are at its outline.
OUTLINE = 8


def picture(folder, cells, shading):
    path = pathlib.Path(folder, "a.png")
    subprocess.run([tree.program(), SCENE, "--samples", f"{cells}x{cells}", "--shading", shading, "-s", SIZE,
                    "-q", "-o", path], check=True)
    return numpy.asarray(Image.open(path).convert("RGB")).astype(float)


def inside(colours):
    """Where all pixels within OUTLINE show the torus."""
    shown = (colours > 0).any(axis=2)
    for axis in (0, 1):
        grown = shown.copy()
        for step in range(1, OUTLINE + 1):
            grown &= numpy.roll(shown, step, axis) & numpy.roll(shown, -step, axis)
        shown = grown
    return shown


with tempfile.TemporaryDirectory() as place:
    fine = picture(place, FINE, "pixel")
    body = "| cells | " + " | ".join(SHADINGS) + " |\n|" + " --- |" * (len(SHADINGS) + 1) + "\n"
    for cells in CELLS:
        body += f"| {cells} x {cells} |"
        for shading in SHADINGS:
            coarse = picture(place, cells, shading)
            where = inside(coarse) & inside(fine)
            body += f" {numpy.sqrt(((coarse - fine)[where] ** 2).mean()):.2g} |"
        body += "\n"
tree.finish(tree.check_page("docs/LIGHTING.md", "saddle " + SCENE.name, body + "\n"),
            len(CELLS) * len(SHADINGS), "pictures")
