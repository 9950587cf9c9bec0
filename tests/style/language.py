#!/usr/bin/python3 -B
"""The tables of docs/LANGUAGE.md are those of saddle --help functions. With --write, makes them so.
The program is $SADDLE_PROGRAM, or build/release/saddle."""
import subprocess

import tree


def tables(help_text):
    """Headings and their lines of "call   meaning", as tables."""
    for block in help_text.strip().split("\n\n"):
        heading, *lines = block.split("\n")
        yield f"## {heading}\n\n| | |\n| --- | --- |\n"
        for line in lines:
            call, meaning = line.strip().replace("|", "\\|").split(maxsplit=1)
            meaning = meaning.replace("*", "\\*").replace("<", "\\<")
            yield f"| `{call}` | {meaning} |\n"
        yield "\n"


printed = subprocess.run([tree.program(), "--help", "functions"], capture_output=True, text=True,
                         check=True).stdout
tree.finish(tree.check_page("docs/LANGUAGE.md", "saddle --help functions", "".join(tables(printed))),
            printed.count("\n"), "lines of help")
