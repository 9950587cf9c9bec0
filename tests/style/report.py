#!/usr/bin/python3 -B
"""docs/REPORT.md has the keys that reports have, each with its type, and no other; the reasons that
src/mesh/model/proof_gap.cpp gives; and the kinds of src/meshing/findings.cpp. The program is
$SADDLE_PROGRAM, or build/release/saddle."""
import json
import pathlib
import re
import subprocess
import tempfile

import tree

PAGE = "docs/REPORT.md"
SOURCE = "src/mesh/model/proof_gap.cpp"
KINDS_SOURCE = "src/meshing/findings.cpp"
# Between them these runs have everything that a report may have.
RUNS = [
    ["z=1/u+sign(v-0.1)", "-s", "40x30", "-o", "picture.png"],
    ["z=u*v*t", "t=0:1", "-s", "40x30", "--frames", "2", "-o", "frame-%d.png"],
    ["check", "sphere"],
    ["torus", "+", "curve", "u=s", "v=1", "s=0:tau", "+", "curve", "x=s", "y=1/s+sign(s-0.5)", "s=-1:1",
     "+", "point", "1,2,3", "-s", "40x30", "-o", "curves.png"],
    ["check", "cone-double"],
    ["check", "whitney-umbrella"],
    ["check", "pillow"],
    ["check", "x=cos(v)", "y=cos(u)", "z=0.5*sin(u)*sin(v)", "u=-pi:pi", "v=0:pi"],
    ["check", "z=sqrt(1-u^2-v^2)"],
    ["check", "cylinder", "--samples", "9x9"],
    ["check", "torus", "--thickness", "0.1"],
    ["z=u", "--thickness", "0.1", "-o", "solid.ply"],
    ["z=sin(9*u*v)", "--max-triangles", "500", "-o", "mesh.ply"],
]
REASON_TEXT = re.compile(r'GapText\{"([a-z ]+)",\s*"(.+)"\},$', re.M)
KIND_NAMES = re.compile(r"kNames = \{(.*?)\};", re.S)


def type_name(value):
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "boolean"
    kinds = {int: "integer", float: "number", str: "string", list: "list", dict: "object"}
    return kinds[type(value)]


def found_in(value, key=""):
    """Each key of an object and of what is in it, with its value."""
    if isinstance(value, dict):
        for name, inner in value.items():
            path = f"{key}.{name}" if key else name
            yield path, inner
            yield from found_in(inner, path)
    elif isinstance(value, list):
        for inner in value:
            yield from found_in(inner, key + "[]")


def report_of(arguments, folder):
    """What a run in the folder reports; warnings are not of interest."""
    run = subprocess.run([pathlib.Path(tree.program()).resolve(), *arguments, "-q", "--report", "-"],
                         cwd=folder, capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def documented():
    """Of the page's tables: the types of each key, the text of each reason, and the kinds."""
    types, reasons, kinds = {}, {}, set()
    heading = ""  # of the table's first column
    for _, line in tree.lines(PAGE):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        names = re.findall(r"`([^`]*)`", cells[0])
        if not line.startswith("|"):
            continue
        if not names:
            heading = cells[0] if cells[0].strip("- ") else heading
        elif heading == "reason":
            reasons[names[0]] = cells[1].replace("`", "")
        elif heading == "kind":
            kinds.update(names)
        else:
            types.update({name: set(cells[1].split(" or ")) for name in names})
    return types, reasons, kinds


def source(path):
    return (tree.ROOT / path).read_text(encoding="utf-8")


def complaints(types, reasons, kinds, reports):
    seen = set()
    for key, value in (pair for report in reports for pair in found_in(report)):
        seen.add(key)
        kind = type_name(value)
        if key not in types:
            yield f"{PAGE} does not have {key}"
        elif kind not in types[key] and not (kind == "integer" and "number" in types[key]):
            yield f"{PAGE}: {key} is {kind} in a report"
    yield from (f"{PAGE}: no report has {key}" for key in sorted(types.keys() - seen))
    if reasons != dict(REASON_TEXT.findall(source(SOURCE))):
        yield f"{PAGE} does not have the reasons of {SOURCE}"
    if kinds != set(re.findall(r'"(.*?)"', KIND_NAMES.search(source(KINDS_SOURCE))[1])):
        yield f"{PAGE} does not have the kinds of {KINDS_SOURCE}"


with tempfile.TemporaryDirectory() as scratch:
    made = [report_of(arguments, scratch) for arguments in RUNS]
keys, *names = documented()
tree.finish(sorted(set(complaints(keys, *names, made))), len(keys), "keys")
