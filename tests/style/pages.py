#!/usr/bin/python3 -B
"""Links of the Markdown pages lead to files and headings that exist, pictures exist and are
described, README leads to every page, files that pages name exist, blocks of code are closed, named
and well-formed, and entries of the changelog are short."""
import re
import subprocess
import tomllib

import markdown
import tree

LANGUAGES = {"sh", "text", "toml", "cpp", "html", "mermaid"}
KINDS = {"sh": {"", "window", "fails", "build"}}  # what may follow the language
ENTRY = 3  # lines of an entry of the changelog
LINK = re.compile(r"(!?)\[((?:[^\[\]]|!\[[^\]]*\]\([^)]*\))*)\]\(([^)\s]+)\)")


def link_complaints(page, linked):
    """What is wrong with the links of a page; adds the pages that it leads to."""
    text = markdown.without_code(markdown.read(page))
    for picture, words, target in LINK.findall(text):
        if re.match(r"https?:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (tree.ROOT / page.parent / path).resolve() if path else tree.ROOT / page
        if not file.is_relative_to(tree.ROOT) or not file.exists():
            yield f"{page}: {target} does not exist"
            continue
        if picture and not words.strip():
            yield f"{page}: {target} has no description"
        if anchor and anchor not in markdown.anchors(file.read_text(encoding="utf-8")):
            yield f"{page}: {target}: there is no such heading"
        if file.suffix == ".md":
            linked.setdefault(page, set()).add(file.relative_to(tree.ROOT))


def path_complaints(page):
    """Files and folders of the project that a page names as code, and that are not there."""
    of_code = page.parts[0] == "src"  # its pages name files from their own folder on
    folders = r"[a-z.]+" if of_code else r"\.ci|cmake|docs|examples|shaders|src|tests"
    starts = [tree.ROOT, tree.ROOT / page.parent]
    for path in re.findall(rf"`((?:{folders})/[a-z0-9_./-]+)`", markdown.read(page)):
        if not any((start / path).exists() or any(start.glob(f"{path}.*")) for start in starts):
            yield f"{page}: {path} does not exist"


def block_complaints(page):
    """What is wrong with the fenced blocks of a page."""
    text = markdown.read(page)
    if markdown.FENCE.sub("", text).count("\n```"):
        yield f"{page}: a block of code is not closed"
    for info, block in markdown.FENCE.findall(text):
        language, _, rest = info.partition(" ")
        if language not in LANGUAGES or (language in KINDS and rest not in KINDS[language]):
            yield f"{page}: nobody knows a block of '{info}'"
        elif language == "sh":
            done = subprocess.run(["bash", "-n"], input=block, capture_output=True, text=True)
            if done.returncode:
                yield f"{page}: {done.stderr.strip()}"
        elif language == "mermaid":
            for word in re.findall(r"\b(graph|end|class|click|style|default)(?=\[| *-->|$)", block, flags=re.MULTILINE):
                yield f"{page}: '{word}' is no name of a box in Mermaid"
        elif language == "toml":
            try:
                tomllib.loads(block)
            except tomllib.TOMLDecodeError as error:
                yield f"{page}: {error} in a block of TOML"


def changelog_complaints():
    """Entries of the changelog that tell more than one thing."""
    for entry in re.findall(r"^- .*\n(?:  .*\n)*", markdown.read("CHANGELOG.md"), flags=re.MULTILINE):
        if entry.count("\n") > ENTRY:
            yield f"CHANGELOG.md: more than {ENTRY} lines: {entry.splitlines()[0]}"


def unreached(linked, pages):
    """Pages that no links lead to from README.md."""
    reached, waiting = set(), [page for page in pages if str(page) == "README.md"]
    while waiting:
        page = waiting.pop()
        if page not in reached:
            reached.add(page)
            waiting += linked.get(page, ())
    for page in pages:
        if page not in reached:
            yield f"{page}: README.md does not lead to it"


found = markdown.pages()
links = {}
complaints = [line for page in found for check in (link_complaints(page, links), path_complaints(page), block_complaints(page))
              for line in check]
tree.finish([*complaints, *changelog_complaints(), *unreached(links, found)], len(found), "Markdown pages")
