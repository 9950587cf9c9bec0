#!/usr/bin/python3 -B
"""The model of what meshes cost against measured times, and what the program chooses by it.
Usage: costs.py PROGRAM [--fit | --csv FILE] [SURFACE...]. --fit prints the numbers of kCosts in
src/mesh/sizing/cost_model.h as they come out on this machine; --csv reads what PROGRAM printed before.

Times are the processor's. A surface's best method is the one whose mesh and picture took the least
of all that were measured: cells halved, the coarsest grid that keeps the tolerance (which nobody
knows before), and what was chosen."""
import csv
import pathlib
import re
import statistics
import subprocess
import sys

MODEL = pathlib.Path(__file__).parents[2] / "src/mesh/sizing/cost_model.h"
NAMES = ["grid_sample", "leaf_sample", "operation", "box", "box_operation", "triangle"]
WHY = ["grid cheaper", "halving cheaper", "asked", "limited", "tolerance varies", "not smooth",
       "grid misses"]
PASSES = 2000  # of coordinate descent: far more than six unknowns need


def counts(row):
    """What each coefficient is multiplied with, in millions: milliseconds from nanoseconds."""
    n = {key: float(value) for key, value in row.items() if key not in ("surface", "method")}
    operations = n["grid_samples"] * n["of_grid"] + n["leaf_samples"] * n["of_point"]
    return [1e-6 * k for k in (n["grid_samples"], n["leaf_samples"], operations, n["boxes"],
                               n["boxes"] * n["of_box"])]


def modelled(row, costs):
    return sum(c * k for c, k in zip(costs, counts(row)))


def meshing(row):
    return float(row["mesh_ms"]) - float(row["planning"])


def fit(rows):
    """Coefficients, none below 0, with the least relative errors."""
    lines = [[k / meshing(row) for k in counts(row)] for row in rows if row["method"] != "chosen"]
    costs = [0.0] * len(lines[0])
    for _ in range(PASSES):
        for i in range(len(costs)):
            square = sum(line[i] ** 2 for line in lines)
            rest = [1 - sum(c * k for j, (c, k) in enumerate(zip(costs, line)) if j != i)
                    for line in lines]
            if square > 0:
                costs[i] = max(0.0, sum(r * line[i] for r, line in zip(rest, lines)) / square)
    return costs


def fit_triangle(rows):
    """Nanoseconds for a triangle more: the median over surfaces drawn at several tolerances."""
    slopes = []
    by_surface = {}
    for row in rows:
        by_surface.setdefault(row["surface"], []).append(
            (float(row["triangles"]), float(row["draw_ms"])))
    for points in by_surface.values():
        (few, fast), (many, slow) = min(points), max(points)
        if many > 2 * few:
            slopes.append(1e6 * (slow - fast) / (many - few))
    return statistics.median(slopes)


def in_use():
    """The coefficients that the program was built with."""
    text = re.search(r"kCosts = \{([^}]*)\}", MODEL.read_text(encoding="utf-8"))[1]
    return [float(number) for number in text.split(",")]


def table(rows, costs):
    groups = {}
    for row in rows:
        groups.setdefault((row["surface"], float(row["factor"])), {})[row["method"]] = row
    worst = []
    print(f"{'surface':<26}{'px':>6} {'halving':>9}{'model':>8} {'grid':>9}{'model':>8} "
          f"{'chosen':>9} {'of best':>8} {'picture':>8}  why")
    for (name, factor), methods in groups.items():
        chosen = methods["chosen"]
        best = min(methods.values(), key=lambda row: float(row["mesh_ms"]))
        ratio = float(chosen["mesh_ms"]) / float(best["mesh_ms"])
        whole = [float(row["mesh_ms"]) + float(row["draw_ms"]) for row in methods.values()]
        of_whole = (float(chosen["mesh_ms"]) + float(chosen["draw_ms"])) / min(whole)
        line = f"{name:<26}{0.5 * factor:>6g} "
        for method in ("halving", "grid"):
            row = methods.get(method)
            if row:
                model = float(row["planning"]) + modelled(row, costs)
                line += f"{float(row['mesh_ms']):>9.2f}{model:>8.2f} "
            else:
                line += f"{'-':>9}{'-':>8} "
        why = "" if chosen["why"] == "-1" else WHY[int(chosen["why"])]
        print(f"{line}{float(chosen['mesh_ms']):>9.2f} {ratio:>8.2f} {of_whole:>8.2f}  {why}")
        worst.append((of_whole, ratio, name))
    print(f"\nchosen mesh and picture, against the best measured: at most "
          f"{max(worst)[0]:.2f} times ({max(worst)[2]}); mesh alone, median "
          f"{statistics.median(r for _, r, _ in worst):.2f}, at most {max(r for _, r, _ in worst):.2f}")


def main():
    program, *rest = sys.argv[1:]
    wants_fit = "--fit" in rest
    names = [name for name in rest if name != "--fit"]
    if names[:1] == ["--csv"]:
        text = pathlib.Path(names[1]).read_text(encoding="utf-8")
    else:
        text = subprocess.run([program, *names], check=True, stdout=subprocess.PIPE, text=True).stdout
    rows = list(csv.DictReader(text.splitlines()))
    if wants_fit:
        costs = fit(rows) + [fit_triangle(rows)]
        print("inline constexpr CostModel kCosts = {" + ", ".join(f"{c:.3g}" for c in costs) + "};")
        errors = sorted(modelled(row, costs) / meshing(row) for row in rows
                        if row["method"] != "chosen")
        print("model against time: " + ", ".join(
            f"{share:.0%} below {errors[int(share * (len(errors) - 1))]:.2f}"
            for share in (0.05, 0.5, 0.95)))
    else:
        table(rows, in_use())


main()
