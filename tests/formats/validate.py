#!/usr/bin/python3 -B
"""Surfaces in each format of meshes, read by the programs that users have. Usage: validate.py SADDLE
[--write] [WORD...]: the gallery, or its surfaces called WORD, else those with WORD in their names.
Each surface is read as it is, and as a solid. --write puts the table into docs/FORMATS.md. Exit 1
if a file is not as it should be, 77 if none of the programs is there.

Each reader is given what it is for: admesh and slicers judge solids, and triangles of all others."""
import contextlib
import ctypes.util
import json
import os
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
PACKAGES = ROOT / "build/mesh-readers/node_modules"
THICKNESS = 0.01  # of solids, as a share of the diagonal
BEGIN = "<!-- begin: made by ./dev formats --write -->\n"
END = "<!-- end -->"
SKIPPED = 77
FORMATS = ("ply", "stl", "obj", "glb", "3mf")
GLTF_SCRIPT = """
const validator = require('gltf-validator'), fs = require('fs');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])), {maxIssues: 20})
  .then(report => console.log(JSON.stringify(report.issues)));
"""
# Stands in for a browser: pictures are taken as read. Prints a line of JSON for each object.
THREE_SCRIPT = """
import fs from 'node:fs';
globalThis.self = globalThis;
globalThis.createImageBitmap = async () => ({width: 1, height: 1, close() {}});
const loaders = await Promise.all(['GLTF', 'OBJ'].map(
  name => import(`three/addons/loaders/${name}Loader.js`)));
const bytes = fs.readFileSync(process.argv[1]);
const root = process.argv[1].endsWith('.obj') ? new loaders[1].OBJLoader().parse(bytes.toString())
  : (await new loaders[0].GLTFLoader().parseAsync(new Uint8Array(bytes).buffer, '')).scene;
root.traverse(object => {
  const {geometry, material, type} = object;
  if (geometry) console.log(JSON.stringify({type, color: [material].flat()[0].color.getHexString(),
    has_picture: !!material.map,
    has_normals: !!geometry.attributes.normal, corners: (geometry.index ?? geometry.attributes.position).count}));
});
"""
# Reads the files that its input names, and prints a line of JSON for each. Debian's Blender imports
# glTF only with a name that newer numpys have no more.
BLENDER_SCRIPT = """
import json, sys
import bpy, numpy
numpy.bool = bool
def seen(thing):
    mesh = thing.data
    mesh.calc_loop_triangles()
    return {'triangles': len(mesh.loop_triangles), 'materials': len(mesh.materials),
            'has_normals': mesh.has_custom_normals,
            'has_lines': any(edge.is_loose for edge in mesh.edges)}
for line in sys.stdin:
    file = line.strip()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    read = bpy.ops.import_scene.obj if file.endswith('.obj') else bpy.ops.import_scene.gltf
    try:
        read(filepath=file)
        found = [seen(thing) for thing in bpy.data.objects if thing.type == 'MESH']
    except RuntimeError as error:
        found = str(error)
    print('read:' + json.dumps(found), flush=True)
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


def wrong_count(triangles, faces):
    """A complaint, unless it is all of them; programs leave out triangles without area."""
    return [] if faces * 0.999 <= triangles <= faces else [f"{triangles} triangles of {faces}"]


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
        return Image and shutil.which("f3d") and shutil.which("Xvfb")

    def check(self, file, ply):
        picture = file.with_suffix(".f3d.png")
        # Its usual view is along a side of the scene; many surfaces are flat from there.
        output_of("f3d", str(file), "--output", str(picture), "--resolution",
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
        return shutil.which("node") and (PACKAGES / "gltf-validator").is_dir()

    def check(self, file, ply):
        issues = json.loads(output_of("node", "-e", GLTF_SCRIPT, str(file), cwd=PACKAGES.parent))
        bad = [m for m in issues["messages"] if m["severity"] < 2]
        if issues["numErrors"] or issues["numWarnings"]:
            return [f"{m['code']} at {m.get('pointer')}" for m in bad[:3]]
        return []


class Three:
    """Meshes with normals, of saddle's colours, and lines beside them."""
    name = "three.js"

    def __init__(self, format):
        self.format = format

    def is_there(self):
        return shutil.which("node") and (PACKAGES / "three").is_dir()

    def check(self, file, ply):
        text = output_of("node", "--input-type=module", "-e", THREE_SCRIPT, str(file),
                         cwd=PACKAGES.parent)
        objects = [json.loads(line) for line in text.splitlines() if line.startswith("{")]
        meshes = [thing for thing in objects if thing["type"] == "Mesh"]
        complaints = [f"{thing['type']} object" for thing in objects
                      if thing["type"] not in ("Mesh", "LineSegments")]
        if not all(thing["has_normals"] for thing in meshes):
            complaints.append("a mesh without normals")
        if len(objects) == len(meshes):
            complaints.append("no lines")
        if self.format == "obj":  # its materials are another file's
            triangles = sum(thing["corners"] for thing in meshes) // 3
            return complaints + wrong_count(triangles, ply.faces)
        triangles = {}
        for thing in meshes:
            color = "picture" if thing["has_picture"] else thing["color"]
            triangles[color] = triangles.get(color, 0) + thing["corners"] // 3
        if "picture" not in triangles and not {"ffff80"} <= triangles.keys():
            complaints.append(f"colours {' '.join(triangles)}, without the front's")
        if ply.is_thick:
            return complaints + wrong_count(sum(triangles.values()), ply.faces)
        if "8080ff" in triangles and triangles["8080ff"] != triangles["ffff80"]:
            complaints.append("sheets of different triangles")
        triangles.pop("8080ff", None)
        return complaints + wrong_count(sum(triangles.values()), ply.faces)


