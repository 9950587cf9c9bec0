#!/usr/bin/python3 -B
"""How often saddle's word holds: 500 surfaces made by a seeded generator, each meshed by PROGRAM and
measured by an oracle that shares no code with the mesher (tests/honesty/). Prints a table by kind and
every run that is not right. With --formula, one surface:

    honesty.py PROGRAM --formula 'z=sign(u*v) u=-2:2' -- --grid off

With --corpus thickened, 200 surfaces with jumps inside of differences, and what they take."""
import argparse
import json
import multiprocessing
import os
import pathlib
import shlex
import sys
import time
import traceback

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(threads, "1")
try:
    import numpy  # pylint: disable=unused-import
    import scipy  # pylint: disable=unused-import
except ImportError:
    if sys.executable == "/usr/bin/python3" or os.environ.get("HONESTY_AGAIN"):
        raise
    os.environ["HONESTY_AGAIN"] = "1"
    os.execv("/usr/bin/python3", ["/usr/bin/python3", "-B", *sys.argv])

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "honesty"))
import corpus  # pylint: disable=wrong-import-position
import thickened  # pylint: disable=wrong-import-position
import verdict  # pylint: disable=wrong-import-position

VERDICTS = ("right", "warned", "falsely warned", "silent", "understated", "certified wrongly",
            "refused", "refused falsely", "timeout", "crash", "broken", "told alone")
CORPORA = {"mixed": corpus, "thickened": thickened}


def one(job):
    program, case, seed, is_told_alone = job
    start = time.process_time()
    try:
        result = verdict.told_alone(program, case.formulas, case.options) if is_told_alone else \
            verdict.judge(program, case.formulas, case.options, case.hints, seed + case.number)
    except Exception:  # pylint: disable=broad-exception-caught
        result = {"formulas": case.formulas, "options": case.options, "verdict": "oracle fails",
                  "note": traceback.format_exc()}
    return {"number": case.number, "kind": case.kind, **result,
            "oracle_cpu": round(time.process_time() - start, 2)}


def shown(result):
    text = f"{result['number']:4} {result['kind']:12} {result['verdict']:17}"
    if result.get("found") is not None:
        told = result["told"]
        text += f" found {result['found']:.4g} told {'nothing' if told is None else format(told, '.4g')}"
    text += "  " + shlex.join(result["formulas"] + result["options"])
    if result.get("u") is not None:
        text += f"  ({result['way']} at u={result['u']:.10g} v={result['v']:.10g})"
    if result.get("note"):
        text += "\n       " + result["note"].strip().replace("\n", "\n       ")
    return text


def table(results):
    kinds = sorted({result["kind"] for result in results})
    names = [name for name in (*VERDICTS, "oracle fails")
             if any(result["verdict"] == name for result in results)]
    lines = ["| kind | surfaces | " + " | ".join(names) + " | s of CPU |",
             "|" + " --- |" * (len(names) + 3)]
    for kind in [*kinds, "all"]:
        own = [result for result in results if kind in ("all", result["kind"])]
        counts = [sum(result["verdict"] == name for result in own) for name in names]
        cells = [str(count) if count else "" for count in counts]
        lines.append(f"| {kind} | {len(own)} | " + " | ".join(cells) +
                     f" | {sum(result.get('cpu', 0) for result in own):.1f} |")
    return "\n".join(lines)


def distribution(results):
    """What the runs took, and how many meshes are off by more than their tolerance, found or told."""
    times = sorted(result.get("cpu", 0) for result in results)
    off = [max(result.get("found") or 0, result.get("told") or 0) for result in results]
    over = sorted(ratio for ratio in off if ratio > verdict.RIGHT)
    worst = f", by up to {over[-1]:.4g} tolerances" if over else ""
    silent = sum(result["verdict"] in verdict.ACCUSATIONS for result in results)
    return (f"processor time: median {times[len(times) // 2]:.3f} s, 90th percentile "
            f"{times[int(0.9 * len(times))]:.3f} s, worst {times[-1]:.3f} s\n"
            f"over tolerance: {len(over)} of {len(results)} ({100 * len(over) / len(results):.1f} %)"
            f"{worst}; {silent} of them not told")


