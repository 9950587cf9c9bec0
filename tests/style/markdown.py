"""What the tests of Markdown pages share: which pages there are, their blocks and their prose."""
import re

import tree

FENCE = re.compile(r"^```(.*)\n((?:.*\n)*?)```\n", flags=re.MULTILINE)


def pages():
    """All Markdown pages, as paths from the project's root."""
    at_top = sorted(path.relative_to(tree.ROOT) for path in tree.ROOT.glob("*.md"))
    return [*at_top, *(name for name in tree.files(*tree.FOLDERS) if name.suffix == ".md")]


def read(name):
    return (tree.ROOT / name).read_text(encoding="utf-8")


def without_code(text):
    """The page without its blocks of code, and with an x for code within lines."""
    text = FENCE.sub("\n", text)
    text = re.sub(r"^\n( {4}.*\n)+", "\n", text, flags=re.MULTILINE)
    return re.sub(r"(`+)(?!`).+?(?<!`)\1(?!`)", "x", text)


def anchors(text):
    """The names that forges give to the headings of a page."""
    seen, names = {}, set()
    for heading in re.findall(r"^#{1,6} (.*)$", FENCE.sub("\n", text), flags=re.MULTILINE):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
        name = re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")
        count = seen.get(name, 0)
        seen[name] = count + 1
        names.add(f"{name}-{count}" if count else name)
    return names
