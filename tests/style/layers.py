#!/usr/bin/python3 -B
"""A file of src/ includes only files of its own folder and of lower ones."""
import re

import tree

LAYERS = ["base", "formula", "eval", "surface", "mesh", "scene", "meshing", "render", "export",
          "study", "view", "app"]
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')


def complaints(name):
    layer = name.parts[1]
    if layer not in LAYERS or len(name.parts) != 3:
        yield f"{name}: not in a folder that is a layer: {' '.join(LAYERS)}"
        return
    for number, line in tree.lines(name):
        match = INCLUDE.match(line)
        if not match:
            continue
        other = match[1].split("/")[0]
        if not (tree.ROOT / "src" / match[1]).is_file():
            yield f'{name}:{number}: "{match[1]}" is no file of src/; libraries go in <>'
        elif LAYERS.index(other) > LAYERS.index(layer):
            yield f"{name}:{number}: {layer}/ is below {other}/ and cannot include {match[1]}"


sources = [name for name in tree.files("src") if name.suffix != ".md"]
tree.finish((c for name in sources for c in complaints(name)), len(sources), "files of src/")
