"""Command lines at random, and input from strangers, with what it may cost."""
import dataclasses
import struct
import zlib

GIGABYTE = 1e9
SECONDS = 60
BYTES = 4 * GIGABYTE


@dataclasses.dataclass
class Case:
    name: str
    words: list
    make: object = None  # returns the files that the run finds, by their names
    seconds: float = SECONDS
    bytes: float = BYTES
    statuses: tuple = (0, 2, 3)
    says: str = ""

    def files(self):
        return {k: v if isinstance(v, bytes) else v.encode() for k, v in (self.make() if self.make
                                                                          else {}).items()}

    def __str__(self):
        return self.name


def scene(text):
    return lambda: {"s.toml": text() if callable(text) else text}


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(text=b"", side=1, extra=b""):
    """A white picture with the text chunk of a scene."""
    rows = zlib.compress(b"\0" + b"\xff" * side, 9) if side == 1 else white(side)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 0, 0, 0, 0))
            + extra + (chunk(b"iTXt", b"saddle-scene\0\0\0\0\0" + text) if text else b"")
            + chunk(b"IDAT", rows) + chunk(b"IEND", b""))


def white(side):
    packer = zlib.compressobj(9)
    parts = [packer.compress(b"\0" + b"\xff" * side) for _ in range(side)]
    return b"".join(parts) + packer.flush()


DRAW = ["s.toml", "-o", "a.png"]
EVIL = r'name = "\u001b[2J\u001b]52;c;QQ==\u0007\r\u009b31m\nsaddle: all is well"'


def chained(count):
    return "[params]\np0=1\n" + "".join(f'p{i}="p{i - 1}+1"\n' for i in range(1, count)) + \
        f'[[surface]]\nz="u+p{count - 1}"\n'


def one_line(count):
    steps = ",".join("{translate=[0,0,1e-9]}" for _ in range(count))
    return f'surface=[{{z="u",in="a"}}]\nnode=[{{name="a",transform=[{steps}]}}]\n'


def doubling(count):
    lines = "".join(f'"f{i}(s)"="f{i - 1}(s)+f{i - 1}(-s)"\n' for i in range(1, count))
    return f'[functions]\n"f0(s)"="sin(s)"\n{lines}[[surface]]\nz="f{count - 1}(u)"\n'


def long_formulas(count):
    total = "+".join(f"sin(u+{i}*v)" for i in range(2000))
    surfaces = "".join(f'[[surface]]\nz="f(u,v)+{i}"\n' for i in range(count))
    return f'[functions]\n"f(u,v)"="{total}"\n{surfaces}'


def nested(count):
    text = "sin(u*v)"
    for i in range(count):
        text = f"diff({text}*exp(u*{i + 1}),u)"
    return text


SUM = "z=sum(sin(n*u)*cos(n*v)/n, n=1:1000)"
NESTED = "z=sum(sum(sin(n*u+m*v)/(n*m), n=1:70), m=1:70)"
WEIERSTRASS = "sum(0.7^n*cos(7^n*pi*u)*cos(7^n*v), n=1:40)"
OSCILLATION = "z=sin(1/(u*v))"
NOISE = "z=sin(1e6*u*v)"
STEPS = "z=floor(30*u)*floor(30*v)"


def surfaces(count, z, more=""):
    return scene(lambda: f'[[surface]]\nz="{z}"\n{more}' * count)


