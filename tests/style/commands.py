#!/usr/bin/python3 -B
"""The commands of the pages work. Each `sh` block of a page runs in the page's own folder, and each
file that an -o names must be there and begin as its extension asks. A `toml NAME` block is that file.
A `sh window` block opens windows: without a display, nothing but the display may be missing.
`sh fails`: the command ends with status 2. A `text` block right below is the output of the commands
above. A `sh build` block is not run. Pictures of the page that its commands make must be those that
it shows; --write replaces these. The program is $SADDLE_PROGRAM."""
import concurrent.futures
import os
import pathlib
import re
import shlex
import shutil
import stat
import struct
import subprocess
import sys
import tempfile

import markdown
import tree

PAGES = ["README.md", *(f"docs/{name}.md" for name in ("TUTORIAL", "COOKBOOK", "FAQ", "COLORS", "PAGES", "SCENES",
                                                        "VIEWER", "REPORT", "LANGUAGE",
                                                        "GALLERY", "FORMATS"))]
PICTURES = ["docs/tutorial", "docs/cookbook"]  # folders that hold nothing but what commands make
USUAL_SIZE = (800, 600)
SMALL = "400x300"  # the size in which pages show pictures of the usual size: short files
MAGIC = {".png": b"\x89PNG\r\n\x1a\n", ".ply": b"ply\n", ".stl": b"", ".obj": b"#", ".glb": b"glTF",
         ".3mf": b"PK\x03\x04", ".gif": b"GIF89a", ".mp4": b"\0\0\0", ".webm": b"\x1a\x45\xdf\xa3",
         ".html": b"<", ".svg": b"<", ".pdf": b"%PDF-", ".toml": b"", ".csv": b""}
USAGE = 2  # the exit status of a mistake in what was typed

# The program; its arguments are kept in the file `runs`.
SADDLE = f"""#!/bin/bash
printf '%s\\n' "${{*@Q}}" >>"$RUNS"
exec {shlex.quote(os.path.abspath(tree.program()))} "$@"
"""
# ./dev run is the program; other commands are only looked up.
DEV = f"""#!/bin/bash
if [[ $1 == run ]]; then exec saddle "${{@:2}}"; fi
{shlex.quote(str(tree.ROOT / "dev"))} help | grep -q "^  $1\\b" || {{ echo "./dev help has no $1"; exit 1; }}
"""


def size_of(picture):
    """The width and height of a PNG; None of other files."""
    data = picture.read_bytes()
    return struct.unpack(">II", data[16:24]) if data.startswith(MAGIC[".png"]) else None


