#!/usr/bin/python3 -B
"""Surfaces in each format of meshes, read by the programs that users have. Usage: validate.py SADDLE
[--write] [WORD...]: the gallery, or its surfaces with a WORD. --write puts the table into
docs/FORMATS.md. Exit 1 if a file is not as it should be, 77 if none of the programs is there.

Each reader is given what it is for: admesh and slicers judge solids, and triangles of all others."""
import ctypes.util
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

try:
    from PIL import Image
except ImportError:
    Image = None  # f3d's pictures are not looked at

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/FORMATS.md"
VALIDATOR = ROOT / "build/gltf-validator"
BEGIN = "<!-- begin: made by ./dev formats --write -->\n"
END = "<!-- end -->"
SKIPPED = 77
FORMATS = ("ply", "stl", "obj", "glb", "3mf")
GLTF_SCRIPT = """
const validator = require('gltf-validator'), fs = require('fs');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])), {maxIssues: 20})
  .then(report => console.log(JSON.stringify(report.issues)));
"""


def output_of(*command, **more):
    """What a program prints. A program that fails is a complaint."""
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", **more)
    if done.returncode != 0:
        raise ValueError(f"{command[0]} fails: {(done.stderr or done.stdout).strip()[-200:]}")
    return done.stdout + done.stderr


def number(pattern, text, what):
    match = re.search(pattern, text)
    if not match:
        raise ValueError(f"no {what}")
    return int(match[1])


class Admesh:
    """Facets that do not fit to their neighbours, and all that it would have to repair."""
    name, format = "admesh", "stl"

    def is_there(self):
        return shutil.which("admesh")

    def check(self, file, ply):
        # Without its repair of holes, which turns what it has closed.
        text = output_of("admesh", "-e", "-d", "-v", str(file))
        faults = {what: number(what + r"\s*:\s*(\d+)", text, what)
                  for what in ("Degenerate facets", "Facets reversed", "Backwards edges",
                               "Normals fixed")}
        if ply.is_solid:
            faults["Total disconnected facets"] = number(r"disconnected facets\s*:\s*(\d+)", text,
                                                         "disconnected facets")
        if faults["Normals fixed"] <= ply.faces // 1000:
            faults["Normals fixed"] = 0  # it computes those of needles in single precision
        if not ply.is_two_sided:
            for what in ("Facets reversed", "Backwards edges", "Normals fixed"):
                del faults[what]
        return [f"{what.lower()}: {count}" for what, count in faults.items() if count]


class Assimp:
    """Reads all of the triangles."""

    def __init__(self, format):
        self.name, self.format = "assimp", format

    def is_there(self):
        return shutil.which("assimp")

    def check(self, file, ply):
        faces = number(r"Faces:\s*(\d+)", output_of("assimp", "info", str(file)), "faces")
        if faces < ply.faces * 0.999:  # it leaves out triangles without area
            return [f"{faces} faces of {ply.faces}"]
        return []


class F3d:
    """Shows the surface: a part of the picture is another colour than its corner, as in saddle's."""
    name = "f3d"
    LEAST = 0.01  # of the picture: a thin surface from its side

    def __init__(self, format):
        self.format = format

    def is_there(self):
        return Image and shutil.which("f3d") and shutil.which("xvfb-run")

    def check(self, file, ply):
        picture = file.with_suffix(".f3d.png")
        # Its usual view is along a side of the scene; many surfaces are flat from there.
        output_of("xvfb-run", "-a", "f3d", str(file), "--output", str(picture), "--resolution",
                  "300,300", "--camera-azimuth-angle", "30", "--camera-elevation-angle", "30")
        with Image.open(picture) as image:
            pixels = list(image.convert("RGB").getdata())
        shown = sum(pixel != pixels[0] for pixel in pixels) / len(pixels)
        return [] if shown >= self.LEAST else [f"{shown:.1%} of the picture"]


class Prusa:
    """A manifold, where saddle says that it is a solid."""

    def __init__(self, format):
        self.name, self.format = "PrusaSlicer", format

    def is_there(self):
        return shutil.which("prusa-slicer")

    def check(self, file, ply):
        if not ply.is_solid:
            return None
        text = output_of("prusa-slicer", "--info", str(file))
        return [] if "manifold = yes" in text else ["no manifold"]


class GltfValidator:
    """Khronos' own: no errors and no warnings."""
    name, format = "glTF-Validator", "glb"

    def is_there(self):
        return shutil.which("node") and (VALIDATOR / "node_modules/gltf-validator").is_dir()

    def check(self, file, ply):
        issues = json.loads(output_of("node", "-e", GLTF_SCRIPT, str(file), cwd=VALIDATOR))
        bad = [m for m in issues["messages"] if m["severity"] < 2]
        if issues["numErrors"] or issues["numWarnings"]:
            return [f"{m['code']} at {m.get('pointer')}" for m in bad[:3]]
        return []