def hard():
    """What takes the mesher, the pictures and the files longest."""
    files = [Case(f"{name} as {kind.upper()}", [z, "-o", f"a.{kind}"])
             for name, z in (("an oscillation", OSCILLATION), ("noise", NOISE), ("steps", STEPS))
             for kind in ("svg", "pdf", "html", "glb", "3mf", "obj")]
    return files + [
        Case("a sum of 1,000 terms", [SUM, "-o", "a.png"]),
        Case("a sum of 4,900 terms", [NESTED, "-o", "a.png"]),
        Case("a sum of 4,900 terms, checked", ["check", NESTED]),
        Case("a curve without slopes", [f"z={WEIERSTRASS}", "-o", "a.png"]),
        Case("a curve without slopes, checked", ["check", f"z={WEIERSTRASS}"]),
        Case("2,000 surfaces of waves", DRAW, surfaces(2000, "sin(9*u*v)")),
        Case("300 oscillations, checked", ["check", "s.toml"], surfaces(300, "sin(1/(u*v))")),
        Case("300 surfaces of steps", DRAW, surfaces(300, "floor(30*u)*floor(30*v)")),
        Case("noise, as a solid", [NOISE, "--thickness", "0.01", "-o", "a.stl"]),
        Case("an oscillation, as a solid", [OSCILLATION, "--thickness", "0.1", "-o", "a.stl"]),
        Case("steps, as a solid", [STEPS, "--thickness", "0.01", "-o", "a.3mf"]),
        Case("a curve of noise", ["curve", "x=s", "y=sin(1e9*s)", "z=cos(1e8*s)", "s=-1:1",
                                  "-o", "a.png"]),
        Case("a tube of noise", ["curve", "x=s", "y=sin(1e5*s)", "z=cos(1e4*s)", "s=-1:1",
                                 "--radius", "0.01", "-o", "a.png"]),
        Case("colours without slopes", ["z=u*v", "--color", WEIERSTRASS, "-o", "a.png"]),
        Case("level lines of waves", [OSCILLATION, "--contours", "sin(300*u*v)", "-o", "a.png"]),
        Case("a condition without an edge", DRAW,
             surfaces(1, "u*v", 'where="sin(1/(u*v))>0"\n')),
        Case("a long formula at each pixel", [SUM, "--shading", "exact", "-o", "a.png"]),
        Case("steps, checked", ["check", STEPS]),
        Case("poles of a function, checked", ["check", "z=gamma(u*9)*gamma(v*9)"]),
        Case("noise in two seconds", [NOISE, "--max-time", "2", "-o", "a.svg"], seconds=30,
             statuses=(0, 1)),
    ]