class Folder:
    """Where the commands of one page are run."""

    def __init__(self, page, path):
        self.page = page
        self.path = pathlib.Path(path)
        self.bin = self.path / ".bin"
        self.bin.mkdir()
        for file, text in ((self.bin / "saddle", SADDLE), (self.path / "dev", DEV)):
            file.write_text(text, encoding="utf-8")
            file.chmod(stat.S_IRWXU)
        (self.path / "examples").symlink_to(tree.ROOT / "examples")

    def shell(self, script):
        """Runs a script in bash, without a display."""
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        environment |= {"PATH": f"{self.bin}:{os.environ['PATH']}", "RUNS": str(self.bin / "runs")}
        return subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=self.path, text=True,
                              capture_output=True, env=environment)

    def made(self, failed):
        """What is wrong with the files that the program was to make since this was last called."""
        runs = self.bin / "runs"
        lines = runs.read_text(encoding="utf-8").splitlines() if runs.exists() else []
        runs.unlink(missing_ok=True)
        for words in map(shlex.split, lines):
            for option, name in zip(words, words[1:]):
                if option in ("-o", "--output") and name != "-":
                    files = sorted(self.path.glob(re.sub(r"%\d*d", "*", name)))
                    if failed:
                        if files:
                            yield f"{self.page}: {shlex.join(words)}: failed, and wrote {name}"
                        continue
                    begin = MAGIC[pathlib.Path(name).suffix]
                    if not files or not all(file.read_bytes().startswith(begin) for file in files):
                        yield f"{self.page}: {shlex.join(words)}: {name} is not what it says"

    def run(self, script, status=0, output=None):
        """Runs a block; what it complains about."""
        done = self.shell(script)
        if done.returncode != status:
            yield f"{self.page}: status {done.returncode}: {script}{done.stderr}"
        if output is not None and done.stdout + done.stderr != output:
            yield f"{self.page}: {script}prints\n{done.stdout}{done.stderr}"
        yield from self.made(failed=status != 0)

    def run_windows(self, script):
        """Runs a block whose commands open windows, line by line."""
        for line in filter(None, script.splitlines()):
            done = self.shell(line)
            told = "no window can be opened" if shlex.split(line, comments=True)[1:] else "no surface given"
            if not done.returncode or told not in done.stderr:
                yield f"{self.page}: {line}: opens no window: {done.stderr}"

    def looks_like(self, made, shown):
        """Whether two pictures look the same: another processor may round otherwise. Films are not
        compared, as another ffmpeg packs them otherwise."""
        if made.suffix != ".png" or made.read_bytes() == shown.read_bytes():
            return True
        shutil.copy(shown, self.path / "shown.png")
        return not self.shell(f"saddle {made.name} --reference shown.png").returncode

    def compare(self):
        """What is wrong with the page's pictures that its commands have made."""
        text = markdown.read(self.page)
        for link in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text):
            shown = (tree.ROOT / self.page).parent / link
            made = self.path / shown.name
            if not made.exists():
                if str(pathlib.Path("docs", link).parent) in PICTURES:
                    yield f"{self.page}: no command makes {link}"
                continue
            if size_of(made) == USUAL_SIZE:
                self.shell(f"saddle {made.name} -q -s {SMALL} -o small-{made.name}")
                made = self.path / f"small-{made.name}"
            if "--write" in sys.argv[1:]:
                shown.parent.mkdir(exist_ok=True)
                shutil.copy(made, shown)
            elif not shown.exists() or not self.looks_like(made, shown):
                yield f"{self.page}: {link} is not what the command draws; run commands.py --write"


def complaints(page):
    """Runs a page; how many blocks it has, and what is wrong."""
    text = markdown.read(page)
    count, wrong = 0, []
    with tempfile.TemporaryDirectory() as path:
        folder = Folder(page, path)
        for found in markdown.FENCE.finditer(text):
            info, block = found.groups()
            if info in ("sh", "sh fails"):
                below = markdown.FENCE.match(text, found.end())
                output = below[2] if below and below[1] == "text" else None
                wrong += folder.run(block, USAGE if info == "sh fails" else 0, output)
            elif info == "sh window":
                wrong += folder.run_windows(block)
            elif info.startswith("toml "):
                (folder.path / info.split()[1]).write_text(block, encoding="utf-8")
            count += info.startswith("sh")
        wrong += folder.compare()
    return count, wrong


def unused():
    """Pictures of commands that no page shows."""
    shown = "".join(markdown.read(page) for page in PAGES)
    for file in tree.files(*PICTURES):
        if f"{file.parent.name}/{file.name}" not in shown:
            yield f"{file}: no page shows it"


def dev_complaints():
    """Commands of ./dev that its help has and it lacks, or the other way round."""
    text = (tree.ROOT / "dev").read_text(encoding="utf-8")
    told = set(re.findall(r"^  ([a-z]+)\b", text[text.index("usage: ./dev"):text.index("\nTEXT")], re.M)) - {"help"}
    has = set(re.findall(r"^cmd_([a-z]+)\(\)", text, re.M))
    for name in sorted(told ^ has):
        yield f"dev: {name} is {'no command' if name in told else 'not in the help'}"
    done = subprocess.run([tree.ROOT / "dev", "nonsense"], capture_output=True, text=True)
    if done.returncode != USAGE or "unknown command 'nonsense'" not in done.stderr:
        yield "dev: an unknown command is not refused"


with concurrent.futures.ThreadPoolExecutor(2) as pool:
    results = list(pool.map(complaints, PAGES))
tree.finish([*(line for _, wrong in results for line in wrong), *unused(), *dev_complaints()],
            sum(count for count, _ in results), "blocks of commands")
