"""Distances of points to a triangle mesh, by nearest.cpp, which is compiled when it is first needed."""
import ctypes
import hashlib
import os
import pathlib
import subprocess
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent


def _library():
    source = HERE / "nearest.cpp"
    name = "nearest-" + hashlib.sha256(source.read_bytes()).hexdigest()[:16] + ".so"
    folder = HERE.parents[1] / "build" / "honesty"
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        folder = pathlib.Path(tempfile.gettempdir())
    path = folder / name
    if not path.exists():
        own = path.with_suffix(f".{os.getpid()}")
        subprocess.run(["g++", "-std=c++20", "-O2", "-shared", "-fPIC", str(source), "-o", str(own)],
                       check=True)
        own.rename(path)
    library = ctypes.CDLL(str(path))
    library.tree_new.restype = ctypes.c_void_p
    library.tree_new.argtypes = [ctypes.c_void_p, ctypes.c_int64, ctypes.c_void_p, ctypes.c_int64]
    library.tree_delete.argtypes = [ctypes.c_void_p]
    library.tree_distances.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64,
                                       ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]
    return library


class Triangles:
    """Nearest triangles of a mesh."""
    library = None

    def __init__(self, points, triangles):
        if Triangles.library is None:
            Triangles.library = _library()
        points = np.ascontiguousarray(points, dtype=float)
        triangles = np.ascontiguousarray(triangles, dtype=np.int32)
        self.handle = self.library.tree_new(points.ctypes.data, len(points), triangles.ctypes.data,
                                            len(triangles))

    def __del__(self):
        if getattr(self, "handle", None):
            self.library.tree_delete(self.handle)

    def distances(self, points, enough=0.0):
        """Distances, 0 for points that are not finite, and the nearest triangles. A distance up to
        `enough` is an upper bound."""
        points = np.asarray(points, dtype=float).reshape(-1, 3)
        finite = np.flatnonzero(np.isfinite(points).all(axis=1))
        distances, triangles = np.zeros(len(points)), np.zeros(len(points), dtype=np.int32)
        if len(finite):
            order = finite[_in_blocks(points[finite])]
            given = np.ascontiguousarray(points[order])
            found, nearest = np.empty(len(given)), np.empty(len(given), dtype=np.int32)
            self.library.tree_distances(self.handle, given.ctypes.data, len(given), enough,
                                        found.ctypes.data, nearest.ctypes.data)
            distances[order], triangles[order] = found, nearest
        return distances, triangles


def _in_blocks(points):
    """An order in which neighbours follow each other: block by block of 64 each way."""
    low, high = points.min(axis=0), points.max(axis=0)
    cells = ((points - low) / np.where(high > low, high - low, 1) * 63).astype(np.int64)
    cells[:, 1] = np.where(cells[:, 0] % 2 == 0, cells[:, 1], 63 - cells[:, 1])
    return np.argsort(cells[:, 0] * 4096 + cells[:, 1] * 64 + cells[:, 2], kind="stable")
