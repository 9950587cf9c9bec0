#!/usr/bin/python3 -B
"""Volumes of solids against Steiner's formula: a thin solid of thickness T about a surface of area A
has T A + T^3/12 times the integral of the Gaussian curvature. Usage: volumes.py SADDLE [WORD...]: the
gallery, or its surfaces with a WORD in their names. Area and curvature are those of the mesh without
a thickness, by this script. Exit 1 if a solid is not closed or its volume is not near."""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "honesty"))
from mesh import read_ply  # pylint: disable=wrong-import-position

THICKNESS = 0.001  # as a share of the diagonal
# Both volumes belong to the same mesh. They differ where its normals turn from corner to corner, as
# the square of the angle: 2 degrees, and more at creases and tips, where the solid is rounded or cut.
TOLERANCE = ["--tolerance", "0.05px", "--normal-tolerance", "2"]
MOST = 0.01  # of the volume


def run(saddle, *words):
    done = subprocess.run([saddle, *words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)}: {done.stderr}")


def area_and_curvature(path):
    """The area of the triangles, and the area that their normals cover on the unit sphere."""
    mesh = read_ply(path)
    places, normals = mesh.points[mesh.triangles], mesh.normals[mesh.triangles]
    area = numpy.linalg.norm(numpy.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0]),
                             axis=1).sum() / 2
    a, b, c = normals[:, 0], normals[:, 1], normals[:, 2]
    dot = lambda p, q: (p * q).sum(1)
    angles = 2 * numpy.arctan2(dot(a, numpy.cross(b, c)), 1 + dot(a, b) + dot(b, c) + dot(c, a))
    return area, angles.sum()


def main():
    saddle, *words = sys.argv[1:]
    names = subprocess.run([saddle, "list"], capture_output=True, text=True, check=True).stdout.split()
    names = [name for name in names if not words or any(word in name for word in words)]
    if not names:
        sys.exit("no surface has such a name")
    complaints = []
    errors = []
    with tempfile.TemporaryDirectory() as folder:
        surface, report = pathlib.Path(folder) / "a.ply", pathlib.Path(folder) / "a.json"
        for name in names:
            run(saddle, name, *TOLERANCE, "-o", str(surface), "--report", str(report), "-q")
            area, curvature = area_and_curvature(surface)
            low, high = json.loads(report.read_text())["surfaces"][0]["bounds"]
            diagonal = sum((b - a) ** 2 for a, b in zip(low, high)) ** 0.5
            thickness = float(f"{THICKNESS * diagonal:.6g}")
            run(saddle, name, *TOLERANCE, "--thickness", str(thickness), "-o", str(surface),
                "--report", str(report), "-q")
            solid = json.loads(report.read_text())["surfaces"][0]["solid"]
            exact = thickness * area + thickness ** 3 / 12 * curvature
            error = solid["volume"] / exact - 1
            errors.append(abs(error))
            print(f"{name} | {thickness:.4g} | {exact:.6g} | {solid['volume']:.6g} | {error:+.2%}",
                  flush=True)
            if not solid["closed"]:
                complaints.append(f"{name}: not closed")
            if not abs(error) <= MOST:
                complaints.append(f"{name}: {error:+.2%} from Steiner's volume")
    for complaint in complaints:
        print("WRONG:", complaint)
    print(f"{len(names)} solids, median error {numpy.median(errors):.4%}, largest {max(errors):.3%}, "
          f"{len(complaints)} complaints")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
