#!/usr/bin/python3 -B
"""glslangValidator accepts every shader, alone and as the program puts it together: with the names
that a scene needs and the lighting in front, vertex and fragment shader linked; and the libraries of
functions, as part of a fragment shader."""
import pathlib
import subprocess
import tempfile

import tree

# Names of shaders/lighting.glsl that a scene may need together, and calls for its lights.
VARIANTS = [
    ([], ""),
    (["LIT", "DIRECTIONAL", "SEE_THROUGH"], "directional_light(0);"),
    (["LIT", "GREY", "AT_EYE", "SPOT", "CONE", "FADES", "AMBIENT", "SPECULAR", "POWERS",
      "HIGHLIGHTS"], "light_at_eye(0); spot_light(1);"),
    (["LIT", "POINT", "SPECULAR", "POWERS", "BLINN", "ORTHOGRAPHIC", "TWO_SIDED"],
     "point_light(0);"),
    (["UNLIT", "COLORED"], ""),
    (["UNLIT", "TWO_SIDED", "TWO_MATERIALS"], ""),
    (["LIT", "POINT", "COLORED"], "point_light(0);"),
    (["LIT", "POINT", "AMBIENT", "SPECULAR", "POWERS", "COLORED", "TWO_SIDED", "TWO_MATERIALS",
      "SEE_THROUGH"], "point_light(0);"),
    (["LIT", "ATTENUATED", "ATTENUATION", "FADES", "AMBIENT", "EMISSION", "NORMAL_MATRIX"],
     "attenuated_light(0);"),
    (["LIT", "SPOT", "SMOOTH_SPOT", "CONE", "FOCUS", "POWERS", "FADES", "AMBIENT", "SPECULAR",
      "HIGHLIGHTS", "ATTENUATION", "EMISSION", "TWO_SIDED", "TWO_MATERIALS"],
     "spot_light(0); smooth_spot_light(1);"),
]


# Fragment shaders that share a vertex shader, which has none of its own.
VERTEX_OF = {"text": "overlay", "color_bar": "overlay", "line": "unlit", "peel": "unlit"}


def vertex_of(fragment):
    stem = fragment.name.split(".")[0]
    return fragment.with_name(VERTEX_OF.get(stem, stem) + ".vert.glsl")


def with_lines(text, lines):
    """The text of a shader with lines after its first, which is #version."""
    version, rest = text.split("\n", 1)
    return f"{version}\n{lines}\n{rest}"


def validate(name, vertex, fragment):
    with tempfile.TemporaryDirectory() as folder:
        files = [pathlib.Path(folder, "a.vert"), pathlib.Path(folder, "a.frag")]
        for file, text in zip(files, (vertex, fragment)):
            file.write_text(text)
        done = subprocess.run(["glslangValidator", "-l", *files], capture_output=True, text=True)
        if done.returncode:
            yield f"{name}:\n{done.stdout}"


def complaints(fragment):
    texts = [(tree.ROOT / name).read_text() for name in
             (vertex_of(fragment), fragment)]
    normal = (tree.ROOT / "shaders/normal.glsl").read_text()
    if "formula_normal(" in texts[0]:
        texts[0] = with_lines(texts[0], normal)
    if "shade(" not in texts[1]:
        yield from validate(fragment, *texts)
        return
    lighting = (tree.ROOT / "shaders/lighting.glsl").read_text()
    yield from validate(fragment, texts[0], with_lines(texts[1], lighting))
    for names, calls in VARIANTS:
        defines = "\n".join(["#define LIGHT_COUNT 2", f"#define LIGHTS {calls}",
                             *(f"#define {name}" for name in names)])
        yield from validate(f"{fragment} with {names}", with_lines(texts[0], defines),
                            with_lines(texts[1], f"{defines}\n{lighting}"))
        exact = f"#define EXACT\n{defines}"
        yield from validate(f"{fragment} exact with {names}", with_lines(texts[0], exact),
                            with_lines(texts[1], f"{exact}\n{normal}\n{lighting}"))
        per_vertex = f"#define PER_VERTEX\n{defines}"
        yield from validate(f"{fragment} per vertex with {names}",
                            with_lines(texts[0], f"{per_vertex}\n{lighting}"),
                            with_lines(texts[1], per_vertex))


def library_complaints(name):
    text = "#version 330 core\n" + (tree.ROOT / name).read_text() + "\nvoid main() {}\n"
    done = subprocess.run(["glslangValidator", "--stdin", "-S", "frag"], input=text,
                          capture_output=True, text=True)
    if done.returncode:
        yield f"{name}, one line below its own numbers:\n{done.stdout}"


LIBRARIES = [pathlib.Path("shaders/functions.glsl"), pathlib.Path("shaders/lighting.glsl"),
             pathlib.Path("shaders/normal.glsl")]
shaders = [name for name in tree.files("shaders") if name.suffix == ".glsl"]
fragments = [name for name in shaders if ".frag." in name.name]
paired = {*fragments, *(vertex_of(name) for name in fragments)}
unpaired = [f"{name}: neither X.vert.glsl nor X.frag.glsl of a pair" for name in shaders
            if name not in LIBRARIES and name not in paired]
unpaired += [f"{name}: no such file" for name in paired if not (tree.ROOT / name).is_file()]
broken = [c for name in fragments for c in complaints(name)]
broken += [c for name in LIBRARIES for c in library_complaints(name)]
tree.finish(unpaired + broken, len(shaders), "shaders")
