#!/usr/bin/python3 -B
"""Comments of src/ are plain: no sentence opens with a pronoun that stands for the subject, and no
cell, caller or file is a person."""
import re

import tree

COMMENT = re.compile(r"^\s*(//[/!]?<?)\s?(.*)$|\s//[/!]?<? (.*)$")
OPENING = re.compile(r"(?:^|[.:] )(What|Whoever|Of|Those|Nor) ")
PERSONS = re.compile(r"\b(nobody|somebody|anybody|whoever)\b", re.IGNORECASE)


def comments(name):
    """Each comment with the number of its first line: adjacent lines of comments are one."""
    block, first = [], 0
    for number, line in tree.lines(name):
        match = COMMENT.search(line)
        text = match and (match[2] if match[1] else match[3])
        if text is not None and match[1] and block:
            block.append(text)
            continue
        if block:
            yield first, " ".join(block)
        block, first = ([text], number) if text is not None else ([], 0)
        if block and not match[1]:
            yield first, block[0]
            block = []
    if block:
        yield first, " ".join(block)


def complaints(name):
    for number, text in comments(name):
        if match := OPENING.search(text):
            yield f"{name}:{number}: a sentence opens with '{match[1]}'; put its subject first"
        if match := PERSONS.search(text):
            yield f"{name}:{number}: '{match[1]}': name the part of the program that does it"


sources = [name for name in tree.files("src") if name.suffix in {".h", ".cpp", ".def"}]
tree.finish((c for name in sources for c in complaints(name)), len(sources), "sources")
