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
                                       ctypes.c_void_p, ctypes.c_void_p]
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

    def distances(self, points):
        """Distances, 0 for points that are not finite, and the nearest triangles."""
        points = np.ascontiguousarray(points.reshape(-1, 3), dtype=float)
        finite = np.isfinite(points).all(axis=1)
        given = np.ascontiguousarray(points[finite])
        found, nearest = np.empty(len(given)), np.empty(len(given), dtype=np.int32)
        self.library.tree_distances(self.handle, given.ctypes.data, len(given), found.ctypes.data,
                                    nearest.ctypes.data)
        distances, triangles = np.zeros(len(points)), np.zeros(len(points), dtype=np.int32)
        distances[finite], triangles[finite] = found, nearest
        return distances, triangles
