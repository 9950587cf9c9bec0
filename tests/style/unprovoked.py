"""Messages that no command line provokes, with the reason: `tests/style/messages.py` reads them.

A row is the beginning of the message's words in the source, or several with one reason."""

REASONS = {
    "no short formula is known for it; tests/geometry/mesh/topology_test.cpp counts such edges": [
        "of more than two triangles"],
    "no machine of the tests has such a build": [
        "this saddle was built without its viewer", "build it with -DSADDLE_VIEWER=ON"],
    "more memory than a test may take; tests/unit/base/error_test.cpp has the conversion": [
        "out of memory: more is asked for than any machine has"],
    "more memory than a test may take": [
        "the mesh is larger than the 4 GiB of a part of a 3MF file",
        "a coarser tolerance gives fewer triangles",
        "the mesh is larger than the 4 GiB of a GLB file",
        "the mesh has more vertices than a PLY file can number", "a coarser tolerance gives fewer",
        "the mesh has more triangles than an STL file can count"],
    "--samples refuses so many cells first; tests/geometry/mesh/grid_mesh_report_test.cpp": [
        "a grid of", "cells is too large"],
    "faults of the system, by tests/faults/faults.py": [
        "the system starts no more threads", "ulimit -u and ulimit -v show what it allows",
        "libpng cannot be started", "cannot write the PNG:", "the folder of temporary files,",
        ", is full; TMPDIR names another", "cannot read a temporary file:",
        "not enough memory for a picture of", "try a smaller --size, --antialias 1 or coarser"],
    "faults of OpenGL or its libraries": [
        "the OpenGL of this display is older than 3.3", "and libgl1-mesa-dri have what it needs",
        "OSMesa's OpenGL 3.3 cannot be used", "update the package",
        "drawing without a window needs a library that cannot be loaded:",
        "the installed library is too old: it has no", "a shader does not work:",
        "this is a defect of saddle or of the OpenGL driver; please report it",
        "OpenGL cannot draw into", "try a smaller --size or --antialias 1",
        "OpenGL cannot draw see-through surfaces into",
        "try a smaller --size, --antialias 1 or --opacity 1", "OpenGL reports error",
        "the OpenGL driver holds no texture of", "it holds up to",
        "each way: make the picture smaller"],
    "no short formula is known whose mesh is off at just such triangles": [
        ": triangles there have no area in double precision"],
    "a fault of ffmpeg, which has written some frames": ["ffmpeg wants no more frames"],
    "in the window; tests/unit/view/model_test.cpp": ["the picked point is gone:"],
}

# The same of messages that some machines provoke and others do not.
ON_SOME_MACHINES = {
    "a processor that has all levels lacks none": [
        "this processor does not have", "leave SADDLE_CPU unset for the best that it has"],
}