def corpus(short):
    cheap = [
        Case("names that drive a terminal", DRAW + ["-v"], scene(f'[[surface]]\n{EVIL}\nz="1/u"\n'),
             says="evil" if "evil" in EVIL else "?[2J"),
        Case("the same, checked", ["check", "s.toml"], scene(f'[[surface]]\n{EVIL}\nz="u"\n')),
        Case("the same, in a picture", ["e.png", "-v", "-o", "a.png"],
             lambda: {"e.png": png(f'[[surface]]\n{EVIL}\nz="1/u"\n'.encode())}),
        Case("a scene that is no TOML", DRAW, scene("]]]]" * 1000), statuses=(2,), says="s.toml:1"),
        Case("bytes", DRAW, lambda: {"s.toml": bytes(range(256)) * 100}, statuses=(2,)),
        Case("brackets", DRAW, scene('[[surface]]\nz="' + "(" * 60000 + '"\n'), statuses=(2,)),
        Case("a deep array", DRAW, scene("a=" + "[" * 2_000_000), statuses=(2,)),
        Case("a deep key", DRAW, scene("a" + ".a" * 1_000_000 + "=1"), statuses=(2,), says="parts"),
        Case("more than 4 MiB", DRAW, scene(lambda: "#" * 4_200_000), statuses=(2,), says="4 MiB"),
        Case("a circle", DRAW, scene('[params]\na="b"\nb="a"\n[[surface]]\nz="a"\n'),
             statuses=(2,), says="a -> b -> a"),
        Case("a circle of nodes", DRAW,
             scene('[[surface]]\nz="u"\nin="a"\n[[node]]\nname="a"\nin="b"\n[[node]]\nname="b"\n'
                   'in="a"\n'), statuses=(2,), says="a -> b"),
        Case("functions that double", DRAW, scene(doubling(40)), seconds=20),
        Case("a formula of 100 kB", DRAW, scene('[[surface]]\nz="u' + "+sin(u)" * 15000 + '"\n'),
             statuses=(2,)),
        Case("numbers at the ends", ["z=u*v", "u=-1e300:1e300", "v=0:5e-324", "-o", "a.png"]),
        Case("NaN for a range", ["z=u*v", "u=0/0:1", "-o", "a.png"], statuses=(2,)),
        Case("a text of 1 GB in a picture", ["e.png", "-o", "a.png"],
             lambda: {"e.png": png(extra=chunk(b"zTXt", b"saddle-scene\0\0" + zlib.compress(
                 bytes(10 ** 9), 9)))}, statuses=(2,), seconds=10, bytes=0.3 * GIGABYTE),
        Case("a scene in a damaged picture", ["e.png", "-o", "a.png"],
             lambda: {"e.png": png(b'[[surface]]\nz="u"\n').replace(b'z="u"', b'z="v"')},
             statuses=(2,), says="damaged"),
        Case("an option of a shell in a name", ["s.toml", "-o", "a.mp4", "--frames", "2", "-s",
                                                "16x16"],
             scene('title="$(touch pwned)`touch pwned`"\n[[surface]]\nname="; touch pwned"\n'
                   'z="u*t"\n')),
        Case("a texture that is a file of the system", DRAW,
             scene('[[surface]]\nz="u"\ntexture="/etc/passwd"\n'), statuses=(2,), says="outside"),
        Case("a texture above the folder", DRAW,
             scene('[[surface]]\nz="u"\ntexture="a/../../b.png"\n'), statuses=(2,), says="outside"),
        Case("20,001 points", DRAW, scene(lambda: '[[point]]\nat=[0,0,0]\n' * 20001),
             statuses=(2,), says="too many", seconds=10),
        Case("2,001 surfaces", DRAW, scene(lambda: '[[surface]]\nz="u"\n' * 2001), statuses=(2,),
             says="too many", seconds=10),
        Case("1,000 surfaces of a long formula", DRAW, scene(lambda: long_formulas(1000)),
             statuses=(2,), says="too long together", seconds=10),
        Case("a grid of 4096x4096", ["torus", "--grid", "4096x4096", "-o", "a.png"], statuses=(2,),
             says="1024x1024", seconds=2),
        Case("12,000 transforms in a line", DRAW, scene(lambda: one_line(12000)), seconds=5),
        Case("a million lines of a scene in a mesh", ["e.obj", "-o", "a.png"],
             lambda: {"e.obj": "# scene # nothing\n" * 10 ** 6}, statuses=(2,), seconds=5),
        Case("10,000 chained params", DRAW, scene(lambda: chained(10000)), seconds=5),
    ]
    if short:
        return cheap
    return cheap + hard() + [
        Case("170,000 transforms in a line", DRAW, scene(lambda: one_line(170000))),
        Case("200,000 chained params", DRAW, scene(lambda: chained(200000))),
        Case("30,000 nodes", DRAW, scene(lambda: '[[surface]]\nz="u"\nin="n0"\n' + "".join(
            f'[[node]]\nname="n{i}"\n' for i in range(30000)))),
        Case("2,000 surfaces", DRAW, scene(lambda: '[[surface]]\nz="u*v"\n' * 2000)),
        Case("50 hard surfaces", DRAW,
             scene(lambda: '[[surface]]\nz="sin(1/(u*v))"\n' * 50)),
        Case("nested derivatives", [f"z={nested(12)}", "-o", "a.png"]),
        Case("see-through, at a fine oscillation",
             ["z=sin(1/(u*v))", "--opacity", "0.5", "-o", "a.png"]),
        Case("see-through, seen from the side",
             ["z=sin(200*u)*sin(200*v)", "--opacity", "0.1", "--view", "1,0,0", "-o", "a.png"],
             says="see-through layers"),
        Case("an oscillation without end", ["z=sin(exp(9*u))*cos(exp(9*v))", "-o", "a.png"]),
        Case("many poles", ["z=1/sin(40*u*v)", "-o", "a.png"]),
        Case("noise", ["z=sin(1e6*u*v)*cos(1e5*u)", "-o", "a.png"]),
        Case("steps", ["z=floor(30*u)*floor(30*v)", "-o", "a.png"]),
        Case("noise, checked", ["check", "z=sin(1/(u*v))"]),
        Case("the tightest tolerance", ["torus", "--tolerance", "1e-9", "-o", "a.ply"],
             says="limit of triangles"),
        Case("more triangles than memory", ["torus", "--tolerance", "1e-9", "--max-triangles",
                                            "1000000000", "--max-memory", "2GB", "-o", "a.ply"],
             says="stopped refinement"),
        Case("more samples than memory", ["torus", "--samples", "8192x8192", "--max-memory", "2GB",
                                          "-o", "a.ply"], statuses=(1,), says="out of memory"),
        Case("a texture of 16384x16384", DRAW, lambda: {
            "s.toml": '[[surface]]\nz="u"\ntexture="e.png"\n', "e.png": png(side=16384)},
             statuses=(2,), says="8192x8192"),
        Case("the largest texture", DRAW, lambda: {
            "s.toml": '[[surface]]\nz="u"\ntexture="e.png"\n', "e.png": png(side=8192)}),
        Case("a picture of white", ["e.png", "-o", "a.png"], lambda: {"e.png": png(side=16384)},
             statuses=(2,), says="holds no scene", seconds=10, bytes=1.6 * GIGABYTE),
    ]


