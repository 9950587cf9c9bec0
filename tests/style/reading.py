#!/usr/bin/python3 -B
"""How hard the pages are to read: words in a sentence (median, longest), the share of sentences of
more than 25 words, and the grade of Flesch and Kincaid, in years of school. It reports and never
fails. Usage: reading.py [REVISION]: the pages as they are, or as they were in a revision of git."""
import re
import statistics
import subprocess
import sys

import markdown
import tree

LONG = 25  # words: more than that is hard to follow


def prose(text):
    """The paragraphs and list items of a page, without headings, tables, code and marks."""
    text = re.sub(r"<!--.*?-->", "", markdown.without_code(text), flags=re.DOTALL)
    text = re.sub(r"!\[[^\]]*\]\([^)]*\)", "", text)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    lines = ["" if re.match(r"#|\|| *<", line) else line for line in text.splitlines()]
    lines = [re.sub(r"^ *(?:[-*]|\d+\.) ", "\n", line).replace("*", "") for line in lines]
    return [" ".join(part.split()) for part in re.split(r"\n\s*\n", "\n".join(lines)) if part.strip()]


def sentences(text):
    """The sentences of a page, each a list of words."""
    for paragraph in prose(text):
        for sentence in re.split(r"(?<=[.!?])(?<!\b[A-Z]\.)[)\"']*\s+", paragraph):
            words = re.findall(r"[^\W_][\w'’.,/+-]*", sentence)
            if words:
                yield words


def syllables(word):
    """About how many syllables an English word has: its groups of vowels, without a silent e."""
    groups = len(re.findall(r"[aeiouy]+", re.sub(r"(?<=[^aeiouyl])e$", "", word.lower())))
    return max(groups, 1)


def old(page, revision):
    """A page as it was; empty if it was not there."""
    done = subprocess.run(["git", "show", f"{revision}:{page}"], cwd=tree.ROOT, capture_output=True)
    return done.stdout.decode("utf-8")


print(f"{'page':24} sentences  median  longest  over {LONG}  grade")
for page in markdown.pages():
    found = list(sentences(old(page, sys.argv[1]) if sys.argv[1:] else markdown.read(page)))
    if not found:
        continue
    lengths = [len(words) for words in found]
    words = [word for sentence in found for word in sentence]
    # J. P. Kincaid et al., Derivation of new readability formulas for Navy enlisted personnel, 1975
    grade = 0.39 * statistics.mean(lengths) + 11.8 * statistics.mean(map(syllables, words)) - 15.59
    over = 100 * sum(length > LONG for length in lengths) / len(lengths)
    print(f"{str(page):24} {len(found):9} {statistics.median(lengths):7.0f} {max(lengths):8} "
          f"{over:5.0f} % {grade:6.1f}")
