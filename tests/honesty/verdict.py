"""One run of saddle, judged: what it says of its mesh against what the oracle finds."""
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import tempfile
import threading

import numpy as np

from language import Surface
from mesh import read_ply
from oracle import ENOUGH, Oracle, is_solid

RIGHT = 1.02          # of a tolerance: errors of rounding and of the search
UNDERSTATED = 1.1     # of what is told
OVERSTATED = 3.0      # told for one that is found
# Verdicts that are told after a second search alone.
ACCUSATIONS = ("silent", "understated", "certified wrongly")
CPU_SECONDS = 60
WALL_SECONDS = 400    # for loaded machines
MEMORY = 6 << 30
# Texts of warnings that tell of an error of the mesh.
TELLS = ("off by up to", "is off", "missing", "not shown", "may be missing", "may hide")
UNIT_NORMAL = 1e-5    # normals are written as floats
NUMBER = r"-?(?:\d+\.?\d*(?:e[-+]?\d+)?|inf)"


class Run:
    """What saddle wrote and said."""

    def __init__(self, program, arguments):
        self.mesh = self.report = None
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            command = [program, *arguments, "--threads", "1", "-o", str(folder / "m.ply"), "--report",
                       str(folder / "r.json")]
            self._start(command, folder)
            if (folder / "r.json").exists():
                self.report = json.loads((folder / "r.json").read_text())
            if self.status == 0:
                self.mesh = read_ply(folder / "m.ply")

    def _start(self, command, folder):
        def limits():
            resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 5))
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        with open(folder / "said", "w+", encoding="utf-8") as said:
            child = subprocess.Popen(command, stdout=said, stderr=said, stdin=subprocess.DEVNULL,
                                     preexec_fn=limits, cwd=folder)
            timer = threading.Timer(WALL_SECONDS, child.kill)
            timer.start()
            _, status, usage = os.wait4(child.pid, 0)
            timer.cancel()
            child.returncode = 0
            said.seek(0)
            self.said = said.read()
        self.cpu = usage.ru_utime + usage.ru_stime
        self.status = os.waitstatus_to_exitcode(status)
        self.timed_out = self.status in (-signal.SIGXCPU, -signal.SIGKILL)


def clip_box(report, options=()):
    """The box of --clip X0:X1,Y0:Y1,Z0:Z1 or the one that warnings name, whose four digits are rounded
    inward, or to the mesh's own bounds."""
    asked = re.search(r"--clip[ =](\S+)", " ".join(options))
    if asked and asked.group(1) == "off":
        return None
    if asked:
        sides = asked.group(1).split(",")
        return np.array([[float(end) for end in side.split(":")] for side in sides]).T
    text = next((re.search(r"clipped to (.*?);", w).group(1) for w in report["warnings"]
                 if "clipped to" in w), None)
    if text is None:
        return None
    bounds = report["surfaces"][0]["bounds"]
    box = np.array([[-np.inf] * 3, [np.inf] * 3])
    for name, low, high, up, down in re.findall(
            rf"([xyz])(?: = ({NUMBER}):({NUMBER})| from ({NUMBER}) up| up to ({NUMBER}))", text):
        k = "xyz".index(name)
        for side, face in ((0, low or up), (1, high or down)):
            if not face:
                continue
            value = float(face)
            slack = 6e-4 * abs(value)
            end = bounds[side][k]
            exact = end is not None and abs(end - value) <= slack
            box[side, k] = end if exact else value + (slack if side == 0 else -slack)
    return box


def _told(surface_report, warnings):
    return any(word in warning for word in TELLS for warning in warnings), surface_report["max_error"]


def broken(mesh):
    """Faults that need no surface: numbers that are not finite, normals that are no unit vectors."""
    bad = int((~np.isfinite(mesh.points).all(axis=1)).sum())
    if bad:
        return f"{bad} vertices not finite"
    length = np.sqrt((mesh.normals ** 2).sum(axis=1))
    bad = int((~(np.abs(length - 1) < UNIT_NORMAL)).sum())
    return f"{bad} normals not unit" if bad else ""


def false_words(surface, report):
    """Statements that the formulas exclude."""
    of = report["surfaces"][0]
    said = []
    if of["poles_count"] and not surface.may_have_poles:
        said.append("goes to infinity")
    if of["undefined_fraction"] and not surface.may_be_undefined and not surface.may_have_poles:
        said.append("undefined")
    return said


def refused(run, surface, seed):
    """A refusal is right if no place has a value, or if it says that the samples miss the surface."""
    if "only between the samples" in run.said:
        return "refused"
    import places as where
    rng = np.random.default_rng(seed)
    seen = where.Places(surface)
    where.add_even(seen, 1e-9, 400, rng)
    where.add_critical(seen, 1e-9, rng)
    st, _ = seen.all()
    if run.status == 3 and len(st):
        st = st[is_solid(surface, st, np.inf, rng)]
        if len(st):
            u, v = surface.uv(st[0])
            return f"refused falsely: defined at u={u:.17g}, v={v:.17g}"
    return "refused"


def told_alone(program, formulas, options=()):
    """What saddle tells of one surface, and takes: a dictionary like that of judge()."""
    run = Run(program, [*formulas, *options])
    result = {"formulas": list(formulas), "options": list(options), "cpu": round(run.cpu, 3),
              "status": run.status, "verdict": "told alone", "found": None, "told": None}
    if run.timed_out:
        return result | {"verdict": "timeout"}
    if run.status != 0:
        kind = "refused" if run.status == 3 else "crash"
        return result | {"verdict": kind, "note": run.said.strip()[:300]}
    of = run.report["surfaces"][0]
    if of["tolerance"]:
        told = np.inf if of["max_error"] is None else of["max_error"]
        result["told"] = round(told / of["tolerance"], 4)
    return result | {"triangles": of["triangles"], "evaluations": of["evaluations"]}