class Lib3mf:
    """The reference reader in strict mode: no warnings; solids are manifold and oriented."""
    name, format = "lib3mf, strict", "3mf"

    def __init__(self):
        path = ctypes.util.find_library("3MF")
        self.library = ctypes.CDLL(path) if path else None

    def is_there(self):
        return self.library

    def call(self, function, *arguments):
        result = getattr(self.library, "lib3mf_" + function)(*arguments)
        if result != 0:
            raise ValueError(f"{function} fails: {result & 0xffffffff:#x}")

    def check(self, file, ply):
        model, reader, objects, mesh = (ctypes.c_void_p() for _ in range(4))
        count, more, good = ctypes.c_uint32(), ctypes.c_int(), ctypes.c_int()
        self.call("createmodel", ctypes.byref(model))
        try:
            self.call("model_queryreader", model, b"3mf", ctypes.byref(reader))
            self.call("reader_setstrictmodeactive", reader, 1)
            self.call("reader_readfromfileutf8", reader, str(file).encode())
            self.call("reader_getwarningcount", reader, ctypes.byref(count))
            if count.value:
                return [f"{count.value} warnings"]
            self.call("model_getmeshobjects", model, ctypes.byref(objects))
            self.call("resourceiterator_movenext", objects, ctypes.byref(more))
            if not more.value:
                return ["no meshes"]
            self.call("resourceiterator_getcurrent", objects, ctypes.byref(mesh))
            self.call("meshobject_ismanifoldandoriented", mesh, ctypes.byref(good))
            return ["not manifold and oriented"] if ply.is_solid and not good.value else []
        finally:
            for thing in (mesh, objects, reader, model):
                if thing:
                    self.library.lib3mf_release(thing)


READERS = [Admesh(), Prusa("obj"), Prusa("3mf"), Assimp("obj"), Assimp("stl"), Assimp("glb"),
           F3d("stl"), F3d("obj"), F3d("glb"), GltfValidator(), Lib3mf()]


class Written:
    """A surface in all formats, and what saddle says of it."""

    def __init__(self, saddle, arguments, folder):
        outputs = [word for format in FORMATS for word in ("-o", str(folder / f"a.{format}"))]
        done = subprocess.run([saddle, *arguments, *outputs], capture_output=True, text=True)
        if done.returncode != 0:
            raise ValueError(done.stderr)
        self.is_solid = "no solid that can be printed" not in done.stderr
        self.is_two_sided = "one-sided" not in done.stderr
        with open(folder / "a.ply", "rb") as ply:
            head = ply.read(1 << 16)
        self.faces = int(re.search(rb"element face (\d+)", head)[1])


def column_of(reader):
    return f"{reader.format.upper()}: {reader.name}"


def row_of(saddle, name, readers):
    """Cells of the table, by column, and complaints."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        written = Written(saddle, [name], folder)
        kind = "solid" if written.is_solid else "one-sided" if not written.is_two_sided else "open"
        cells, complaints = [name, str(written.faces), kind], []
        for reader in readers:
            try:
                faults = reader.check(folder / f"a.{reader.format}", written)
            except ValueError as error:
                faults = [str(error).replace("\n", " ")]
            cells.append("" if faults is None else "; ".join(faults) or "good")
            complaints += [f"{name}: {column_of(reader)}: {fault}" for fault in faults or []]
    return cells, complaints


def table(rows, readers):
    heads = ["surface", "triangles", "is", *map(column_of, readers)]
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n" + "".join("| " + " | ".join(line) + " |\n" for line in lines) + "\n"


def write_page(text):
    page = PAGE.read_text(encoding="utf-8")
    before, _, rest = page.partition(BEGIN)
    PAGE.write_text(before + BEGIN + text + END + rest.partition(END)[2], encoding="utf-8")


def main():
    saddle, *words = sys.argv[1:]
    write = "--write" in words
    words = [word for word in words if word != "--write"]
    readers = [reader for reader in READERS if reader.is_there()]
    for reader in READERS:
        if reader not in readers:
            print(f"SKIPPED: {column_of(reader)}, which is not installed", file=sys.stderr)
    if not readers:
        sys.exit(SKIPPED)
    names = output_of(saddle, "list").split()
    if words:
        names = [name for name in names if any(word in name for word in words)]
    if not names:
        sys.exit("no surface has such a name")
    rows, complaints = [], []
    for name in names:
        cells, wrong = row_of(saddle, name, readers)
        rows.append(cells)
        complaints += wrong
        print(" | ".join(cells), flush=True)
    if write:
        write_page(table(rows, readers))
    for complaint in complaints:
        print("WRONG:", complaint)
    print(f"{len(names)} surfaces, {len(readers)} readers, {len(complaints)} complaints")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
