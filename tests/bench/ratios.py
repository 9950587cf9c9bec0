#!/usr/bin/python3 -B
"""What each stage and whole runs cost beside a yardstick of the same run, against what it did: ratios.json.
Usage: ratios.py BENCHMARK-PROGRAM SADDLE [--accept | --chart FILE.svg]. Exit 1 if a ratio is 30 %
worse; --chart draws how the times grow with tolerance and picture instead.

Absolute times are of no use between machines, and little between hours. Here the repetitions of all
stages are mixed in time, and the times are the processor's, so that other work hardly matters."""
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

FILE = pathlib.Path(__file__).with_name("ratios.json")
WORSE = 1.3
REPETITIONS = 3
RUNS = 9  # of the whole program
YARDSTICK = "yardstick"


def stages(program):
    """The least processor time of each stage, in milliseconds: other work only ever adds to it."""
    done = subprocess.run(
        [program, "--benchmark_filter=^stage/", f"--benchmark_repetitions={REPETITIONS}",
         "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.02",
         "--benchmark_format=json"], check=True, capture_output=True, text=True)
    times = {}
    runs = json.loads(done.stdout)["benchmarks"]
    for run in sorted(runs, key=lambda run: run["family_index"]):
        if run["run_type"] != "iteration":
            continue
        name = run["run_name"].removeprefix("stage/").removesuffix("/process_time")
        times[name] = min(times.get(name, float("inf")), run["cpu_time"])
    return times


def memory(saddle, size):
    """Peak memory of a whole run, in MB."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([saddle, "torus", "-s", size, "-o", "a.png", "--report", "-"],
                              cwd=folder, check=True, capture_output=True, text=True)
    return json.loads(done.stdout)["peak_memory_bytes"] / 1e6


def whole_run(saddle, *arguments):
    """The least processor time of a run, from start to exit, in milliseconds."""
    def spent():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return 1e3 * (used.ru_utime + used.ru_stime)

    least = float("inf")
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(RUNS):
            before = spent()
            subprocess.run([saddle, "torus", *arguments], cwd=folder, check=True)
            least = min(least, spent() - before)
    return least


def measured(program, saddle):
    times = stages(program)
    unit = times.pop(YARDSTICK)
    print(f"yardstick: {unit:.3f} ms", file=sys.stderr)
    times["run, 800x600 picture"] = whole_run(saddle, "-o", "a.png")
    times["run, with axes"] = whole_run(saddle, "--axes", "-o", "a.png")
    times["run, mesh"] = whole_run(saddle, "-o", "a.ply")
    result = {name: time / unit for name, time in times.items()}
    for size in ("800x600", "3840x2160"):
        result[f"memory {size}, MB"] = memory(saddle, size)
    return {name: float(f"{value:.3g}") for name, value in result.items()}


def growth(times, kind, size_of):
    """Size and milliseconds of the stages of a kind that differ in nothing but their size."""
    points = []
    for name, time in times.items():
        words = name.split(" ")
        if words[0] == kind and len(words) == 2:
            points.append((size_of(words[1]), time))
    return sorted(points)


def megapixels(size):
    width, height = size.split("x")
    return int(width) * int(height) / 1e6


def chart(times, file):
    """Two panels, logarithmic both ways: growth that is in proportion is a line of slope 1."""
    meshes = growth(times, "mesh", lambda share: 1 / float(share))
    pictures = growth(times, "draw", megapixels)
    script = f"""set terminal svg size 900,380 font 'sans,12' background '#ffffff'
set output '{file}'
set multiplot layout 1,2
set logscale xy; unset key; set border 3; set tics nomirror; set grid lc rgb '#e4e4e4'
set ylabel 'processor time, ms'; set format x '10^{{%L}}'
"""
    for title, label, points in (("torus to mesh", "diagonal / tolerance", meshes),
                                 ("mesh to antialiased picture", "megapixels", pictures)):
        data = "\n".join(f"{x:g} {y:g}" for x, y in points)
        x, y = points[-1]
        script += f"""set title '{title}'; set xlabel '{label}'
$points << END
{data}
END
plot {y / x:g} * x dt 3 lc rgb '#999999', \
  $points with linespoints pt 7 ps 0.6 lw 2 lc rgb '#0072b2'
"""
    subprocess.run(["gnuplot"], input=script + "unset multiplot\n", text=True, check=True)


def report(now, before):
    """A table of what was and is; the names of what is worse."""
    worse = []
    print(f"{'stage':<32} {'before':>9} {'now':>9} {'change':>8}")
    for name, value in now.items():
        old = before.get(name)
        change = "new" if old is None else f"{100 * (value / old - 1):+.0f} %"
        mark = ""
        if old is not None and value > WORSE * old:
            worse.append(name)
            mark = "  worse"
        print(f"{name:<32} {old if old is not None else '':>9} {value:>9.3g} {change:>8}{mark}")
    return worse


def main():
    program, saddle, *options = sys.argv[1:]
    if len(options) == 2 and options[0] == "--chart":
        return chart(stages(program), options[1])
    if options not in ([], ["--accept"]):
        sys.exit("usage: ./dev bench compare [--accept | --chart FILE.svg]")
    before = json.loads(FILE.read_text(encoding="utf-8")) if FILE.is_file() else {}
    now = measured(program, saddle)
    worse = report(now, before)
    if options:
        FILE.write_text(json.dumps(now, indent=2) + "\n", encoding="utf-8")
    elif worse:
        sys.exit("worse by 30 % or more: " + ", ".join(worse))


main()
