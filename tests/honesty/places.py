"""Places of the unit square of parameters at which a surface may be missing from its mesh: evenly
spread, at the zeros and extremes of what its formulas compare and divide by, at jumps and ends."""
import numpy as np

TINY = 1e-15


def inside(st):
    return np.clip(st, 0, 1)


def length(vectors):
    return np.sqrt(np.einsum("...k,...k", vectors, vectors))


def gap(a, b):
    """Distance of two points; infinite where one alone is undefined, 0 where both are."""
    distance = length(a - b)
    lost_a, lost_b = np.isnan(a[..., 0]), np.isnan(b[..., 0])
    distance[lost_a | lost_b] = 0
    distance[lost_a != lost_b] = np.inf
    return distance


class Places:
    """Collects places and their points."""

    def __init__(self, surface):
        self.surface = surface
        self.st, self.points = [], []

    def add(self, st, points=None):
        st = st.reshape(-1, 2)
        points = self.surface(st) if points is None else points.reshape(-1, 3)
        keep = ~np.isnan(points[:, 0])
        self.st.append(st[keep])
        self.points.append(points[keep])

    def all(self):
        if not self.st:
            return np.empty((0, 2)), np.empty((0, 3))
        return np.concatenate(self.st), np.concatenate(self.points)


def bisect(surface, a, b, places, steps=52):
    """Halves pairs of places toward the largest change of the surface between them. The places on the
    way are collected; returns the last pairs."""
    ra, rb = surface(a), surface(b)
    for step in range(steps):
        middle = (a + b) / 2
        rm = surface(middle)
        left = gap(ra, rm) >= gap(rm, rb)
        a, ra = np.where(left[:, None], a, middle), np.where(left[:, None], ra, rm)
        b, rb = np.where(left[:, None], middle, b), np.where(left[:, None], rm, rb)
        if step % 4 == 1:
            places.add(middle, rm)
    places.add(a, ra)
    places.add(b, rb)
    return a, b


def uneven(a, b, ra, rb, small, most, rng):
    """Pairs between which the surface changes most, or ends: at most `most`."""
    change = gap(ra, rb)
    finite = change[np.isfinite(change) & (change > 0)]
    typical = np.median(finite) if len(finite) else 0
    chosen = np.flatnonzero(change > 3 * typical + small)
    if len(chosen) > most:
        chosen = rng.choice(chosen, most, replace=False)
    return a[chosen], b[chosen]


def grid(count, rng):
    """A grid with a random offset and the ends of the square."""
    axes = [np.concatenate([[0], np.sort((np.arange(count - 2) + rng.random()) / (count - 2)), [1]])
            for _ in "st"]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)


def grid_pairs(st, values):
    for a, b in ((np.s_[1:, :], np.s_[:-1, :]), (np.s_[:, 1:], np.s_[:, :-1])):
        yield (st[a].reshape(-1, 2), st[b].reshape(-1, 2), values[a].reshape(-1, 3),
               values[b].reshape(-1, 3))


