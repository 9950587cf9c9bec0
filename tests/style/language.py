#!/usr/bin/python3 -B
"""The tables of docs/LANGUAGE.md are those of saddle --help functions, and its commands work. With
--write, makes the tables so. The program is $SADDLE_PROGRAM, or build/release/saddle."""
import os
import re
import shlex
import subprocess
import tempfile

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


def complaints_of_commands():
    """The commands of the page that do not work. Those without a file write a mesh."""
    text = (tree.ROOT / "docs/LANGUAGE.md").read_text(encoding="utf-8")
    program = os.path.abspath(tree.program())
    with tempfile.TemporaryDirectory() as folder:
        for command in re.findall(r"^    saddle (.*)$", text, flags=re.MULTILINE):
            words = shlex.split(command)
            words += [] if "-o" in words else ["-o", "example.ply"]
            done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True)
            if done.returncode:
                yield f"docs/LANGUAGE.md: saddle {command}: status {done.returncode}\n{done.stderr}"


printed = subprocess.run([tree.program(), "--help", "functions"], capture_output=True, text=True,
                         check=True).stdout
tree.finish([*tree.check_page("docs/LANGUAGE.md", "saddle --help functions", "".join(tables(printed))),
             *complaints_of_commands()], printed.count("\n"), "lines of help")
