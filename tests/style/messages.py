#!/usr/bin/python3 -B
"""Lists the messages of the program that no test of the command line provokes: `./dev messages`.
Exit 1 if there are any beside those of unprovoked.py, which has their reasons, or if a reason there
is of no message, or of one that is provoked.

The messages are the string literals of errors and warnings in src/. The tests of the command line
run with SADDLE_TOLD, and their runs add to that file what they say. A literal that never occurs
there is listed with its place."""
import os
import re
import subprocess
import sys
import tempfile

import tree
import unprovoked

# Calls whose texts are messages, and files whose sentences are.
CALL = re.compile(r"(?:\bError\(|\bError\{|\.error\(|name_error\(|return \{Status::|with_hint_line\()")
SENTENCES = ("meshing/findings.cpp", "meshing/mesh_numbers.cpp", "export/formats/losses.cpp",
             "app/report/formula_warnings.cpp")
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"(?:\s*"((?:[^"\\\n]|\\.)*)")*')
PIECE = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
LEAST_WORDS = 3


def without_comments(text):
    return re.sub(r"^\s*//.*$", lambda m: " " * len(m.group()), text, flags=re.M)


def call_end(text, begin):
    """The end of the brackets that open before `begin`."""
    depth = 1
    quoted = False
    at = begin
    while at < len(text) and depth:
        c = text[at]
        if quoted:
            if c == "\\":
                at += 1
            elif c == '"':
                quoted = False
        elif c == '"':
            quoted = True
        elif c in "({":
            depth += 1
        elif c in ")}":
            depth -= 1
        at += 1
    return at


def messages(text, all_of_it):
    """Pairs of a line's number and the words of a literal."""
    spans = [(0, len(text))] if all_of_it else [
        (m.end(), call_end(text, m.end())) for m in CALL.finditer(text)]
    found = {}
    for begin, end in spans:
        for literal in LITERAL.finditer(text, begin, end):
            words = "".join(PIECE.findall(literal.group()))
            words = words.encode().decode("unicode_escape").encode("latin-1").decode("utf-8")
            if len(words.split()) >= LEAST_WORDS:
                found[literal.start()] = words
    return [(text.count("\n", 0, at) + 1, words) for at, words in sorted(found.items())]


def told_by(program):
    with tempfile.TemporaryDirectory() as folder:
        told = os.path.join(folder, "told.txt")
        subprocess.run([program, "--gtest_brief=1"], env={**os.environ, "SADDLE_TOLD": told},
                       stdout=subprocess.DEVNULL, check=False)
        with open(told, encoding="utf-8", errors="replace") as file:
            return file.read()


def main():
    told = told_by(sys.argv[1])
    excused = {words: False for all_words in unprovoked.REASONS.values() for words in all_words}
    # Whether these are provoked is no matter.
    on_some = [words for all_words in unprovoked.ON_SOME_MACHINES.values() for words in all_words]
    count = missing = 0
    for path in sorted((tree.ROOT / "src").rglob("*.cpp")):
        name = path.relative_to(tree.ROOT)
        text = without_comments(path.read_text(encoding="utf-8"))
        for line, words in messages(text, str(name)[4:] in SENTENCES):
            count += 1
            words = words.strip()
            if words in told or words.startswith(tuple(on_some)):
                continue
            excuse = next((known for known in excused if words.startswith(known)), None)
            if excuse is not None:
                excused[excuse] = True
                continue
            missing += 1
            print(f"{name}:{line}: {words}")
    idle = [words for words, is_used in excused.items() if not is_used]
    for words in idle:
        print(f"a reason for nothing: {words}")
    print(f"{missing} of {count} messages are not provoked, beside {sum(excused.values())} reasons")
    sys.exit(1 if missing or idle else 0)


main()
