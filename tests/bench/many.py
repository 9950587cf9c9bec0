#!/usr/bin/python3 -B
"""What many objects take beside few: 300 spheres beside one, and 10 000 nodes of one mesh beside
ten. Usage: many.py SADDLE. Exit 1 if a scene takes more than its bound.

The times are the processor's, of whole processes from a scene file to a PNG of 800x600 pixels, the
least of several rounds in which the scenes take turns: other work only ever adds to them."""
import json
import pathlib
import sys
import tempfile

import peers

ROUNDS = 12
SPHERES = 300
NODES = 10_000
# Most times of the smaller scene's, each.
BOUNDS = {"spheres": 7, "nodes": 7}
SPHERE = ('x = "{x}+0.4*cos(v)*cos(u)"\ny = "{y}+0.4*cos(v)*sin(u)"\nz = "0.4*sin(v)"\n'
          'u = [0, "2*pi"]\nv = ["-pi/2", "pi/2"]\n')


def places(count):
    """On a square as full as can be, a unit from each other."""
    side = next(n for n in range(1, count + 1) if n * n >= count)
    return [(k % side, k // side) for k in range(count)]


def spheres(count):
    return "".join(f"[[surface]]\nname = 's{k}'\n" + SPHERE.format(x=x, y=y)
                   for k, (x, y) in enumerate(places(count)))


def nodes(count):
    names = ", ".join(f"'n{k}'" for k in range(count))
    return f"[[surface]]\nin = [{names}]\n" + SPHERE.format(x=0, y=0) + "".join(
        f"[[node]]\nname = 'n{k}'\ntransform = [ {{ translate = [{x}, {y}, 0] }} ]\n"
        for k, (x, y) in enumerate(places(count)))


SCENES = {
    ("spheres", 1): spheres(1), ("spheres", SPHERES): spheres(SPHERES),
    ("nodes", 10): nodes(10), ("nodes", NODES): nodes(NODES),
}


def main():
    saddle = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for (kind, count), text in SCENES.items():
            (folder / f"{kind}-{count}.toml").write_text(text, encoding="utf-8")
        costs = {scene: [] for scene in SCENES}
        for _ in range(ROUNDS):
            for kind, count in SCENES:
                command = [saddle, f"{kind}-{count}.toml", "-o", "a.png", "--report",
                           f"{kind}-{count}.json"]
                costs[kind, count].append(peers.run(command, folder)[1])
        triangles = {
            (kind, count): sum(surface["triangles"] for surface in json.loads(
                (folder / f"{kind}-{count}.json").read_text(encoding="utf-8"))["surfaces"])
            for kind, count in SCENES}
    print("| scene | processor, ms | times the smaller one | most | triangles |")
    print("| --- | ---: | ---: | ---: | ---: |")
    beyond = []
    smaller = {}
    for (kind, count), rounds in costs.items():
        cost = min(rounds)
        ratio = cost / smaller.setdefault(kind, cost)
        bound = BOUNDS[kind] if ratio != 1 else ""
        print(f"| {count} {kind} | {cost:.0f} | {ratio:.1f} | {bound} | {triangles[kind, count]} |")
        if ratio > BOUNDS[kind]:
            beyond.append(kind)
    if beyond:
        sys.exit("beyond the bound: " + ", ".join(beyond))


if __name__ == "__main__":
    main()