class Blender:
    """All triangles, with normals of their own, with materials, and lines as edges without faces."""
    name = "Blender"
    process = None  # one for all files: it takes long to start

    def __init__(self, format):
        self.format = format

    def is_there(self):
        return shutil.which("blender")

    def read(self, file):
        if not Blender.process:
            Blender.process = subprocess.Popen(
                ["blender", "--background", "--factory-startup", "--python-expr", BLENDER_SCRIPT],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        print(file, file=Blender.process.stdin, flush=True)
        for line in Blender.process.stdout:
            if line.startswith("read:"):
                return json.loads(line[5:])
        Blender.process = None
        raise ValueError("Blender ends")

    def check(self, file, ply):
        objects = self.read(file)
        if isinstance(objects, str):
            return [objects.strip()]
        meshes = [thing for thing in objects if thing["triangles"]]
        triangles = sum(thing["triangles"] for thing in meshes)
        complaints = []
        if not all(thing["has_normals"] for thing in meshes):
            complaints.append("normals of its own")
        if not all(thing["materials"] for thing in objects):
            complaints.append("no materials")
        if not any(thing["has_lines"] for thing in objects):
            complaints.append("no lines")
        sheets = 2 if triangles > ply.faces else 1  # of a GLB: front, or front and back
        return complaints + wrong_count(triangles, sheets * ply.faces)


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


READERS = [Admesh(), Prusa("obj"), Prusa("3mf"), Lib3mf(), GltfValidator(), Three("obj"),
           Three("glb"), Blender("obj"), Blender("glb"), F3d("stl"), F3d("obj"), F3d("glb"),
           Assimp("stl"), Assimp("obj"), Assimp("glb")]


class Written:
    """A surface in all formats, and what saddle says of it."""

    def __init__(self, saddle, arguments, folder):
        self.is_thick = "--thickness" in arguments
        outputs = [word for format in FORMATS for word in ("-o", str(folder / f"a.{format}"))]
        done = subprocess.run([saddle, *arguments, *outputs, "--report", str(folder / "a.json")],
                              capture_output=True, text=True)
        if done.returncode != 0:
            raise ValueError(done.stderr)
        self.is_solid = "no solid that can be printed" not in done.stderr
        self.is_two_sided = "one-sided" not in done.stderr
        report = json.loads((folder / "a.json").read_text())["surfaces"][0]
        low, high = report["bounds"]
        self.diagonal = sum((b - a) ** 2 for a, b in zip(low, high)) ** 0.5
        with open(folder / "a.ply", "rb") as ply:
            head = ply.read(1 << 16)
        self.faces = int(re.search(rb"element face (\d+)", head)[1])


def programs_of(readers):
    """Readers of each program, in their order."""
    programs = {}
    for reader in readers:
        programs.setdefault(reader.name, []).append(reader)
    return programs


def column_of(program, readers):
    return f"{program} ({', '.join(reader.format.upper() for reader in readers)})"


def complaints_of(written, folder, readers):
    """By program; None where it is given nothing."""
    result = {}
    for program, own in programs_of(readers).items():
        result[program] = None
        for reader in own:
            try:
                faults = reader.check(folder / f"a.{reader.format}", written)
            except ValueError as error:
                faults = [str(error).replace("\n", " ")]
            if faults is not None:
                result[program] = (result[program] or []) + [
                    f"{reader.format.upper()}: {fault}" for fault in faults]
    return result


def row_of(saddle, name, readers):
    """Cells of the table, by column, and complaints."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        written = Written(saddle, [name], folder)
        kind = "solid" if written.is_solid else "one-sided" if not written.is_two_sided else "open"
        found = complaints_of(written, folder, readers)
        thickness = f"{THICKNESS * written.diagonal:.3g}"
        thick = Written(saddle, [name, "--thickness", thickness], folder)
        of_solid = complaints_of(thick, folder, readers)
    if not thick.is_solid:
        of_solid["saddle"] = ["no solid"]
    complaints = [f"{name}: {program}: {fault}"
                  for program, faults in found.items() for fault in faults or []]
    complaints += [f"{name} --thickness {thickness}: {program}: {fault}"
                   for program, faults in of_solid.items() for fault in faults or []]
    cells = [name, str(written.faces), kind]
    cells += ["" if faults is None else "; ".join(faults) or "good" for faults in found.values()]
    cells.append("; ".join(f"{program}: {fault}" for program, faults in of_solid.items()
                           for fault in faults or []) or "good")
    return cells, complaints


@contextlib.contextmanager
def display():
    """A display without a screen, for programs that open windows."""
    if not shutil.which("Xvfb"):
        yield
        return
    pipe, end = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(end), "-screen", "0", "640x480x24"],
                              pass_fds=[end], stderr=subprocess.DEVNULL)
    os.close(end)
    try:
        with os.fdopen(pipe) as number:
            os.environ["DISPLAY"] = ":" + number.readline().strip()
        yield
    finally:
        server.terminate()
        server.wait()


def table(rows, readers):
    heads = ["surface", "triangles", "is",
             *(column_of(program, own) for program, own in programs_of(readers).items()),
             "as a solid: all"]
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
            print(f"SKIPPED: {column_of(reader.name, [reader])}, which is not installed", file=sys.stderr)
    if not readers:
        sys.exit(SKIPPED)
    names = output_of(saddle, "list").split()
    if words:
        names = [name for name in names if name in words or any(
            word in name for word in words if word not in names)]
    if not names:
        sys.exit("no surface has such a name")
    rows, complaints = [], []
    with display():
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
