#!/usr/bin/python3 -B
"""docs/FORMATS.md has the table of `saddle --help formats`. With --write, makes it so. The program is
$SADDLE_PROGRAM, or build/release/saddle."""
import subprocess

import tree

FORMATS = 3  # at least, or the help is not what this reads


def rows():
    """Cells of the help's table, the head first."""
    text = subprocess.run([tree.program(), "--help", "formats"], capture_output=True, text=True,
                          check=True).stdout
    lines = [line.split() for line in text.split("\n\n")[1].splitlines()]
    columns = len(lines[0]) - 1
    yield ["", *lines[0]]
    for words in lines[1:]:
        yield [f"`{words[0]}`", *words[1:columns + 1], " ".join(words[columns + 1:])]


def markdown(table):
    lines = [table[0], ["---"] * len(table[0]), *table[1:]]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines) + "\n"


table = list(rows())
assert len(table) > FORMATS
tree.finish(tree.check_page("docs/FORMATS.md", "saddle --help formats", markdown(table)), len(table),
            "formats")
