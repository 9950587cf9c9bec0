"""Figures as other programs draw them, against saddle's picture. Usage: figure_test.py PROGRAM"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from browser import skip
from compare import difference, numpy, read

SCENES = {
    "torus": ["torus", "--axes", "--title", "A torus", "--color", "gauss"],
    "ink": ["z=sin(3*x)*y", "--theme", "paper", "--contours", "z"],
    "curve": ["torus", "+", "curve", "x=3*cos(s)", "y=3*sin(s)", "z=sin(3*s)", "s=0:tau"],
    "clear": ["sphere", "--background", "transparent"],
}
# Other programs smooth edges their own way: what is shaded alike is within this of saddle's.
MOST_LEVELS = 24
# Lines and letters are there, and where saddle has them, if so little of the picture differs much.
MOST_SHARE = 0.02
MUCH = 100

program = sys.argv[1]
failed = False
for tool, package in (("rsvg-convert", "librsvg2-bin"), ("pdftoppm", "poppler-utils"), ("qpdf", "qpdf")):
    if not shutil.which(tool):
        skip(f"no {tool}; apt-get install {package}")

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else name)
    for scene, words in SCENES.items():
        base = str(folder / f"figure-{scene}")
        subprocess.run([program, *words, "-q", "--size", "640x480", "-o", base + ".svg", "-o",
                        base + ".pdf", "-o", base + ".png"], check=True)
        subprocess.run(["qpdf", "--check", base + ".pdf"], check=True, stdout=subprocess.DEVNULL)
        color = "black" if scene == "clear" else "white"
        subprocess.run(["rsvg-convert", "-b", color, base + ".svg", "-o", base + "-svg.png"], check=True)
        subprocess.run(["pdftoppm", "-r", "96", "-png", "-singlefile", base + ".pdf", base + "-pdf"],
                       check=True)
        expected = read(base + ".png")
        for kind in ("svg", "pdf"):
            if scene == "clear" and kind == "pdf":
                continue  # on white paper
            drawn = read(f"{base}-{kind}.png")
            apart = (abs(drawn - expected).max(axis=2) > MUCH).mean()
            background = tuple(int(level) for level in expected[0, 0])
            most, mean, share = difference(drawn, expected, background)
            print(f"{scene}.{kind}: {most} levels inside, mean {mean:.2f}; {apart:.2%} differ much")
            failed |= most > MOST_LEVELS or apart > MOST_SHARE
            scenes = [subprocess.run([program, file, "-o", "-", "--format", "toml"], check=True,
                                     capture_output=True).stdout
                      for file in (f"{base}.{kind}", base + ".png")]
            if scenes[0] != scenes[1]:
                print(f"{scene}.{kind} holds another scene")
                failed = True
sys.exit(1 if failed else 0)