def judge(program, formulas, options=(), hints=(), seed=0):
    """The verdict on one surface: a dictionary."""
    result = {"formulas": list(formulas), "options": list(options)}
    surface = Surface(formulas)
    run = Run(program, [*formulas, *options])
    result.update(cpu=round(run.cpu, 3), status=run.status, verdict="", found=None, told=None,
                  warnings=[])
    if run.timed_out:
        return result | {"verdict": "timeout"}
    if run.status == 3:
        text = refused(run, surface, seed)
        kind = "refused falsely" if "falsely" in text else "refused"
        return result | {"verdict": kind, "note": text + " | " + run.said.strip()[:200]}
    if run.status != 0:
        return result | {"verdict": "crash", "note": run.said.strip()[:300]}
    of = run.report["surfaces"][0]
    result["warnings"] = run.report["warnings"]
    result["triangles"] = of["triangles"]
    fault = broken(run.mesh)
    if fault:
        return result | {"verdict": "broken", "note": fault}
    told_by_words, told = _told(of, run.report["warnings"])
    unit = of["tolerance"]
    if unit is None:
        bounds = np.array(of["bounds"], dtype=float)
        unit = max(told or 0, 1e-3 * float(np.linalg.norm(bounds[1] - bounds[0])))
    if not unit > 0:
        return result | {"verdict": "right", "note": "no extent", "found": 0.0, "told": told}
    # An error that is told is sought to a third of it, which tells whether it is overstated.
    enough = ENOUGH if (told or 0) <= RIGHT * unit else min(ENOUGH, told / unit / 3.3)
    oracle = Oracle(surface, run.mesh, unit, clip_box(run.report, options), seed, hints, enough=enough)
    both = [oracle.forward(), oracle.backward()]
    for k, found in enumerate(both):
        if name_of(found.distance, told, unit, told_by_words, run.report) in ACCUSATIONS:
            both[k] = confirmed(found, oracle, seed)
    found = max(both, key=lambda way: way.distance)
    if name_of(found.distance, told, unit, told_by_words, run.report) == "falsely warned":
        oracle = Oracle(surface, run.mesh, unit, clip_box(run.report, options), seed + 1, hints, 2, enough)
        again = oracle.forward()
        found = max(found, again, oracle.backward(), key=lambda way: way.distance)
    result["surface"], result["mesh"] = (round(way.distance / unit, 4) for way in both)
    verdict = name_of(found.distance, told, unit, told_by_words, run.report)
    result.update(verdict=verdict, found=round(found.distance / unit, 4),
                  told=None if told is None else round(told / unit, 4), unit=unit, way=found.way,
                  certified=of["certified"])
    if found.st is not None:
        result["u"], result["v"] = (float(x) for x in surface.uv(found.st))
        result["point"] = [float(x) for x in found.point]
    words = false_words(surface, run.report)
    if words:
        result["note"] = "false: " + ", ".join(words)
        if verdict in ("right", "warned"):
            result["verdict"] = "falsely warned"
    return result


def confirmed(found, oracle, seed):
    """The distance by a stricter search; the oracle's next best places if the first is no proof."""
    rng = np.random.default_rng(seed + 1)
    for candidate in found.candidates:
        st, point = candidate.st[None], candidate.point
        if found.way == "surface":
            same = np.abs(oracle.surface.precisely(st) - point).max()
            proved = candidate.distance if same < 0.05 * oracle.unit and is_solid(
                oracle.surface, st, 0.2 * oracle.unit, rng, precise=True)[0] else 0
        else:
            proved = min(candidate.distance, distance_to_surface(oracle, point, st),
                         oracle.beside_walls(point[None], st, candidate.corners[None])[0])
        if proved > RIGHT * oracle.unit:
            candidate.distance = proved
            return candidate
    found.distance = min(found.distance, RIGHT * oracle.unit)
    return found


def distance_to_surface(oracle, point, st, tries=24):
    """The least distance that many starts find: the nearest of a dense sample, and the place itself."""
    import places as where
    surface = oracle.surface
    if not hasattr(oracle, "dense"):
        oracle.dense = where.Places(surface)
        where.add_even(oracle.dense, oracle.small, 700, oracle.rng, 20000)
        where.add_critical(oracle.dense, oracle.small, oracle.rng, 300, 3000)
    places, points = oracle.dense.all()
    own_places, own_points = oracle.places.all()
    places, points = np.concatenate([places, own_places]), np.concatenate([points, own_points])
    distance = np.sqrt(((points - point) ** 2).sum(axis=1))
    order = np.argsort(distance)[:tries * 50:50]
    starts = np.concatenate([st, places[order]])
    at = np.broadcast_to(point, (len(starts), 3))
    least = np.inf
    for size in (0.3, 1e-2, 1e-4):
        got, _ = oracle.closest(at, starts, np.full(len(starts), size), np.full(len(starts), np.inf), 4)
        least = min(least, got.min())
    return min(least, distance.min(initial=np.inf))


def name_of(distance, told, unit, told_by_words, report):
    """The verdict, from distances in the surface's units."""
    of = report["surfaces"][0]
    off = distance > RIGHT * unit
    told = np.inf if told is None else told
    says = told > RIGHT * unit or told_by_words or of["tolerance"] is None
    if off and of["certified"]:
        return "certified wrongly"
    if off and not says:
        return "silent"
    if off and distance > UNDERSTATED * max(told, unit):
        return "understated"
    if told > RIGHT * unit and told > OVERSTATED * distance:
        return "falsely warned"
    return "warned" if off or told > RIGHT * unit else "right"
