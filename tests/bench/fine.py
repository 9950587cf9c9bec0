#!/usr/bin/python3 -B
"""What fine meshes take, beside a plain grid of as many triangles. Usage: fine.py SADDLE [NAME...].

Of each surface and tolerance: the peak memory of the whole process, as a multiple of the bytes of
the PLY file, and the processor time of a million triangles; the same of a grid of equal cells. The
times are the least of several rounds: other work only ever adds to them."""
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

ROUNDS = 3
SURFACES = ["sphere", "torus", "enneper", "boy"]
TOLERANCES = [1e-4, 1e-5, 1e-6]


def run(command):
    """The processor time in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measured(saddle, arguments, folder):
    """Triangles, peak memory over the bytes of the file, and seconds for a million triangles."""
    mesh, report = folder / "mesh.ply", folder / "report.json"
    command = [saddle, *arguments, "-o", mesh, "--report", report]
    time = min(run(command) for _ in range(ROUNDS))
    told = json.loads(report.read_text())
    triangles = told["surfaces"][0]["triangles"]
    return triangles, told["peak_memory_bytes"] / mesh.stat().st_size, time / triangles * 1e6


def main():
    saddle, *names = sys.argv[1:]
    print("| surface | tolerance | triangles | memory, files | of a grid | s per million triangles "
          "| of a grid |")
    print("| --- | --- | ---: | ---: | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for surface in names or SURFACES:
            for tolerance in TOLERANCES:
                fine = measured(saddle, [surface, "--tolerance", str(tolerance)], folder)
                side = round(math.sqrt(fine[0] / 2))
                grid = measured(saddle, [surface, "--samples", f"{side}x{side}"], folder)
                print(f"| `{surface}` | {tolerance:g} | {fine[0]:,} | {fine[1]:.1f} | {grid[1]:.1f} "
                      f"| {fine[2]:.2f} | {grid[2]:.2f} |")


if __name__ == "__main__":
    main()
