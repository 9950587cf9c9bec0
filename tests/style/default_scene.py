#!/usr/bin/python3 -B
"""docs/ACCURACY.md tells how far the meshes of the first grapher's default scene are off: its own grid
of 61 x 61 points, and saddle's. With --write, makes it so. The program is $SADDLE_PROGRAM, or
build/release/saddle."""
import json
import pathlib
import subprocess
import tempfile

import tree

SURFACE = "eck-default"
MESHES = [("the program's 61 x 61 points", ["--samples", "60x60"]),
          ("saddle's, as drawn", [])]


def row(name, options):
    """A picture of the mesh, as the program draws it; errors are those that the report proves or finds."""
    with tempfile.TemporaryDirectory() as folder:
        picture = pathlib.Path(folder, "a.png")
        done = subprocess.run([tree.program(), SURFACE, *options, "-o", picture, "-q", "--report", "-"],
                              capture_output=True, text=True, check=True)
    mesh = json.loads(done.stdout)["surfaces"][0]
    command = " ".join(["saddle", SURFACE, *options])
    return (f"| {name} | `{command}` | {mesh['triangles']} | {mesh['max_error']:.3g} | "
            f"{mesh['max_normal_error']:.3g} |\n")


body = ("| mesh | command | triangles | off by, in units of length | normals off by, in degrees |\n"
        "| --- | --- | --- | --- | --- |\n" + "".join(row(*mesh) for mesh in MESHES) + "\n")
tree.finish(tree.check_page("docs/ACCURACY.md", "saddle " + SURFACE, body), len(MESHES), "meshes")
