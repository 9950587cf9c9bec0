#!/usr/bin/python3 -B
"""Where tests of a source are: src/FOLDER/NAME has its tests in FOLDER/NAME_test.cpp of tests/unit or
tests/geometry. Files about a behaviour that several sources share are listed here."""
import tree

# What else the programs' folders hold.
FOLDERS = {"geometry": {"gallery"}}
BEHAVIOURS = {
    "geometry/mesh/bounded_work",
    "geometry/mesh/crossing_jumps",
    "geometry/mesh/cuts",
    "geometry/mesh/grid_mesh_report",
    "geometry/mesh/jump_curves",
    "geometry/mesh/jump_lines",
    "geometry/mesh/parallel_jumps",
    "geometry/mesh/poles",
    "geometry/mesh/rims",
    "geometry/mesh/scales",
    "geometry/mesh/seams",
    "geometry/mesh/small_features",
    "geometry/meshing/close_up",
    "geometry/meshing/dependent_domain",
    "unit/scene/scenes_page",
}


def complaints(names):
    tests = set()
    for name in names:
        program, *folders = name.parent.parts[1:]
        own = FOLDERS.get(program, set())
        if len(folders) != 1 or not ((tree.ROOT / "src" / folders[0]).is_dir() or folders[0] in own):
            yield f"{name}: not in a folder of tests/{program}/ that src/ has too"
        elif folders[0] not in own and name.stem.endswith("_test"):
            source = name.stem.removesuffix("_test")
            tests.add(f"{program}/{folders[0]}/{source}")
            units = (tree.ROOT / "src" / folders[0]).rglob(f"{source}.*")  # in its rooms, too
            if not any(path.suffix in {".h", ".cpp"} for path in units):
                if f"{program}/{folders[0]}/{source}" not in BEHAVIOURS:
                    yield f"{name}: there is no src/{folders[0]}/{source}.h or .cpp"
    yield from (f"tests/{missing}_test.cpp: listed, and not there"
                for missing in sorted(BEHAVIOURS - tests))


sources = list(tree.files("tests/unit", "tests/geometry"))
tree.finish(complaints(sources), len(sources), "files of tests")
