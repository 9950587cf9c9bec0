#!/usr/bin/python3 -B
"""The tables of docs/LANGUAGE.md are those of saddle --help functions. With --write, makes them so.
The program is $SADDLE_PROGRAM, or build/release/saddle."""
import os
import subprocess
import sys

import tree

PAGE = tree.ROOT / "docs/LANGUAGE.md"
BEGIN = "<!-- begin: made by tests/style/language.py from saddle --help functions -->\n"
END = "<!-- end -->"
UPDATE = "tests/style/language.py --write"


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


def complaints(page, wanted):
    if page != wanted:
        yield f"docs/LANGUAGE.md is not what saddle --help functions says; run {UPDATE}"


program = os.environ.get("SADDLE_PROGRAM", str(tree.ROOT / "build/release/saddle"))
printed = subprocess.run([program, "--help", "functions"], capture_output=True, text=True,
                         check=True).stdout
page = PAGE.read_text(encoding="utf-8")
before, _, rest = page.partition(BEGIN)
after = rest.partition(END)[2]
wanted = before + BEGIN + "\n" + "".join(tables(printed)) + END + after
if "--write" in sys.argv[1:]:
    PAGE.write_text(wanted, encoding="utf-8")
    page = wanted
tree.finish(complaints(page, wanted), printed.count("\n"), "lines of help")
