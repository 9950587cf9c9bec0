#!/usr/bin/python3 -B
"""docs/GALLERY.md shows every surface of saddle list with its golden picture. With --write, makes
it so. The program is $SADDLE_PROGRAM, or build/release/saddle."""
import subprocess
import tomllib

import tree

COLUMNS = 3


def run(*arguments):
    return subprocess.run([tree.program(), *arguments], capture_output=True, text=True,
                          check=True).stdout


def parameters(name):
    """NAME=VALUE of the plain numbers among a surface's parameters."""
    for parameter, value in tomllib.loads(run("show", name)).get("params", {}).items():
        if isinstance(value, (int, float)):
            yield f"{parameter}={value}"


def cell(name, description):
    picture = f"![{name}](../tests/golden/gallery-{name}.png)"
    text = description.replace("|", "\\|").replace("*", "\\*")
    code = " ".join(f"`{parameter}`" for parameter in parameters(name))
    return "<br>".join(part for part in (picture, f"**{name}**", text, code) if part)


def table(entries):
    yield "| " * COLUMNS + "|\n" + "| --- " * COLUMNS + "|\n"
    for start in range(0, len(entries), COLUMNS):
        row = [cell(*entry) for entry in entries[start:start + COLUMNS]]
        yield "| " + " | ".join(row + [""] * (COLUMNS - len(row))) + " |\n"
    yield "\n"


def complaints(entries):
    for name, _ in entries:
        if not (tree.ROOT / f"tests/golden/gallery-{name}.png").is_file():
            yield f"{name} has no golden picture"
    yield from tree.check_page("docs/GALLERY.md", "saddle list", "".join(table(entries)))


entries = [line.split(maxsplit=1) for line in run("list", "--verbose").splitlines()]
tree.finish(complaints(entries), len(entries), "surfaces")