def spread(rng, count, low, high):
    """Random lengths, evenly in their logarithm, in random directions."""
    angle = rng.random(count) * 2 * np.pi
    radius = low * (high / low) ** rng.random(count)
    return radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def add_even(places, small, count, rng, pairs=6000):
    """An even grid, random places between, and the jumps and ends between neighbours."""
    surface = places.surface
    st = grid(count, rng)
    values = surface(st)
    places.add(st, values)
    places.add(rng.random((count * count // 2, 2)))
    for a, b, ra, rb in grid_pairs(st, values):
        a, b = uneven(a, b, ra, rb, small, pairs // 2, rng)
        bisect(surface, a, b, places)


def add_edges(places, count, rng):
    """Along the edges of the square and into its corners."""
    along = np.concatenate([rng.random(count), 10 ** -(12 * rng.random(count // 4)),
                            1 - 10 ** -(12 * rng.random(count // 4))])
    for end in (0.0, 1.0):
        fixed = np.full(len(along), end)
        near = np.abs(end - 10 ** -(14 * rng.random(len(along))))
        for across in (fixed, near):
            places.add(np.stack([along, across], axis=-1))
            places.add(np.stack([across, along], axis=-1))


def add_near(places, centres, low, high, each, small, rng):
    """Rays from centres, at lengths evenly in their logarithm, and the jumps along the rays."""
    surface = places.surface
    for centre in centres:
        count = max(8, each // 24)
        angles = 2 * np.pi * (np.arange(count) + rng.random()) / count
        radii = low * (high / low) ** ((np.arange(24) + rng.random()) / 24)
        direction = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        st = inside(centre + direction[:, None, :] * radii[None, :, None])
        values = surface(st)
        places.add(st, values)
        places.add(centre[None])
        a, b = st[:, 1:].reshape(-1, 2), st[:, :-1].reshape(-1, 2)
        ra, rb = values[:, 1:].reshape(-1, 3), values[:, :-1].reshape(-1, 3)
        a, b = uneven(a, b, ra, rb, small, 400, rng)
        bisect(surface, a, b, places, 44)


def zeros(function, count, most, rng):
    """Places where a function changes its sign, and where its amount is least or most."""
    st = grid(count, rng)
    value = function(st)
    found = []
    for a, b in ((np.s_[1:, :], np.s_[:-1, :]), (np.s_[:, 1:], np.s_[:, :-1])):
        change = (value[a] > 0) != (value[b] > 0)
        found.append((st[a][change], st[b][change]))
    a = np.concatenate([pair[0] for pair in found])
    b = np.concatenate([pair[1] for pair in found])
    if len(a) > most:
        chosen = rng.choice(len(a), most, replace=False)
        a, b = a[chosen], b[chosen]
    if len(a):
        sign = function(a) > 0
        for _ in range(54):
            middle = (a + b) / 2
            same = (function(middle) > 0) == sign
            a = np.where(same[:, None], middle, a)
            b = np.where(same[:, None], b, middle)
    return a, extremes(function, st, value, rng)


def extremes(function, st, value, rng, most=6):
    """Local extremes of a function on a grid, walked to the top."""
    del rng
    padded = np.pad(np.nan_to_num(value, nan=0, posinf=0, neginf=0), 1, mode="edge")
    middle = padded[1:-1, 1:-1]
    around = np.stack([padded[1 + i:padded.shape[0] - 1 + i, 1 + j:padded.shape[1] - 1 + j]
                       for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j])
    found = []
    for sign in (1, -1):
        top = (sign * middle > (sign * around).max(axis=0)) & np.isfinite(value)
        at = st[top]
        if len(at) > most:
            order = np.argsort(-np.abs(middle[top] - around[:, top].mean(axis=0)))
            at = at[order[:most]]
        if len(at):
            found.append(_walk(lambda p, s=sign: s * function(p), at, 1 / len(st)))
    return np.concatenate(found) if found else np.empty((0, 2))


def _walk(function, at, step):
    best = np.nan_to_num(function(at), nan=-np.inf)
    steps = np.full(len(at), step)
    directions = np.array([[1, 0], [-1, 0], [0, 1], [0, -1], [.7, .7], [-.7, .7], [.7, -.7], [-.7, -.7]])
    for _ in range(90):
        tried = inside(at[:, None] + directions * steps[:, None, None])
        value = np.nan_to_num(function(tried), nan=-np.inf)
        which = value.argmax(axis=1)
        better = value[np.arange(len(at)), which] > best
        at = np.where(better[:, None], tried[np.arange(len(at)), which], at)
        best = np.where(better, value[np.arange(len(at)), which], best)
        steps = np.where(better, steps, steps / 2)
        steps = np.maximum(steps, 1e-16)
    return at


def add_along(places, curve, low, high, small, rng, each=3):
    """Beside the places of a curve, at distances evenly in their logarithm, on both sides."""
    if not len(curve):
        return
    surface = places.surface
    for _ in range(each):
        off = spread(rng, len(curve), low, high)
        a, b = inside(curve + off), inside(curve - off)
        ra, rb = surface(a), surface(b)
        places.add(a, ra)
        places.add(b, rb)
        a, b = uneven(a, b, ra, rb, small, 1500, rng)
        bisect(surface, a, b, places, 44)


def crossings(surface, count, most, rng):
    """Places where two of the critical expressions are 0, or one meets an edge of the square."""
    parts, levels = 6, 15
    cells = rng.random() / count + np.arange(-1, count) / count
    s, t = np.meshgrid(cells, cells, indexing="ij")
    low, size = np.stack([s, t], axis=-1).reshape(-1, 2), 1 / count
    low, marks = _crossed(surface, low, size, 1, None)
    if len(low) > most:
        chosen = rng.choice(len(low), most, replace=False)
        low, marks = low[chosen], marks[chosen]
    for _ in range(levels):
        if not len(low):
            break
        size /= parts
        step = np.stack(np.meshgrid(*[np.arange(parts) * size] * 2, indexing="ij"), axis=-1).reshape(-1, 2)
        finer = (low[:, None] + step).reshape(-1, 2)
        finer, own = _crossed(surface, finer, size, len(step), marks)
        # One cell of each.
        _, first = np.unique(np.floor(finer / (size * parts * 2)), axis=0, return_index=True)
        low, marks = finer[first], own[first]
    return inside(low + size / 2)


def _crossed(surface, low, size, each, marks):
    """The cells in which two expressions change their signs, both marked if marks are given; which."""
    corners = low[:, None] + size * np.array([[0, 0], [1, 0], [0, 1], [1, 1]])
    values = np.stack([*surface.critical(inside(corners)), corners[..., 0], corners[..., 0] - 1,
                       corners[..., 1], corners[..., 1] - 1], axis=1)
    above = values > 0
    changes = above.any(axis=2) & ~above.all(axis=2)
    if marks is not None:
        changes &= np.repeat(marks, each, axis=0)
    keep = changes.sum(axis=1) >= 2
    return low[keep], changes[keep]


def add_critical(places, small, rng, count=220, most=1200):
    """Beside the zeros and extremes of what the formulas compare, divide by and take roots of."""
    surface = places.surface
    tops = []
    for k in range(min(surface.critical_count, 24)):
        function = lambda st, k=k: surface.critical(st)[k]
        curve, extreme = zeros(function, count, most, rng)
        add_along(places, curve, TINY, 0.1, small, rng)
        tops.append(extreme)
    corners = crossings(surface, 61, 400, rng)
    if len(corners) > 80:
        corners = rng.permutation(corners)[:80]
    add_near(places, corners, 1e-13, 0.05, 200, small, rng)
    if tops:
        tops = np.concatenate(tops)
        if len(tops):
            _, first = np.unique(np.round(tops, 9), axis=0, return_index=True)
            add_near(places, tops[first][:60], 1e-9, 0.3, 600, small, rng)