def read(path):
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def compared(results, before):
    """Lines on surfaces whose verdict is another, or whose error changed by a tenth of a tolerance."""
    old = {shlex.join(result["formulas"] + result["options"]): result for result in before}
    for result in results:
        was = old.get(shlex.join(result["formulas"] + result["options"]))
        if not was:
            continue
        change = abs((result.get("found") or 0) - (was.get("found") or 0)) > \
            max(0.1, 0.05 * (was.get("found") or 0)) and max(result.get("found") or 0, was.get("found") or 0) > 1.02
        if was["verdict"] != result["verdict"] or change:
            yield f"was {was['verdict']}, found {was.get('found')}, told {was.get('told')}:\n  {shown(result)}"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="a saddle, or a file that --json wrote, to be shown again")
    parser.add_argument("options", nargs="*", help="options of saddle, after --, for --formula")
    parser.add_argument("--formula", action="append", default=[],
                        help="a surface in place of the corpus: formulas and options, as a shell's line")
    parser.add_argument("--file", type=pathlib.Path, help="such lines, one a surface; # is a comment")
    parser.add_argument("--corpus", choices=CORPORA, default="mixed",
                        help="thickened: jumps inside of differences")
    parser.add_argument("--told", action="store_true", help="print what saddle tells, without the oracle")
    parser.add_argument("--kind", action="append", help="one kind of the corpus alone")
    parser.add_argument("--only", type=int, action="append", help="one surface by its number")
    parser.add_argument("--seed", type=int)
    parser.add_argument("--count", type=int)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--json", type=pathlib.Path, help="write a line of JSON for each surface")
    parser.add_argument("--against", type=pathlib.Path, metavar="JSON",
                        help="list what changed against such a file, too")
    parser.add_argument("--list", action="store_true", help="print the surfaces alone")
    parser.add_argument("--all", action="store_true", help="print runs that are right, too")
    options = parser.parse_intermixed_args()
    chosen = CORPORA[options.corpus]
    seed = chosen.SEED if options.seed is None else options.seed
    count = chosen.COUNT if options.count is None else options.count

    lines = list(options.formula)
    if options.file:
        lines += [line for line in options.file.read_text(encoding="utf-8").splitlines()
                  if line.strip() and not line.startswith("#")]
    if lines:
        cases = [corpus.from_line(number, line, options.options) for number, line in enumerate(lines)]
    else:
        cases = [case for case in chosen.cases(seed, count)
                 if (not options.kind or case.kind in options.kind)
                 and (not options.only or case.number in options.only)]
    if not cases:
        parser.error("no such surface; --list shows them all")
    # All kinds in turn: a run that is stopped is a sample of all of them.
    cases.sort(key=lambda case: case.number * 0.6180339887 % 1)
    if options.list:
        for case in cases:
            print(case.number, case.kind, shlex.join([*case.formulas, *case.options]))
        return
    program = pathlib.Path(options.program).resolve()
    results = []
    if program.read_bytes()[:1] == b"{":
        results = [result for result in read(program) if not options.kind or result["kind"] in options.kind]
        print("\n".join(shown(result) for result in results if result["verdict"] != "right" or options.all))
        cases = []
    with multiprocessing.Pool(options.jobs) as pool:
        for result in pool.imap(one, [(str(program), case, seed, options.told) for case in cases]):
            results.append(result)
            if result["verdict"] not in ("right", "told alone") or options.all or lines:
                print(shown(result), flush=True)
            for warning in result.get("warnings", []) if lines or options.only else []:
                print("       said: " + warning)
            if options.json:
                with open(options.json, "a" if len(results) > 1 else "w", encoding="utf-8") as file:
                    file.write(json.dumps(result) + "\n")
    if options.against:
        print("changed:", *compared(results, read(options.against)), sep="\n")
    print(table(results))
    print(distribution(results))
    sys.exit(0 if all(result["verdict"] in ("right", "warned", "refused", "told alone")
                      for result in results) else 1)


if __name__ == "__main__":
    main()
