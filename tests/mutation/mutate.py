#!/usr/bin/python3 -B
"""Mutations: small changes of the sources that a test should notice. All mutants of a run are
compiled in at once, in a copy of the tree below build/mutate; the environment variable SADDLE_MUTANT
switches one of them on. Those that no test notices are listed in survivors.txt.
Source: R. Untch, A. Offutt, M. Harrold, "Mutation analysis using mutant schemata", 1993.

usage: mutate.py --only PART [--only PART] [--programs NAME,...] [--tests FILTER] [--sample N] [--headers]
PART: a folder or a file of src/, such as eval, mesh/tree or eval/interval.cpp."""
import argparse
import collections
import concurrent.futures
import contextlib
import mmap
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
COPY = ROOT / "build/mutate"  # as deep as the tree itself: ccache then knows what is unchanged
BUILD = COPY / "build/release"
HERE = "tests/mutation"
SURVIVORS = ROOT / HERE / "survivors.txt"

# Tests that take longer are left out, and so are more tests of a mutant than take this in all.
SLOWEST = 10  # seconds
TOGETHER = 20
PATIENCE = 5  # times as long as the tests take; then the mutant counts as killed: it hangs
BUILDS = 12
LARGEST_FILE = 8 << 30  # bytes: tests make some of 4 GiB, without content

# name of the operator -> (its name in mutants.h, the operator of the same precedence, mutants)
OPERATORS = {
    "<": ("Less", "<", ("<=", ">=")), "<=": ("LessEqual", "<", ("<", ">")),
    ">": ("Greater", "<", (">=", "<=")), ">=": ("GreaterEqual", "<", (">", "<")),
    "==": ("Equal", "==", ("!=",)), "!=": ("Unequal", "==", ("==",)),
    "+": ("Plus", "+", ("-",)), "-": ("Minus", "+", ("+",)),
    "*": ("Times", "*", ("/",)), "/": ("Over", "*", ("*",)),
}
# clang-format puts blanks around binary operators, and none into templates.
BINARY = re.compile(r"(?<=[^\s<{(,;=&|?:]) (<=|>=|==|!=|[<>+\-*/])(?=\s)(?!\s*[.\"])")
NUMBER = re.compile(r"(?<![\w.'<])(?:0x[\da-fA-F.']+(?:p[+-]?\d+)?|(?:\d[\d']*)(?:\.\d*)?(?:[eE][+-]?\d+)?"
                    r"|\.\d+)[uUlLfFz]*(?![\w.'>])")
CONSTANT = re.compile(r"constexpr (?:double|float|int|unsigned|std::size_t|std::u?int\d+_t) (k\w+) = ")
CONDITION = re.compile(r"\b(?:if|while) \(")
# A call or an assignment: no blank before its parenthesis or sign, where a declaration has one.
STATEMENT = re.compile(r"(?:(?<=[;{})])|(?<=\belse))(\s+)((?:\+\+|--)?(?!return\b|throw\b|assert\b|SADDLE_)"
                       r"[a-z_*(][\w.:\[\]*\->+()]*(?: [+\-*/|&]?= [^;{}]*|\([^;{}]*\)|))(;)")
SKIPPED = re.compile(r"//[^\n]*|/\*.*?\*/|R\"(\w*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\"|(?<!\d)'(?:\\.|[^'\\])+'"
                     r"|^[ \t]*#(?:\\\n|[^\n])*|\b(?:static_assert|alignas|case)\b[^;:]*[;:]"
                     r"|\bconstexpr [^({;]*(?:=|\{)[^;]*;|\benum [^;]*;", re.DOTALL | re.MULTILINE)

Mutant = collections.namedtuple("Mutant", "number file line what text")


def masked(text):
    """The text with what is not mutated made blank: comments, strings, what compilers compute."""
    def blank(match):
        quote = '"' if match[0].startswith('"') else " "
        return quote + re.sub(r"[^\n]", " ", match[0][1:-1]) + quote if len(match[0]) > 1 else " "
    return SKIPPED.sub(blank, text)


def closing(text, start):
    """The place of the parenthesis that closes the one at `start`."""
    depth = 0
    for at in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return at
    return -1


