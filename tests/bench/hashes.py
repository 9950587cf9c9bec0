#!/usr/bin/python3 -B
"""Hashes of what saddle writes, a line each, to prove that a change of the code changes no byte:
pictures, meshes, scenes, messages and reports (without times and memory). The cases are the gallery,
the examples, the surfaces of docs/STABILITY.md, those of stress.py, and the features below. Each is
written to files of all kinds, drawn by itself, and meshed with --samples.

Prints the hashes, or with --against those that differ."""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

import stress

ROOT = pathlib.Path(__file__).resolve().parents[2]
# How a case is run: its options, and the files that it writes. Meshes have a tolerance of their own.
WAYS = {
    "files": ([], ("png", "ply", "toml")),
    "picture": ([], ("png",)),
    "samples": (["--samples", "61x47"], ("ply",)),
}
# Where surfaces are not smooth: jumps, boundaries, islands, poles, creases and cusps, alone and
# crossing, with grid lines and without, clipped, at tolerances of their own.
FEATURES = [
    "z=sqrt(u)+sqrt(v)", "z=floor(u)*floor(v) u=-2:2 v=-2:2", "z=sign(u*v)", "z=sign(u^3-v^2)",
    "z=(u>0&&v>0)?1:0", "z=(u>v)?((u>-v)?1:2):((u>-v)?3:4)", "z=(v>0.5*sin(5*u))?u:-u",
    "z=floor(hypot(u,v)) u=-3:3 v=-3:3", "z=mod(hypot(u,v),0.3)", "z=round(3*sin(3*u)*sin(3*v))",
    "z=(u^2+v^2<0.003)?1:0", "z=(u^2+v^2<0.5)?(u>0?1:2):0", "z=(u^2+v^2<0.5)?1:0 --grid off",
    "z=(u^2+v^2<0.5&&v>0)?1:0 --grid off", "z=(hypot(u+0.3,v-0.2)<0.01)?nan:0.2*u*v",
    "z=sqrt(1-u^2)+sqrt(1-v^2)", "z=sqrt(1-u^2-v^2)", "z=(1-u^(2/3)-v^(2/3))^1.5 u=0:1 v=0:1",
    "z=acos(u)*acos(v)", "z=ln(sin(u)+sin(v)) u=-4:4 v=-4:4", "z=sqrt(1e-5-abs(u-v/3-0.2))",
    "z=u/v", "z=(u+v)/(u-v)", "z=u^2*v/(u^4+v^2)", "z=1/(u^2+v^2)", "z=gamma(u)*v u=-4:4",
    "z=tan(u)*v u=-5:5", "z=tan(u)*v u=-5:5 --grid off", "z=0.3*v+1e-4*ln(abs(u-0.378522))",
    "z=1/u --clip -1:1,-1:1,-2:2", "z=1/(u*v) --clip -1:1,-1:1,-1:1 --tolerance 1e-3",
    "z=abs(u)-abs(v)", "z=abs(u*v)^0.2", "z=sign(u-0.2)*abs(u-0.2)^0.05", "z=hypot(u,v)",
    "x=u^2 y=u^3 z=v", "x=u^3 y=v^3 z=u*v", "x=u+floor(u) y=v z=0 u=-2:2",
    "z=exp(-1e6*((u-.312)^2+(v-.17)^2))", "z=exp(-((u^2+v^2-.5)/1e-3)^2)", "z=tanh(1e5*u)*tanh(1e5*v)",
    "x=exp(u)*cos(v) y=exp(u)*sin(v) z=u u=-20:2 v=0:2*pi", "z=clamp(1e5*(hypot(u,v)-0.7),-1,1)",
    "x=cos(u)*v y=sin(u)*v z=v u=0:2*pi v=-1:1", "x=cos(u) y=sin(u) z=u/4", "x=1 y=2 z=3",
    "x=(2+cos(v))*cos(u) y=(2+cos(v))*sin(u) z=sin(v) u=0:2*pi v=0:2*pi --tolerance 1e-5",
    "x=(2+cos(v))*cos(u) y=(2+cos(v))*sin(u) z=sin(v) u=0:2*pi v=0:2*pi --tolerance 0.02 --grid off",
    "x=cos(v)*cos(u) y=cos(v)*sin(u) z=sin(v) u=0:2*pi v=-pi/2:pi/2 --normal-tolerance 2",
    "x=(1+v/2*cos(u/2))*cos(u) y=(1+v/2*cos(u/2))*sin(u) z=v/2*sin(u/2) u=0:2*pi --color gauss",
    "z=sin(3*u)*cos(2*v) --color z --max-triangles 300",
]
# Keys of the report that differ from run to run.
VOLATILE = ("times", "peak_memory_bytes")
SIZE = "240x180"


