#!/usr/bin/python3 -B
"""Hashes of what saddle writes, a line each, to prove that a change of the code changes no byte:
pictures, meshes, scenes and reports (without times and memory) of the gallery, of the examples and
of the surfaces of docs/STABILITY.md.

    hashes.py PROGRAM [WORD...]                    prints them, or those whose name has a WORD
    hashes.py PROGRAM --against OTHER [WORD...]    runs both programs, prints what differs"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
KINDS = ("png", "ply", "toml", "json")
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


def content(path, kind):
    data = path.read_bytes()
    if kind != "json":
        return data
    report = json.loads(data)
    for key in VOLATILE:
        report.pop(key, None)
    return json.dumps(report, sort_keys=True).encode()


def hashes(program, name, arguments):
    """Lines of one case. What is not written has the exit status in place of a hash; messages
    count, too."""
    with tempfile.TemporaryDirectory() as folder:
        files = {kind: pathlib.Path(folder) / f"out.{kind}" for kind in KINDS}
        command = [program, *arguments, "-s", SIZE, "--report", str(files["json"])]
        for kind in ("png", "ply", "toml"):
            command += ["-o", str(files[kind])]
        run = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL,
                             check=False)
        lines = [f"{hashlib.sha256(run.stderr.encode()).hexdigest()[:16]} said {name}"]
        for kind, path in files.items():
            found = hashlib.sha256(content(path, kind)).hexdigest()[:16] if path.exists() else None
            lines.append(f"{found or f'exit {run.returncode}':16} {kind} {name}")
        return lines


def all_hashes(program, words):
    cases = {**gallery(program), **examples(), **stability()}
    wanted = {n: a for n, a in cases.items() if not words or any(word in n for word in words)}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = pool.map(lambda case: hashes(program, *case), wanted.items())
        return [line for lines in found for line in lines]


def main():
    program, *words = sys.argv[1:]
    if words[:1] != ["--against"]:
        print("\n".join(all_hashes(program, words)))
        return
    ours, theirs = (all_hashes(each, words[2:]) for each in (program, words[1]))
    different = [line for line in ours if line not in set(theirs)]
    print("\n".join(different + [f"{len(ours)} hashes, {len(different)} differ"]))
    sys.exit(1 if different or not ours else 0)


main()