class Mutator:
    """Numbers the mutants of files, and writes the files with all of them in."""

    def __init__(self):
        self.mutants = []
        self.broken = set()  # (file, line) that do not compile

    def new(self, file, text, at, whats):
        line = text.count("\n", 0, at) + 1
        first = len(self.mutants)
        for what in whats:
            self.mutants.append(Mutant(len(self.mutants), file, line, what,
                                       text.splitlines()[line - 1].strip()))
        # The others keep their numbers, and their objects.
        return None if {(file, line), (file, 0)} & self.broken else first

    def mutate(self, file, text):
        """The text with its mutants. Edits are (place, its order there, end, new text)."""
        code = masked(text)
        edits = []

        def replace(begin, end, what):
            edits.append((begin, end, what))

        for match in BINARY.finditer(code):
            name, mark, mutants = OPERATORS[match[1]]
            if '"' in code[match.start() - 1]:
                continue
            n = self.new(file, text, match.start(1), [f"{match[1]} -> {m}" for m in mutants])
            if n is not None:
                replace(match.start(1), match.end(1),
                        f"{mark} mutants::at<mutants::{name}, {n}, {len(mutants)}> {mark}")
        names = set(CONSTANT.findall(text))
        for match in [*NUMBER.finditer(code), *(
                m for m in re.finditer(r"\bk[A-Z]\w*\b(?![\w\[(<.:{])", code) if m[0] in names)]:
            if re.search(r"\) = $|\[$|case $", code[max(0, match.start() - 8):match.start()]):
                continue  # a pure virtual function; an extent
            whole = match[0] in names or re.fullmatch(r"[\d']+[uUlLz]*", match[0])
            value = match[0]
            more = f"{value} + 1" if whole and value not in names else f"{value}, changed"
            whats = [f"{value} -> 1"] if value in ("0", "0.0") else \
                [f"{value} -> {more}", f"{value} -> 0"]
            n = self.new(file, text, match.start(), whats)
            if n is not None:
                replace(match.start(), match.end(), f"mutants::constant<{n}>({value})")
        for match in CONDITION.finditer(code):
            begin, end = match.end() - 1, closing(code, match.end() - 1)
            inner = code[begin + 1:end]
            if re.search(r"[;{]| = | (?:<|>|<=|>=|==|!=) ", inner) or not inner.strip():
                continue  # declares a variable, or is a comparison, which has its own mutant
            n = self.new(file, text, match.start(), ["condition negated"])
            if n is not None:
                replace(begin, begin + 1, f"(mutants::condition<{n}>(")
                replace(end, end + 1, "))")
        for match in STATEMENT.finditer(code):
            call = match[2]
            if not re.search(r"[=()]|\+\+|--", call) or call.count("(") != call.count(")"):
                continue
            n = self.new(file, text, match.start(2), ["statement removed"])
            if n is not None:
                replace(match.start(2), match.start(2), f"mutants::statement<{n}>() ? void(")
                replace(match.start(3), match.start(3), ") : void()")
        for begin, end, what in sorted(edits, reverse=True):
            text = text[:begin] + what + text[end:]
        return f'#include "{COPY / HERE}/mutants.h"\n#line 1 "{COPY / file}"\n{text}'


