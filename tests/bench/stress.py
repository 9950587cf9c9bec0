#!/usr/bin/python3 -B
"""What the hardest surfaces take: those whose mesh never is within its tolerance, or only with
more triangles than a picture has pixels. Usage: stress.py SADDLE [WORD...]: the cases that have one
of the words in them, or all. For each, processor seconds and peak memory of whole processes that
write a PNG, a PLY file, and that check it."""
import pathlib
import sys
import tempfile

import peers

SPHERE = "x=r*cos(v)*cos(u) y=r*cos(v)*sin(u) z=r*sin(v) u=0:2*pi v=-pi/2:pi/2"
NOISE = "mod(sin(u*12.9898+v*78.233)*43758,1)"
WEIERSTRASS = "+".join(f"cos({3**k}*t)/{2**k}" for k in range(1, 8))
CASES = [
    "z=sin(1/u)", "z=sin(1e6*u)", "z=sin(1e15*u)", "z=sin(200*u*v)", "z=sin(1e4*u*v)",
    "z=sin(1/(u*v))", "z=sin(1/(u^2+v^2))", "z=sin(exp(8*hypot(u,v)))", "z=sin(exp(20*u)*v)",
    f"f(t)={WEIERSTRASS} z=f(u)*f(v)", "x=sin(100*u*v) y=cos(130*u+v) z=sin(170*v-u*u)",
    f"z={NOISE}", f"r=1+0.2*{NOISE} {SPHERE}", "z=floor(1/u)+floor(1/v)", "z=mod(100*u*v,1)",
    "z=sqrt(sin(1/u)*sin(1/v))", "z=sqrt(sin(1/(u*v)))", "z=sqrt(abs(sin(20*u)*sin(20*v)))",
    "z=max(sin(9*u),cos(11*v),sin(13*(u+v)),cos(17*(u-v)),sin(19*u*v),cos(23*(u*u-v)))",
    "z=lgamma(u*v) u=-4:4 v=-4:4", "z=gamma(u)*gamma(v) u=-5:5 v=-5:5",
    "z=lgamma(u)+lgamma(v) u=-20:0 v=-20:0", f"r=2+ln(abs(sin(3*u)*cos(4*v)))/4 {SPHERE}",
    "x=tan(u*v) y=tan(u+v) z=tan(u-v) u=-5:5 v=-5:5", "z=tan(u*v) u=-10:10 v=-10:10",
    "z=tan(1/u)*tan(1/v)", "z=tanh(1e5*(u^2+v^2-0.5))", "z=u^99*v^98-u^97 u=-1.05:1.05",
]


def main():
    saddle, words = str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2:]
    ways = {"PNG": ["-o", "a.png"], "PLY": ["-o", "a.ply"], "check": []}
    print("| formula | " + " | ".join(f"{way}, s | MB" for way in ways) + " |")
    print("| --- |" + " ---: |" * 2 * len(ways))
    with tempfile.TemporaryDirectory() as folder:
        for case in CASES:
            if words and not any(word in case for word in words):
                continue
            numbers = []
            for way, output in ways.items():
                command = [saddle, *(["check"] if way == "check" else []), *case.split(), *output]
                _, processor, memory = peers.run(command, pathlib.Path(folder))
                numbers += [f"{processor / 1e3:.2f}", f"{memory:.0f}"]
            print(f"| `{case}` | " + " | ".join(numbers) + " |", flush=True)


if __name__ == "__main__":
    main()
