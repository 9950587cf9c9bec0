#!/usr/bin/python3 -B
"""The commands of README.md work: ./dev knows its commands, what `./dev run` is shown with makes
the files that it names, and linked files exist. The program is $SADDLE_PROGRAM."""
import os
import pathlib
import re
import shlex
import subprocess
import tempfile

import tree

TEXT = (tree.ROOT / "README.md").read_text(encoding="utf-8")
PROGRAM = os.path.abspath(os.environ["SADDLE_PROGRAM"])
MAGIC = {".png": b"\x89PNG\r\n\x1a\n", ".ply": b"ply\n", ".toml": b"", ".gif": b"GIF89a",
         ".3mf": b"PK\x03\x04", ".glb": b"glTF",
         ".html": b"<!DOCTYPE html>", ".svg": b"<?xml", ".pdf": b"%PDF-"}  # how a file starts


def commands():
    """The lines that start with ./dev in the indented or fenced blocks of README.md."""
    for line in TEXT.splitlines():
        if re.match(r"\s*(\$ )?\./dev ", line):
            yield shlex.split(line.strip().removeprefix("$ "), comments=True)


def run_complaints(arguments, folder):
    """Runs the program with the arguments of `./dev run`, where earlier commands left their files."""
    done = subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        yield f"README.md: saddle {shlex.join(arguments)}: status {done.returncode}"
        yield done.stderr
        return
    for option, name in zip(arguments, arguments[1:]):
        if option == "-o":
            made = pathlib.Path(folder, name)
            if not made.is_file() or not made.read_bytes().startswith(MAGIC[made.suffix]):
                yield f"README.md: saddle {shlex.join(arguments)}: {name} is not what it says"


def complaints(found, folder):
    usage = subprocess.run([tree.ROOT / "dev", "help"], capture_output=True, text=True, check=True)
    known = re.findall(r"^  (\w+)", usage.stdout, flags=re.MULTILINE)
    for needed in ("run", "test"):
        if needed not in [command[1] for command in found]:
            yield f"README.md: does not show ./dev {needed}"
    for command in found:
        if command[1] not in known:
            yield f"README.md: ./dev help does not know {command[1]}"
        elif command[1] == "run":
            yield from run_complaints(command[2:], folder)
    for link in re.findall(r"\]\(([^):#]+)\)", TEXT):
        if not (tree.ROOT / link).exists():
            yield f"README.md: {link} does not exist"


shown = list(commands())
with tempfile.TemporaryDirectory() as folder:
    tree.finish(complaints(shown, folder), len(shown), "commands of README.md")
