#!/usr/bin/python3 -B
"""The table of keys in docs/VIEWER.md is that of saddle --help keys. With --write, makes it so.
The program is $SADDLE_PROGRAM, or build/release/saddle."""
import os
import subprocess
import sys

import tree

PAGE = tree.ROOT / "docs/VIEWER.md"
BEGIN = "<!-- begin: made by tests/style/viewer.py from saddle --help keys -->\n"
END = "<!-- end -->"


def complaints(page, wanted):
    if page != wanted:
        yield "docs/VIEWER.md is not what saddle --help keys says; run tests/style/viewer.py --write"


program = os.environ.get("SADDLE_PROGRAM", str(tree.ROOT / "build/release/saddle"))
printed = subprocess.run([program, "--help", "keys"], capture_output=True, text=True,
                         check=True).stdout
rows = [line.split(maxsplit=1) for line in printed.splitlines()]
table = "| | |\n| --- | --- |\n" + "".join(f"| `{key}` | {meaning} |\n" for key, meaning in rows)
page = PAGE.read_text(encoding="utf-8")
before, _, rest = page.partition(BEGIN)
after = rest.partition(END)[2]
wanted = before + BEGIN + "\n" + table + "\n" + END + after
if "--write" in sys.argv[1:]:
    PAGE.write_text(wanted, encoding="utf-8")
    page = wanted
tree.finish(complaints(page, wanted), len(rows), "keys")
