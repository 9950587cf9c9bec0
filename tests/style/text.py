#!/usr/bin/python3 -B
"""Text files have no tabs, no blanks at the end of a line, and end in one newline. Files that grow
past the guide of 400 lines are named, without failing."""
import tree

GUIDE = 400
TEXT = {"", ".cmake", ".cpp", ".def", ".glsl", ".h", ".json", ".md", ".py", ".supp", ".toml", ".txt"}


def complaints(name):
    data = (tree.ROOT / name).read_bytes()
    if not data:
        yield f"{name}: empty"
        return
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        yield f"{name}: not UTF-8: {error}"
        return
    for number, line in enumerate(text.split("\n"), start=1):
        if "\t" in line or "\r" in line:
            yield f"{name}:{number}: a tab or carriage return"
        if line != line.rstrip():
            yield f"{name}:{number}: blanks at the end of the line"
    if not text.endswith("\n") or text.endswith("\n\n"):
        yield f"{name}: does not end in exactly one newline"


at_top = [path.relative_to(tree.ROOT) for path in tree.ROOT.iterdir() if path.is_file()]
texts = [name for name in [*at_top, *tree.files(*tree.FOLDERS)] if name.suffix in TEXT]
for source in texts:
    length = len((tree.ROOT / source).read_bytes().splitlines())
    if source.suffix in {".h", ".cpp"} and length > GUIDE:
        print(f"warning: {source} has {length} lines; the guide is {GUIDE}")
tree.finish((c for name in texts for c in complaints(name)), len(texts), "text files")
