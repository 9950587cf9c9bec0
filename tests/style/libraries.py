#!/usr/bin/python3 -B
"""Each library stays where it can be replaced: in one file, or one folder, of src/."""
import re

import tree

# What is included -> where it may be. muparser is the language's grammar in the parser, and in the
# study a method that others are compared with. std::cout and std::cerr are in the one file that keeps
# control characters from terminals.
HOMES = {
    r"muParser\w*\.h": r"src/formula/program\.cpp|src/study/muparser_method\.cpp|tests/.*",
    r"GL/osmesa\.h": r"src/render/gl/context_osmesa\.cpp",
    r"EGL/.*": r"src/render/gl/context_egl\.cpp",
    r"(glad|GL|GLES\d|EGL)/.*": r"src/render/.*|tests/image/.*",
    r"iostream": r"src/base/standard_streams\.cpp|tests/.*",
    r"toml\+\+/.*": r"src/scene/toml/toml\.cpp",
    r"GLFW/.*|backends/imgui.*": r"src/view/window/(window|events)\.cpp",
    r"imgui.*": r"src/view/panel/(.*\.cpp|colors\.h)|src/view/window/(window|draw_lists)\.cpp",
    r"stb_truetype\.h": r"src/render/overlay/font\.cpp",
    r"zlib\.h": r"src/base/(png_pixels|deflate|packed_text)\.cpp|tests/.*",
    r"png\.h": r"src/base/image_png\.cpp|tests/.*",
}
INCLUDE = re.compile(r'\s*#\s*include\s*[<"]([^>"]+)[>"]')


def complaints(name):
    for number, line in tree.lines(name):
        match = INCLUDE.match(line)
        home = match and next((h for lib, h in HOMES.items() if re.fullmatch(lib, match[1])), None)
        if home and not re.fullmatch(home, name.as_posix()):
            yield f"{name}:{number}: <{match[1]}> belongs in {home}"


sources = [name for name in tree.files("src", "tests") if name.suffix in {".h", ".cpp", ".def"}]
tree.finish((c for name in sources for c in complaints(name)), len(sources), "sources")
