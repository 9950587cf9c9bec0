#!/usr/bin/python3 -B
"""What fine meshes take, beside a plain grid of as many triangles.
Usage: fine.py SADDLE [--hard | NAME...].

Of each surface and tolerance: the peak memory of the whole process, as a multiple of the bytes of
the PLY file, and the processor time of a million triangles; the same of a grid of equal cells. The
times are the least of several rounds: other work only ever adds to them. With --hard, of surfaces
that no mesh of a reasonable size shows, in one round, with what the report finds."""
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
HARD = [("z=tanh(1e5*(u^2+v^2-.5))", 1e-5), ("z=sqrt(1-u^2-v^2)", 1e-6)]


def run(command):
    """The processor time in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measured(saddle, arguments, folder, rounds=ROUNDS):
    """Triangles, peak memory over the bytes of the file, seconds for a million triangles, and the
    kinds of findings."""
    mesh, report = folder / "mesh.ply", folder / "report.json"
    command = [saddle, *arguments, "-o", mesh, "--report", report]
    time = min(run(command) for _ in range(rounds))
    told = json.loads(report.read_text())
    triangles = told["surfaces"][0]["triangles"]
    memory = told["peak_memory_bytes"] / mesh.stat().st_size
    return triangles, memory, time / triangles * 1e6, [found["kind"] for found in told["findings"]]


def print_hard(saddle, folder):
    print("| formula | tolerance | triangles | memory, files | s per million triangles | findings |")
    print("| --- | --- | ---: | ---: | ---: | --- |")
    for formula, tolerance in HARD:
        arguments = [formula, "u=-1:1", "v=-1:1", "--tolerance", str(tolerance)]
        count, memory, time, found = measured(saddle, arguments, folder, rounds=1)
        print(f"| `{formula}` | {tolerance:g} | {count:,} | {memory:.1f} | {time:.1f} "
              f"| {', '.join(found)} |")


def main():
    saddle, *names = sys.argv[1:]
    if names == ["--hard"]:
        with tempfile.TemporaryDirectory() as name:
            print_hard(saddle, pathlib.Path(name))
        return
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
