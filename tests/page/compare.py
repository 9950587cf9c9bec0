"""Pictures as numpy arrays, and how far two differ inside of what they show."""
import io
import pathlib
import sys

try:
    import numpy
    from PIL import Image
except ImportError:
    from browser import skip
    skip("no numpy or Pillow; apt-get install python3-numpy python3-pil")


def read(png):
    """Red, green, blue of a PNG's path or bytes, 0 to 255."""
    source = io.BytesIO(png) if isinstance(png, bytes) else pathlib.Path(png)
    return numpy.asarray(Image.open(source).convert("RGB")).astype(int)


# Neighbours that differ by so many levels are beside an edge: another sheet's, or another side's.
EDGE = 25


def inside(picture, background, pixels):
    """Where everything within so many pixels is another colour than the background, and no edge."""
    shown = (abs(picture - numpy.array(background)) > 0).any(axis=2)
    for axis in (0, 1):
        jump = abs(numpy.diff(picture, axis=axis)).max(axis=2) > EDGE
        before, after = [(slice(None, -1), slice(None)), (slice(1, None), slice(None))]
        for part in (before, after):
            shown[part if axis == 0 else part[::-1]] &= ~jump
    result = shown.copy()
    for _ in range(pixels):
        result[1:] &= shown[:-1]
        result[:-1] &= shown[1:]
        result[:, 1:] &= shown[:, :-1]
        result[:, :-1] &= shown[:, 1:]
        shown = result.copy()
    return result


def difference(a, b, background=(0, 0, 0), pixels=3):
    """The largest and the mean difference of levels that many pixels inside of both pictures, and the
    share of the picture that this is."""
    where = inside(a, background, pixels) & inside(b, background, pixels)
    if not where.any():
        sys.exit("nothing is inside of both pictures")
    levels = abs(a - b).max(axis=2)[where]
    return int(levels.max()), float(levels.mean()), float(where.mean())
