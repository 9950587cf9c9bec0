#!/usr/bin/python3 -B
"""A torus of 800x600 pixels, from its formula to a PNG: whole processes of saddle and of two fast
programs that draw without a display. Usage: peers.py SADDLE [OTHER-SADDLE...]

Wall times are medians of nine rounds, in each of which every program runs once, so that other work
on the machine meets them all. Processor times add up what all threads took; they hardly depend on
other work. Pictures of the others are not antialiased, and their facets are as coarse as named.
Other builds of saddle, older ones perhaps, run in the same rounds; a second table has the stages of
each, medians of the same rounds: they overlap, and do not add up."""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROUNDS = 9
SIZE = (800, 600)
REPORT = "saddle.json"
FORMULAS = {"x": "(2+cos(v))*cos(u)", "y": "(2+cos(v))*sin(u)", "z": "sin(v)"}

GNUPLOT = f"""set terminal png size {SIZE[0]},{SIZE[1]}
set output 'gnuplot.png'
set parametric
set pm3d depthorder lighting
set isosamples 100,100
set urange [0:2*pi]
set vrange [0:2*pi]
unset colorbox
splot {','.join(FORMULAS.values())} with pm3d
"""

# Its x and y run from 0 to 1.
MATHGL = f"""quality 6
setsize {SIZE[0]} {SIZE[1]}
new x 300 300 '(2+cos(2*pi*y))*cos(2*pi*x)'
new y 300 300 '(2+cos(2*pi*y))*sin(2*pi*x)'
new z 300 300 'sin(2*pi*y)'
rotate 60 30
light on
surf x y z
"""


def programs(saddles, folder):
    """Name and command of each program; the scripts that they read are in the folder."""
    (folder / "torus.gp").write_text(GNUPLOT, encoding="utf-8")
    (folder / "torus.mgl").write_text(MATHGL, encoding="utf-8")
    formulas = [f"{name}={text}" for name, text in FORMULAS.items()] + ["u=0:2*pi", "v=0:2*pi"]
    size = "x".join(map(str, SIZE))
    mine = {name: [saddle, *formulas, "-s", size, "-o", "saddle.png", "--report", REPORT]
            for name, saddle in saddles.items()}
    return mine | {
        "gnuplot gd, pm3d lighting, 100x100": ["gnuplot", "torus.gp"],
        "MathGL mglconv, quality 6, 300x300": ["mglconv", "torus.mgl", "-o", "mathgl.png"],
    }


def run(command, folder):
    """Wall and processor milliseconds, and peak memory in MB."""
    start = time.perf_counter()
    child = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    wall = time.perf_counter() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{command[0]} failed with status {child.returncode}")
    return 1e3 * wall, 1e3 * (usage.ru_utime + usage.ru_stime), usage.ru_maxrss / 1e3


def median(values):
    return statistics.median(list(values))


def one_round(commands, saddles, folder):
    """What run() says of each program, and the reports of those that are saddle."""
    costs = {}
    reports = {}
    for name, command in commands.items():
        costs[name] = run(command, folder)
        if name in saddles:
            reports[name] = json.loads((folder / REPORT).read_text(encoding="utf-8"))
    return costs, reports


def print_programs(rounds, names):
    mine = median(costs[names[0]][0] for costs, _ in rounds)
    print("| program | wall, ms | processor, ms | memory, MB | wall beside saddle's |")
    print("| --- | ---: | ---: | ---: | ---: |")
    for name in names:
        wall, cpu, memory = (median(costs[name][k] for costs, _ in rounds) for k in range(3))
        print(f"| {name} | {wall:.0f} | {cpu:.0f} | {memory:.0f} | {wall / mine:.2f} |")


def print_stages(rounds, saddles):
    """And what is left: the system's work before and after the program's own."""
    stages = list(rounds[0][1][saddles[0]]["times"])
    print(f"\n| stage, ms | {' | '.join(saddles)} |")
    print("| --- |" + " ---: |" * len(saddles))
    for stage in stages:
        cells = [median(reports[name]["times"].get(stage, 0) for _, reports in rounds)
                 for name in saddles]
        print(f"| {stage} | " + " | ".join(f"{ms:.1f}" for ms in cells) + " |")
    outside = [median(costs[name][0] - reports[name]["times"]["total"]
                      for costs, reports in rounds) for name in saddles]
    print("| before and after | " + " | ".join(f"{ms:.1f}" for ms in outside) + " |")


def main():
    paths = [pathlib.Path(path).resolve() for path in sys.argv[1:]]
    saddles = {"saddle, antialiased, half a pixel": str(paths[0])}
    saddles |= {f"saddle {k}": str(path) for k, path in enumerate(paths[1:], 2)}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        commands = programs(saddles, folder)
        one_round(commands, saddles, folder)  # caches of files and shaders are warm for all of them
        rounds = [one_round(commands, saddles, folder) for _ in range(ROUNDS)]
    print_programs(rounds, list(commands))
    print_stages(rounds, list(saddles))
    surface = rounds[-1][1][next(iter(saddles))]["surfaces"][0]
    share = surface["max_error"] / surface["tolerance"]
    print(f"\nsaddle's largest error is {0.5 * share:.2f} pixels, with {surface['triangles']} "
          "triangles.")


if __name__ == "__main__":
    main()
