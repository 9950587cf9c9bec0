#!/usr/bin/python3 -B
"""glslangValidator accepts every shader, alone and as the program puts it together: with the
constants of a scene in front, vertex and fragment shader linked; and the library of functions that
printed formulas call, as part of a fragment shader."""
import pathlib
import subprocess

import tree

# What the program may define, by the name that a shader asks for with #ifndef.
VARIANTS = {
    "LIGHT_COUNT": [
        ["LIGHT_COUNT=0", "LIGHTS="],
        ["LIGHT_COUNT=1", "LIGHTS=POINT(0)"],
        ["LIGHT_COUNT=1", "LIGHTS=DIRECTIONAL(0)", "SPECULAR"],
        ["LIGHT_COUNT=2", "LIGHTS=POINT(0) DIRECTIONAL(1)", "TWO_MATERIALS"],
        ["LIGHT_COUNT=2", "LIGHTS=POINT(0) POINT(1)", "SPECULAR", "TWO_MATERIALS",
         "ORTHOGRAPHIC"],
    ],
}


def validate(shaders, defines):
    command = ["glslangValidator", "-l", *(f"-D{define}" for define in defines)]
    done = subprocess.run(command + [str(tree.ROOT / name) for name in shaders],
                          capture_output=True, text=True)
    if done.returncode:
        yield f"{' '.join(map(str, shaders))} with {defines or 'its defaults'}:\n{done.stdout}"


def complaints(fragment):
    text = (tree.ROOT / fragment).read_text()
    vertex = fragment.with_name(fragment.name.replace(".frag.", ".vert."))
    variants = [v for name, vs in VARIANTS.items() if f"#ifndef {name}" in text for v in vs]
    for defines in [[], *variants]:
        yield from validate([vertex, fragment], defines)


def library_complaints(name):
    text = "#version 330 core\n" + (tree.ROOT / name).read_text() + "\nvoid main() {}\n"
    done = subprocess.run(["glslangValidator", "--stdin", "-S", "frag"], input=text,
                          capture_output=True, text=True)
    if done.returncode:
        yield f"{name}, one line below its own numbers:\n{done.stdout}"


LIBRARIES = [pathlib.Path("shaders/functions.glsl")]
shaders = [name for name in tree.files("shaders") if name.suffix == ".glsl"]
fragments = [name for name in shaders if ".frag." in name.name]
unpaired = [f"{name}: neither X.vert.glsl nor X.frag.glsl of a pair" for name in shaders
            if name not in LIBRARIES and not all((tree.ROOT / name.with_name(name.name.split(".")[0] + s)).is_file()
                       for s in (".vert.glsl", ".frag.glsl"))]
broken = [c for name in fragments for c in complaints(name)]
broken += [c for name in LIBRARIES for c in library_complaints(name)]
tree.finish(unpaired + broken, len(shaders), "shaders")
