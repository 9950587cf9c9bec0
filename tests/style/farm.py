#!/usr/bin/python3 -B
"""The commands of docs/FARM.md work, and pieces drawn apart are one run to the bit. GNU parallel and
sbatch are stood in for where they are not: what they run is what the page says. The program is
$SADDLE_PROGRAM; it draws small pictures here."""
import os
import pathlib
import re
import shutil
import stat
import subprocess
import tempfile

import tree

PAGE = "docs/FARM.md"
TEXT = (tree.ROOT / PAGE).read_text(encoding="utf-8")
PROGRAM = os.path.abspath(os.environ["SADDLE_PROGRAM"])
FRAMES = 72
STANDINS = {
    "saddle": f'#!/bin/sh\nexec "{PROGRAM}" "$@" -s 63x48 --samples 24x6\n',
    # A job for each line of input, two at a time; where it would run is left out.
    "parallel": """#!/bin/bash
while [[ $1 == --* ]]; do shift 2; done
job=$1 xargs -P 2 -I{} bash -c 'eval "${job//\\{\\}/{}}"'
""",
    "sbatch": """#!/bin/bash
range=$(sed -n 's/^#SBATCH --array=//p' "$1")
export SLURM_CPUS_PER_TASK=$(sed -n 's/^#SBATCH --cpus-per-task=//p' "$1")
for task in $(seq "${range%-*}" "${range#*-}"); do
  SLURM_ARRAY_TASK_ID=$task bash "$1" || exit
done
""",
}


def blocks(heading):
    """The shell blocks below a heading of the page."""
    part = TEXT.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    return re.findall(r"```sh\n(.*?)```", part, flags=re.DOTALL)


class Folder:
    """Where the page's commands are run."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.bin = self.path / "bin"
        self.bin.mkdir()
        for name, text in STANDINS.items():
            (self.bin / name).write_text(text, encoding="utf-8")
            (self.bin / name).chmod(stat.S_IRWXU)
        shutil.copy(tree.ROOT / "examples/knot.toml", self.path)

    def run(self, script):
        """Runs it in bash; what it complains about."""
        path = f"{self.bin}:{os.environ['PATH']}"
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=self.path, text=True,
                              capture_output=True, env={**os.environ, "PATH": path})
        return f"{PAGE}: status {done.returncode}: {script}\n{done.stderr}" if done.returncode else ""

    def take(self):
        """The frames' bytes by their names; they are gone then."""
        folder = self.path / "frames"
        frames = {file.name: file.read_bytes() for file in folder.iterdir()}
        shutil.rmtree(folder)
        return frames

    def length(self, film):
        """The number of a film's frames."""
        return subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames",
             "-of", "csv=p=0", film], cwd=self.path, capture_output=True, text=True,
            check=True).stdout.strip().strip(",")


def complaints(folder):
    one_run = "mkdir frames; saddle knot.toml -o frames/knot-%04d.png"
    yield folder.run(one_run)
    wanted = folder.take()
    if sorted(wanted) != [f"knot-{k:04d}.png" for k in range(FRAMES)]:
        yield f"{PAGE}: one run makes {len(wanted)} frames"
    here, machines = blocks("GNU parallel")
    sbatch, submit = blocks("A Slurm array")
    (folder.path / "knot.sbatch").write_text(sbatch, encoding="utf-8")
    for name, script in (("parallel", here), ("parallel --sshloginfile", "mkdir frames\n" + machines),
                         ("sbatch", submit)):
        yield folder.run(script)
        if folder.take() != wanted:
            yield f"{PAGE}: the frames of {name} are not those of one run"
    yield folder.run(submit)
    for lost in (0, 7, FRAMES - 1):
        (folder.path / f"frames/knot-{lost:04d}.png").unlink()
    yield folder.run(blocks("What is missing")[0])
    for script, film in zip(blocks("One film"), ("knot.mp4", "knot.gif")):
        yield folder.run(script)
        if (length := folder.length(film)) != str(FRAMES):
            yield f"{PAGE}: {film} has {length} frames"
    if folder.take() != wanted:
        yield f"{PAGE}: the frames that were missing are not those of one run"


with tempfile.TemporaryDirectory() as path:
    tree.finish(filter(None, complaints(Folder(path))), len(re.findall("```sh", TEXT)),
                f"blocks of {PAGE}")
