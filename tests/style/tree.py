"""What the style tests share: the files of the project, and how a test ends."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = [".ci", "cmake", "docs", "examples", "shaders", "src", "tests"]


def files(*folders):
    """All files below the folders, as paths from ROOT."""
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.is_file():
                yield path.relative_to(ROOT)


def lines(name):
    """The numbered lines of a text file."""
    return enumerate((ROOT / name).read_text(encoding="utf-8").splitlines(), start=1)


def finish(complaints, checked, what):
    """Ends the test. Nothing to check is a failure too: the test has lost what it looks at."""
    complaints = list(complaints)
    for complaint in complaints:
        print(complaint)
    print(f"{checked} {what}, {len(complaints)} complaints")
    sys.exit(1 if complaints or not checked else 0)