NAMES = ["torus", "sphere", "mobius", "nothing", "s.toml", "z=u*v", "z=1/u", "z=sin(u*t)", "z=",
         "x=cos(u)", "u=0:1", "v=1:0", "a=2", "a=b", "+", "curve", "point", "1,2,3", "check", "show",
         "list", "z=foo(u)", "z=u,v", "\x1b[31m", "z=(u", "π", ""]
VALUES = ["0", "1", "-1", "0.5", "1e400", "nan", "16x16", "64x48", "0x0", "99999x2", "a", "off",
          "auto", "1,2,3", "1,2", "0:1", "1:0", "red", "#12345", "transparent", "0.5px", "\x1b]0;x",
          "", "2GB", "u", "t", "gauss", "paper", "%d", "../", "/nonexistent/a.png"]
OPTIONS = ["--view", "--tolerance", "--samples", "--grid", "--opacity", "--front", "--color",
           "--colormap", "--contours", "--clip", "--scale", "--theme", "--title", "--axes",
           "--shading", "--specular", "--antialias", "--t", "--frames", "--frame-range", "--fps",
           "--strict", "-q", "-v", "--report", "--threads", "--max-time", "--max-memory",
           "--max-triangles", "--normal-tolerance", "--fov", "--ortho", "--flip", "--radius",
           "--no-such-option", "--line-width", "--background", "--up", "--target", "--distance"]
OUTPUTS = ["a.png", "b.ply", "c.toml", "f%d.png", "d.xyz", "a.gif"]


def command_lines(source, count):
    """Small runs: the size and the frames are bounded, whatever else is asked for."""
    for _ in range(count):
        words = [source.choice(NAMES) for _ in range(source.randint(1, 3))]
        for _ in range(source.randint(0, 4)):
            words.append(source.choice(OPTIONS))
            if source.random() < 0.85:
                words.append(source.choice(VALUES))
        for output in source.sample(OUTPUTS, source.randint(1, 2)):
            words += ["-o", output]
        has_frames = any(word in ("f%d.png", "a.gif") for word in words)
        yield [*words, "-s", "48x32", *(["--frames", "2"] if has_frames else [])]
