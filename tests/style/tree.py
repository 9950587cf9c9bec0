"""What the style tests share: the files of the project, and how a test ends."""
import os
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


def program():
    """The saddle that a test runs."""
    return os.environ.get("SADDLE_PROGRAM", str(ROOT / "build/release/saddle"))


def check_page(page, source, body):
    """The page's part between its marks is `body`, which `source` made. With --write, makes it so."""
    path = ROOT / page
    script = pathlib.Path(sys.argv[0]).name
    begin = f"<!-- begin: made by tests/style/{script} from {source} -->\n"
    end = "<!-- end -->"
    text = path.read_text(encoding="utf-8")
    before, mark, rest = text.partition(begin)
    after = rest.partition(end)[2]
    wanted = before + begin + "\n" + body + end + after
    if "--write" in sys.argv[1:]:
        path.write_text(wanted if mark else text + begin + end, encoding="utf-8")
    elif text != wanted:
        yield f"{page} is not what {source} says; run tests/style/{script} --write"


def finish(complaints, checked, what):
    """Ends the test. Nothing to check is a failure too: the test has lost what it looks at."""
    complaints = list(complaints)
    for complaint in complaints:
        print(complaint)
    print(f"{checked} {what}, {len(complaints)} complaints")
    sys.exit(1 if complaints or not checked else 0)
