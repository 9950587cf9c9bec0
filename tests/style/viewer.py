#!/usr/bin/python3 -B
"""The table of gestures and keys in docs/VIEWER.md is that of saddle --help keys. With --write, makes it so.
The program is $SADDLE_PROGRAM, or build/release/saddle."""
import subprocess

import tree

printed = subprocess.run([tree.program(), "--help", "keys"], capture_output=True, text=True,
                         check=True).stdout
COLUMN = 14  # where the second column begins; names of gestures have two words
rows = [(line[:COLUMN].strip(), line[COLUMN:]) for line in printed.splitlines()]
table = "| | |\n| --- | --- |\n" + "".join(f"| `{key}` | {meaning} |\n" for key, meaning in rows)
tree.finish(tree.check_page("docs/VIEWER.md", "saddle --help keys", table + "\n"), len(rows), "keys")
