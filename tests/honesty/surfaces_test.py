#!/usr/bin/python3 -B
"""The oracle's verdicts on the surfaces of surfaces.txt. Usage: surfaces_test.py PROGRAM [PART PARTS]:
every PARTS-th line, beginning with line PART."""
import os
import pathlib
import shlex
import sys

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
import corpus  # pylint: disable=wrong-import-position
import verdict  # pylint: disable=wrong-import-position

LIST = pathlib.Path(__file__).resolve().parent / "surfaces.txt"


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    part, parts = map(int, sys.argv[2:4] or (0, 1))
    lines = [line for line in LIST.read_text(encoding="utf-8").splitlines()
             if line and not line.startswith("#")]
    failures = 0
    for number, line in list(enumerate(lines))[part::parts]:
        expected, formulas = line.split(maxsplit=1)
        case = corpus.from_line(number, formulas)
        result = verdict.judge(program, case.formulas, case.options)
        if result["verdict"] in expected.split("|"):
            continue
        failures += 1
        print(f"{shlex.join(case.formulas + case.options)}: {result['verdict']}, not {expected}: "
              f"found {result['found']}, told {result['told']} tolerances; {result.get('note', '')}")
    print(f"{len(lines[part::parts])} surfaces, {failures} failures")
    sys.exit(failures > 0)


main()