def limit_files():
    """A mutant may write without an end."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (LARGEST_FILE, LARGEST_FILE))


def write_if_new(path, data):
    if not path.exists() or path.read_bytes() != data:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def say(text):
    print(f"mutate: {text}", file=sys.stderr, flush=True)


def is_of(file, part):
    return file == f"src/{part}" or file.startswith(f"src/{part}/")


class Run:
    def __init__(self, options):
        self.options = options
        self.programs = options.programs.split(",")
        names = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True,
                               capture_output=True, text=True).stdout.splitlines()
        self.files = [name for name in names if (ROOT / name).is_file()]
        suffixes = (".cpp", ".h") if options.headers else (".cpp",)
        self.mutated = sorted(name for name in self.files if name.endswith(suffixes) and any(
            is_of(name, part) for part in options.only))
        if not self.mutated:
            sys.exit(f"mutate: no sources in {options.only}")

    def copy(self, mutator):
        mutator.mutants.clear()
        for name in self.files:
            data = (ROOT / name).read_bytes()
            if name in self.mutated:
                data = mutator.mutate(name, data.decode()).encode()
            if name == "src/base/error.cpp":  # one that all programs have
                data += (ROOT / HERE / "mutants.cpp").read_bytes().replace(
                    b'"mutants.h"', f'"{COPY / HERE}/mutants.h"'.encode())
            write_if_new(COPY / name, data)

    def build(self):
        """Builds with all mutants, without those that do not compile."""
        mutator = Mutator()
        targets = [f"test_{name}" for name in self.programs]
        targets += ["saddle"] if {"cli", "viewer"} & set(self.programs) else []
        for _ in range(BUILDS):
            self.copy(mutator)
            if not (BUILD / "build.ninja").exists():
                subprocess.run(["cmake", "--preset", "release", "-DSADDLE_TESTS=ON"], cwd=COPY,
                               check=True, stdout=subprocess.DEVNULL)
            say(f"building {len(mutator.mutants)} mutants of {len(self.mutated)} files")
            built = subprocess.run(["ninja", "-C", BUILD, "-k", "0", f"-j{self.options.jobs}", *targets],
                                   capture_output=True, text=True)
            if built.returncode == 0:
                return [m for m in mutator.mutants
                        if not {(m.file, m.line), (m.file, 0)} & mutator.broken]
            places = {(file, int(line)) for file, line in re.findall(
                r"(src/[\w/.]+\.(?:cpp|h)):(\d+):\d+: (?:error|  *required from)", built.stdout)}
            wrong = {p for p in places if any((m.file, m.line) == p for m in mutator.mutants)}
            # An error elsewhere comes from what a mutated file gives the compiler.
            wrong |= {(file, 0) for file, _ in places - wrong if not wrong and file in self.mutated}
            wrong -= mutator.broken
            if not wrong:
                sys.exit(built.stdout[-3000:])
            say(f"{len(wrong)} lines do not compile with their mutants")
            mutator.broken |= wrong
        sys.exit("mutate: the mutants do not compile")

    def tests(self):
        for program in self.programs:
            listed = subprocess.run([BUILD / f"test_{program}", "--gtest_list_tests",
                                     "--gtest_filter=" + self.options.tests], cwd=COPY,
                                    capture_output=True, text=True, check=True).stdout
            suite = ""
            for line in listed.splitlines():
                name = line.split("#")[0].rstrip()
                if not line.startswith(" "):
                    suite = name
                elif "DISABLED_" not in name:
                    yield program, suite + name.strip()

    def start(self, program, names, seconds, **variables):
        """Whether the tests pass."""
        command = [BUILD / f"test_{program}", "--gtest_fail_fast", "--gtest_filter=" + ":".join(names)]
        with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
            os.chmod(folder, 0o755)  # some tests act as another user
            process = subprocess.Popen(
                command, cwd=COPY, env={**os.environ, "TMPDIR": folder, **variables},
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                start_new_session=True, preexec_fn=limit_files)
            try:
                return process.wait(seconds) == 0
            except subprocess.TimeoutExpired:
                return False
            finally:  # also what a test has started, which may go on without it
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(process.pid, signal.SIGKILL)
                process.wait()

    def reach(self, mutants):
        """For each mutant the tests that reach it, as (seconds, program, name); those impossible."""
        count = mutants[-1].number + 1
        reached = [[] for _ in range(count)]
        impossible = set()

        def look(test):
            program, name = test
            with tempfile.NamedTemporaryFile() as file:
                file.truncate(count)
                begin = time.monotonic()
                passed = self.start(program, [name], SLOWEST, SADDLE_MUTANTS_REACHED=file.name)
                seconds = time.monotonic() - begin
                with mmap.mmap(file.fileno(), 0) as data:
                    return (seconds, program, name), passed, bytes(data)

        left_out = 0
        for test, passed, data in self.pool.map(look, list(self.tests())):
            left_out += not passed
            for number in range(count):
                if data[number] & 2:
                    impossible.add(number)
                elif data[number] and passed:
                    reached[number].append(test)
        say(f"{left_out} tests fail or take longer than {SLOWEST} s, and are left out")
        return reached, impossible

    def is_killed(self, mutant, reached):
        spent = 0
        by_program = collections.defaultdict(list)
        for seconds, program, name in sorted(reached):
            spent += seconds
            if spent > TOGETHER and by_program:
                break
            by_program[program].append(name)
        patience = PATIENCE * (spent + 1)
        return not all(self.start(program, names, patience, SADDLE_MUTANT=str(mutant.number))
                       for program, names in by_program.items())

    def run(self):
        mutants = self.build()
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as self.pool:
            reached, impossible = self.reach(mutants)
            mutants = [m for m in mutants if m.number not in impossible]
            if self.options.sample:
                mutants = sorted(random.Random(1).sample(mutants, min(len(mutants),
                                                                      self.options.sample)))
            tried = [m for m in mutants if reached[m.number]]
            say(f"{len(mutants)} mutants, {len(tried)} of them reached by tests")
            killed = set()
            for k, (mutant, dead) in enumerate(zip(tried, self.pool.map(
                    lambda m: self.is_killed(m, reached[m.number]), tried)), start=1):
                if dead:
                    killed.add(mutant.number)
                if k % 50 == 0:
                    say(f"{k} of {len(tried)}, {len(killed)} killed")
        return mutants, reached, killed


def sections():
    """The parts of survivors.txt, each with its lines."""
    result = {}
    if SURVIVORS.exists():
        for section in SURVIVORS.read_text(encoding="utf-8").split("\n## ")[1:]:
            result[section.split(":")[0]] = section.rstrip("\n")
    return result


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1])
    parser.add_argument("--only", action="append", required=True)
    parser.add_argument("--programs", default="unit,property")
    parser.add_argument("--tests", default="*", help="a filter of GoogleTest")
    parser.add_argument("--sample", type=int)
    parser.add_argument("--headers", action="store_true")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    options = parser.parse_args()
    mutants, reached, killed = Run(options).run()
    kept = sections()
    for part in options.only:
        own = [m for m in mutants if is_of(m.file, part)]
        alive = [m for m in own if m.number not in killed]
        unreached = sum(not reached[m.number] for m in alive)
        of = f" of a sample of {options.sample}" if options.sample else ""
        lines = [f"{part}: {len(own)} mutants{of}, {len(own) - len(alive)} killed, "
                 f"{len(alive) - unreached} survived, {unreached} not reached; by {options.programs}"]
        print(lines[0])
        lines += [f"{m.file}:{m.line}: {m.what}{'' if reached[m.number] else ' (not reached)'}: {m.text}"
                  for m in alive]
        kept[part] = "\n".join(lines)
    head = "Mutants that no test notices, by ./dev mutate. Some change nothing that can be seen."
    text = "\n\n".join([head, *(f"## {kept[name]}" for name in sorted(kept))])
    SURVIVORS.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
