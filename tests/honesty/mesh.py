"""A PLY file as saddle writes it."""
import numpy as np

TYPES = {"float": "<f4", "double": "<f8", "uchar": "u1", "int": "<i4"}


class Mesh:
    """Points, unit normals, parameters and triangles."""

    def __init__(self, points, triangles, uv, normals=None):
        self.points, self.triangles, self.uv, self.normals = points, triangles, uv, normals


def read_ply(path):
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    fields, counts, element = {}, {}, None
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element] = int(words[2])
            fields[element] = []
        elif words[0] == "property" and words[1] != "list":
            fields[element].append((words[2], TYPES[words[1]]))
    layout = np.dtype(fields["vertex"])
    vertices = np.frombuffer(data, layout, counts["vertex"], end)
    faces = np.frombuffer(data, np.dtype([("n", "u1"), ("i", "<i4", 3)]), counts["face"],
                          end + counts["vertex"] * layout.itemsize)
    columns = [np.stack([vertices[name].astype(float) for name in names], axis=-1)
               for names in (("x", "y", "z"), ("u", "v"), ("nx", "ny", "nz"))]
    return Mesh(columns[0], faces["i"].copy(), columns[1], columns[2])
