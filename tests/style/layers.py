#!/usr/bin/python3 -B
"""The structure of src/. A folder is a layer, or a room of a layer; a file includes only files of its
own folder and of earlier ones. A unit is a source and its header. No units include each other in a
circle, a folder holds a limited number of units, and chains of includes within the mesher are short."""
import collections
import re

import tree

LAYERS = {
    "base": "", "formula": "", "eval": "", "surface": "",
    "mesh": "model proof features sizing grid tree distance error mesher color curve solid",
    "scene": "model toml options files",
    "meshing": "",
    "render": "gl shading overlay picture",
    "export": "", "study": "",
    "view": "model picture panel window",
    "app": "command_line report run commands",
}
FOLDERS = [f"{layer}/{room}" for layer, rooms in LAYERS.items() for room in rooms.split() or [""]]
FOLDERS = [folder.rstrip("/") for folder in FOLDERS] + ["app"]  # main.cpp
UNITS_IN_A_FOLDER = 33  # of src/export; the aim is 25, with rooms in it
LONG_FILE = 400  # lines
LONG_FILES = 4
INCLUDE_DEPTH = {"mesh": 9}  # the longest chain of includes within a layer, its source included
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')


def included(name):
    """The line number and the path below src/ of each file that a source includes."""
    for number, line in tree.lines(name):
        if match := INCLUDE.match(line):
            yield number, match[1]


def folder_of(path):
    return path.rpartition("/")[0]


def unit_of(path):
    return path.rpartition(".")[0]


def wrong_includes(files, includes):
    for file in files:
        if folder_of(file) not in FOLDERS:
            yield f"src/{file}: not in a folder that is a layer or a room: {' '.join(FOLDERS)}"
            continue
        for number, other in includes[file]:
            if other not in includes:
                yield f'src/{file}:{number}: "{other}" is no file of src/; libraries go in <>'
            elif FOLDERS.index(folder_of(other)) > FOLDERS.index(folder_of(file)):
                yield (f"src/{file}:{number}: {folder_of(file)}/ is below {folder_of(other)}/ and "
                       f"cannot include {other}")


def circles(includes):
    """The groups of units of which each includes, by way of others, all others (the strongly
    connected components: R. Tarjan, 'Depth-first search and linear graph algorithms', 1972)."""
    graph = collections.defaultdict(set)
    for file, others in includes.items():
        graph[unit_of(file)].update(unit_of(other) for _, other in others)
    number, low, open_units, found = {}, {}, [], []

    def visit(unit):
        number[unit] = low[unit] = len(number)
        open_units.append(unit)
        for other in graph.get(unit, ()):
            if other not in number:
                visit(other)
            if other in open_units:
                low[unit] = min(low[unit], low[other])
        if low[unit] == number[unit]:
            at = open_units.index(unit)
            if len(open_units) > at + 1:
                found.append(sorted(open_units[at:]))
            del open_units[at:]

    for unit in list(graph):
        if unit not in number:
            visit(unit)
    for units in found:
        yield f"src/{units[0]}: includes itself by way of others: {' '.join(units)}"


def deep_includes(includes):
    depths = {}

    def depth(file, layer):
        if file not in depths:
            depths[file] = 1 + max((depth(other, layer) for _, other in includes[file]
                                    if other.startswith(f"{layer}/")), default=0)
        return depths[file]

    for layer, limit in INCLUDE_DEPTH.items():
        for file in includes:
            if file.startswith(f"{layer}/") and depth(file, layer) > limit:
                yield f"src/{file}: includes {depths[file]} files of {layer}/ deep, {limit} at most"


def crowded_folders(files):
    units = collections.defaultdict(set)
    for file in files:
        units[folder_of(file)].add(unit_of(file))
    for folder, inside in units.items():
        if len(inside) > UNITS_IN_A_FOLDER:
            yield f"src/{folder}: {len(inside)} units, {UNITS_IN_A_FOLDER} at most"


def long_files(files):
    lengths = sorted((len(list(tree.lines(f"src/{file}"))), file) for file in files)
    long = [(count, file) for count, file in lengths if count > LONG_FILE]
    if len(long) > LONG_FILES:
        yield (f"src/: more than {LONG_FILES} files of over {LONG_FILE} lines: "
               f"{', '.join(f'{file} {count}' for count, file in long)}")


def complaints(files):
    includes = {file: list(included(f"src/{file}")) for file in files}
    yield from wrong_includes(files, includes)
    includes = {file: [(n, other) for n, other in others if other in includes]
                for file, others in includes.items()}
    wrong = list(circles(includes))
    yield from wrong
    if not wrong:
        yield from deep_includes(includes)
    yield from crowded_folders(files)
    yield from long_files(files)


sources = [str(name.relative_to("src")) for name in tree.files("src")
           if name.suffix not in {".md", ".svg", ".js", ".css"}]
tree.finish(complaints(sources), len(sources), "files of src/")
