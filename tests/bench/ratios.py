#!/usr/bin/python3 -B
"""What each stage costs beside a yardstick of the same run, against what it did: ratios.json.
Usage: ratios.py BENCHMARK-PROGRAM SADDLE [--accept]. Exit 1 if a ratio is 30 % worse.

Absolute times are of no use between machines, and little between hours. Here the repetitions of all
stages are mixed in time, and the times are the processor's, so that other work hardly matters."""
import json
import pathlib
import subprocess
import sys
import tempfile

FILE = pathlib.Path(__file__).with_name("ratios.json")
WORSE = 1.3
REPETITIONS = 3
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


def measured(program, saddle):
    times = stages(program)
    unit = times.pop(YARDSTICK)
    print(f"yardstick: {unit:.3f} ms", file=sys.stderr)
    result = {name: time / unit for name, time in times.items()}
    for size in ("800x600", "3840x2160"):
        result[f"memory {size}, MB"] = memory(saddle, size)
    return {name: float(f"{value:.3g}") for name, value in result.items()}


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
    if options not in ([], ["--accept"]):
        sys.exit("usage: ./dev bench compare [--accept]")
    before = json.loads(FILE.read_text(encoding="utf-8")) if FILE.is_file() else {}
    now = measured(program, saddle)
    worse = report(now, before)
    if options:
        FILE.write_text(json.dumps(now, indent=2) + "\n", encoding="utf-8")
    elif worse:
        sys.exit("worse by 30 % or more: " + ", ".join(worse))


main()