def gallery(program):
    names = subprocess.run([program, "list"], capture_output=True, text=True, check=True).stdout
    return {name: [name] for name in names.split()}


def examples():
    folder = ROOT / "examples"
    return {str(path.relative_to(folder)): [str(path)] for path in sorted(folder.rglob("*.toml"))}


def stability():
    """The formulas of the page's table."""
    cases = {}
    for line in (ROOT / "docs/STABILITY.md").read_text(encoding="utf-8").splitlines():
        columns = line.split("|")
        if len(columns) < 3 or "`" not in columns[2]:
            continue
        formula = columns[2].split("`")[1]
        cases[formula] = shlex.split(formula)
    return cases


def listed(formulas):
    return {formula: formula.split() for formula in formulas}


def content(path, without):
    data = path.read_bytes()
    if path.suffix != ".json":
        return data
    report = json.loads(data)
    for key in VOLATILE:
        report.pop(key, None)
    for surface in report.get("surfaces", []):
        surface.pop(without, None)
    return nameless(json.dumps(report, sort_keys=True), path.parent)


def nameless(text, folder):
    """Messages name the files that are written, which are in a folder of another name each time."""
    return text.replace(f"{folder}{os.sep}", "").encode()


def short(data):
    return hashlib.sha256(data).hexdigest()[:16]


def hashes(program, without, name, way, arguments):
    """Lines of one run. What is not written has the exit status in place of a hash."""
    options, kinds = WAYS[way]
    with tempfile.TemporaryDirectory() as folder:
        files = [pathlib.Path(folder) / f"out.{kind}" for kind in (*kinds, "json")]
        command = [program, *arguments, *options, "-s", SIZE, "--report", str(files[-1])]
        for path in files[:-1]:
            command += ["-o", str(path)]
        run = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL,
                             check=False)
        lines = [f"{short(nameless(run.stderr, folder))} {way} said {name}"]
        for path in files:
            found = short(content(path, without)) if path.exists() else f"exit {run.returncode}"
            lines.append(f"{found:16} {way} {path.suffix[1:]} {name}")
        return lines


def all_hashes(program, options):
    cases = {**gallery(program), **examples(), **stability(), **listed(stress.CASES),
             **listed(FEATURES)}
    runs = [(name, way, arguments) for name, arguments in cases.items() for way in WAYS
            if not options.words or any(word in name for word in options.words)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = pool.map(lambda run: hashes(program, options.without, *run), runs)
        return [line for lines in found for line in lines]


def lines_of(other, options):
    """The lines of a program, or of a file that holds them."""
    if other.read_bytes()[:4] == b"\x7fELF":
        return all_hashes(str(other), options)
    return other.read_text(encoding="utf-8").splitlines()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("words", nargs="*", help="cases whose name has one of them; default: all")
    parser.add_argument("--against", metavar="OTHER", type=pathlib.Path,
                        help="a program, or a file with the lines that one printed")
    parser.add_argument("--without", metavar="KEY",
                        help="hash reports without this key of their surfaces")
    options = parser.parse_intermixed_args()
    ours = all_hashes(options.program, options)
    if not options.against:
        print("\n".join(ours))
        return
    theirs = set(lines_of(options.against, options))
    different = [line for line in ours if line not in theirs]
    print("\n".join(different + [f"{len(ours)} hashes, {len(different)} differ"]))
    sys.exit(1 if different or not ours else 0)


main()
