"""How far a mesh and its surface are apart, both ways, by means that the mesher does not have."""
import numpy as np
from scipy.spatial import cKDTree

import places as where
from nearest import Triangles
from places import inside, length

# A place counts as a part of the surface if two neighbours of twelve around it have its value.
RADII = (1e-10, 1e-12, 3e-14, 1e-15)
NEIGHBOURS = 12
# The radius for precise values: 64 bits cannot tell 1-u^2 from 1 within 3e-10 of u=0.
PRECISE_RADIUS = 1e-9
# Neighbours are as many units of rounding away: nearer ones may be on lines of single values.
UNITS_AWAY = 64
# Lines between samples that a search halves: at first, and of these the nearest to the last digit.
BROAD, NARROW = 14, 4
# Shares of a way toward a wall: nearly all doubles that a wall at 0 may have.
TOWARD_WALL = np.concatenate([[0], 10.0 ** np.linspace(-300, -18, 120), 10.0 ** np.linspace(-17, 0, 70)])
# Places of a line that is searched for where the surface leaps.
LINE_PLACES = 65
# Distances up to this share of the unit are not searched for smaller ones.
ENOUGH = 0.85


class Found:
    """The largest distance, where it is, and the next best places. Of a place of the mesh, the
    parameters of its triangle's corners, too."""

    def __init__(self, way, distance=0.0, st=None, point=None, corners=None):
        self.way, self.distance, self.st, self.point = way, distance, st, point
        self.corners = corners
        self.candidates = [self] if st is not None else []


def is_solid(surface, st, small, rng, precise=False):
    """Whether values at places are shared by an open set beside them; single values count as none."""
    values = surface(st)
    solid = np.zeros(len(st), dtype=bool)
    radii = [PRECISE_RADIUS] if precise else RADII
    for radius in np.maximum(radii, UNITS_AWAY * surface.rounding()):
        angles = 2 * np.pi * (np.arange(NEIGHBOURS) + rng.random()) / NEIGHBOURS
        around = st[:, None] + radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        kept = ((around >= 0) & (around <= 1)).all(axis=-1)
        got = (surface.precisely if precise else surface)(inside(around))
        near = kept & (where.gap(got, values[:, None]) < small)
        solid |= (near & np.roll(near, 1, axis=1)).any(axis=1)
    return solid & ~np.isnan(values[:, 0])


def found_of(way, distances, st, points, corners=None, most=6):
    """The largest of distances; a few more as candidates."""
    order = np.argsort(-distances)
    order = np.unique(np.concatenate([order[:1], order[1:][::max(1, len(order) // most)]]))
    order = order[np.argsort(-distances[order])]
    all_found = [Found(way, distances[n], st[n], points[n], None if corners is None else corners[n])
                 for n in order[:most]]
    all_found[0].candidates.extend(all_found[1:])
    return all_found[0]


def farthest(distances, most):
    """The indices of the largest distances, the largest first."""
    order = np.argpartition(-distances, min(most, len(distances) - 1))[:most]
    return order[np.argsort(-distances[order])]


def _length(vectors):
    """Lengths; infinite where a vector is undefined."""
    lengths = length(vectors)
    lengths[np.isnan(lengths)] = np.inf
    return lengths


class Oracle:
    def __init__(self, surface, mesh, unit, clip, seed, hints=(), effort=1, enough=ENOUGH):
        self.enough = enough * unit
        self.surface, self.mesh, self.unit, self.clip = surface, mesh, unit, clip
        self.hints, self.effort = hints, effort
        self.rng = np.random.default_rng(seed)
        self.small = 0.2 * unit
        self.tree = Triangles(mesh.points, mesh.triangles)
        self.mesh_st = surface.st(mesh.uv)
        self.places = None

    # --- the surface's places on the mesh -------------------------------------------------------

    def counts(self, points):
        """Points within the box that the surface is cut along."""
        if self.clip is None:
            return np.ones(len(points), dtype=bool)
        return ((points >= self.clip[0]) & (points <= self.clip[1])).all(axis=-1)

    def distances(self, points):
        return np.where(self.counts(points), self.tree.distances(points, min(0.3 * self.unit, self.enough))[0], 0)

    def forward(self):
        rng, small = self.rng, self.small
        self.places = places = where.Places(self.surface)
        where.add_even(places, small, 260 if self.effort == 1 else 600, rng, 6000 * self.effort)
        where.add_edges(places, 2000, rng)
        where.add_critical(places, small, rng, 220 * self.effort, 1200 * self.effort)
        self._add_hints()
        self._add_beside_mesh()
        st, points = places.all()
        distances = self.distances(points)
        found = self._worst(st, points, distances)
        for size in (0.01, 1e-3, 1e-4):
            found = self._climb(st, distances, found, size)
        return found

    def _add_hints(self):
        for hint in self.hints:
            if hint[0] == "point":
                _, u, v, scale = hint
                centre = self.surface.st(np.array([[u, v]]))
                where.add_near(self.places, centre, scale / 30, min(scale * 10, 0.5), 6000, self.small,
                               self.rng)
                # Along rays: the side of a needle is much longer than it is wide.
                angles = self.rng.random() + np.arange(8) * np.pi / 4
                rays = np.linspace(0, 3 * scale, 3000)[:, None, None] * \
                    np.stack([np.cos(angles), np.sin(angles)], axis=-1)
                self.places.add(inside(centre + rays.reshape(-1, 2)))
            else:
                _, text, scale = hint
                function = self.surface.function(text)
                curve, _ = where.zeros(function, 300, 3000, self.rng)
                where.add_along(self.places, curve, scale / 100, min(scale * 100, 0.3), self.small,
                                self.rng, 4)

    def _add_beside_mesh(self):
        """Within triangles, as many in each, and beside corners."""
        rng, count = self.rng, 30000 * self.effort
        chosen = self.mesh.triangles[rng.integers(0, len(self.mesh.triangles), count)]
        weights = rng.dirichlet((1, 1, 1), count)
        corners = self.mesh_st[chosen]
        st = np.einsum("nk,nkd->nd", weights, corners)
        self.places.add(inside(st))
        size = length(corners.max(axis=1) - corners.min(axis=1)).clip(1e-12)
        beyond = st + where.spread(rng, count, 0.1, 3.0) * size[:, None]
        self.places.add(inside(beyond))

    def _worst(self, st, points, distances):
        """The farthest places that are a part of the surface."""
        order = farthest(distances, 40000)
        for first in range(0, len(order), 400):
            block = order[first:first + 400]
            if distances[block[0]] <= 0.5 * self.enough:
                break
            block = block[is_solid(self.surface, st[block], self.small, self.rng)]
            if len(block):
                return found_of("surface", distances[block], st[block], points[block])
        block = order[first:first + 1]
        return found_of("surface", distances[block], st[block], points[block])

    def _diverse(self, st, distances, count, size):
        """The worst places, one of each square of the parameters."""
        order = farthest(distances, 20000)
        _, first = np.unique(np.floor(st[order] / size), axis=0, return_index=True)
        return st[order[np.sort(first)[:count]]]

    def _climb(self, st, distances, found, size):
        """Looks about the worst places: random ones, and where the surface jumps or ends."""
        centres = self._diverse(st, distances, 24, size)
        local = where.Places(self.surface)
        off = where.spread(self.rng, len(centres) * 300, size * 1e-4, size * 2)
        around = inside(np.repeat(centres, 300, axis=0) + off)
        values = self.surface(around)
        local.add(around, values)
        pairs = self.rng.permutation(300)
        grouped, got = around.reshape(-1, 300, 2), values.reshape(-1, 300, 3)
        a, b = grouped.reshape(-1, 2), grouped[:, pairs].reshape(-1, 2)
        ra, rb = got.reshape(-1, 3), got[:, pairs].reshape(-1, 3)
        a, b = where.uneven(a, b, ra, rb, self.small, 1500, self.rng)
        if len(a):
            where.bisect(self.surface, a, b, local, 46)
        own_st, own_points = local.all()
        if not len(own_st):
            return found
        better = self._worst(own_st, own_points, self.distances(own_points))
        return better if better.distance > found.distance else found

    # --- the mesh's places on the surface -------------------------------------------------------

    def samples(self):
        """Corners, middles of edges, centroids and random points of triangles: points, places, middles
        and sizes of their triangles, and the parameters of these triangles' corners."""
        rng, mesh = self.rng, self.mesh
        points, st = mesh.points[mesh.triangles], self.mesh_st[mesh.triangles]
        middles = st.mean(axis=1)
        area = length(np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]))
        longest = np.max([length(points[:, k] - points[:, k - 1]) for k in range(3)], axis=0)
        weights = [([1, 0, 0], None), ([0.5, 0.5, 0], None), ([0, 0.5, 0.5], None),
                   ([1 / 3] * 3, None), (None, area), (None, longest)]
        found = []
        for weight, by in weights:
            count = min(len(points), 25000 * self.effort) if by is None else 15000 * self.effort
            if by is None:
                chosen = rng.permutation(len(points))[:count]
                w = np.broadcast_to(weight, (count, 3))
            else:
                total = by.sum()
                chosen = rng.choice(len(points), count, p=by / total if total > 0 else None)
                w = rng.dirichlet((0.7, 0.7, 0.7), count)
            own = np.einsum("nk,nkd->nd", w, st[chosen])
            size = length(st[chosen].max(axis=1) - st[chosen].min(axis=1))
            found.append((np.einsum("nk,nkd->nd", w, points[chosen]), inside(own), middles[chosen], size,
                          mesh.uv[mesh.triangles[chosen]]))
        return [np.concatenate(parts) for parts in zip(*found)]

    def _distance(self, points, st):
        return _length(self.surface(st) - points)

    def backward(self):
        points, st, middles, sizes, corners = self.samples()
        best = self._distance(points, st)
        enough = self.enough
        for share in (1e-12, 1e-6, 1e-2):  # toward the middle of the triangle
            left = np.flatnonzero(best > enough)
            tried = st[left] + share * (middles[left] - st[left])
            best[left] = np.minimum(best[left], self._distance(points[left], tried))
        for radius in (1e-13, 1e-9, 1e-5, 0.1):  # around, at shares of the triangle's size below 1e-4
            left = np.flatnonzero(best > enough)
            for angle in self.rng.random() + np.arange(6) * np.pi / 3:
                step = radius * (sizes[left, None] if radius > 1e-4 else 1)
                tried = inside(st[left] + step * np.array([np.cos(angle), np.sin(angle)]))
                best[left] = np.minimum(best[left], self._distance(points[left], tried))
        left = np.flatnonzero(best > enough)
        certain = best[best <= enough].max(initial=0)
        own_st, own_points = self.places.all()
        start = st.copy()
        if len(left) and len(own_points):
            near, which = cKDTree(own_points[:400000]).query(points[left])
            closer = near < best[left]
            best[left] = np.minimum(best[left], near)
            start[left[closer]] = own_st[which[closer]]
            left = left[best[left] > enough]
        most = 2400 * self.effort
        if len(left) > most:
            order = left[np.argsort(-best[left])]
            left = np.concatenate([order[:most // 2],
                                   self.rng.choice(order[most // 2:], most // 2, replace=False)])
        found = Found("mesh", certain)
        for first in range(0, len(left), 800):
            block = left[first:first + 800]
            got, _ = self.closest(points[block], st[block], sizes[block], best[block])
            far = np.flatnonzero(got > 0.8 * self.unit)
            if len(far):
                got[far], _ = self.closest(points[block[far]], start[block[far]], sizes[block[far]],
                                           got[far])
            if got.max() > found.distance:
                found = found_of("mesh", got, st[block], points[block], corners[block])
        return found

    def closest(self, points, st, sizes, best, rounds=2):
        """Least distances of points to the surface, looking from given places."""
        best, at = best.copy(), st.copy()
        got = self._distance(points, at)
        best = np.minimum(best, got)
        active = np.arange(len(points))
        for turn in range(rounds * self.effort):
            radius = np.maximum(4 * sizes[active], 0.02) if turn % 2 == 0 else np.full(len(active), 0.3)
            better, place = self._look_around(points[active], at[active], radius)
            gain = better < got[active]
            at[active[gain]], got[active[gain]] = place[gain], better[gain]
            better, place = self._descend(points[active], at[active], sizes[active])
            gain = better < got[active]
            at[active[gain]], got[active[gain]] = place[gain], better[gain]
            best = np.minimum(best, got)
            active = active[best[active] > 0.8 * self.unit]
            if not len(active):
                break
        return best, at

    def _look_around(self, points, st, radius, directions=10, lengths=13):
        """Rays around places; where the line between two samples passes nearest, it is halved."""
        count = len(points)
        angles = self.rng.random(count)[:, None] + 2 * np.pi * np.arange(directions) / directions
        way = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        radii = radius[:, None] * 10.0 ** (-np.arange(lengths) * 0.9)
        around = inside(st[:, None, None] + way[:, :, None] * radii[:, None, :, None])
        values = self.surface(around)
        pairs_a = [around[:, :, 1:].reshape(count, -1, 2), around.reshape(count, -1, 2)]
        pairs_b = [around[:, :, :-1].reshape(count, -1, 2),
                   np.roll(around, 1, axis=1).reshape(count, -1, 2)]
        values_a = [values[:, :, 1:].reshape(count, -1, 3), values.reshape(count, -1, 3)]
        values_b = [values[:, :, :-1].reshape(count, -1, 3),
                    np.roll(values, 1, axis=1).reshape(count, -1, 3)]
        a, b = np.concatenate(pairs_a, axis=1), np.concatenate(pairs_b, axis=1)
        ra, rb = np.concatenate(values_a, axis=1), np.concatenate(values_b, axis=1)
        near = self._to_segments(points[:, None], ra, rb)
        direct = _length(ra - points[:, None])
        rows = np.arange(count)
        which = direct.argmin(axis=1)
        best, at = direct[rows, which], a[rows, which]
        chosen = np.argsort(near, axis=1)[:, :BROAD]
        pairs = [array[rows[:, None], chosen] for array in (a, b, ra, rb)]
        for width, steps in ((BROAD, 9), (NARROW, 40)):
            near = self._to_segments(points[:, None], pairs[2], pairs[3])
            chosen = np.argsort(near, axis=1)[:, :width]
            pairs = [array[rows[:, None], chosen] for array in pairs]
            got, place, pairs = self._halve(points[:, None], *pairs, steps)
            which = got.argmin(axis=1)
            at = np.where((got[rows, which] < best)[:, None], place[rows, which], at)
            best = np.minimum(best, got[rows, which])
        return best, at

    def beside_walls(self, points, st, corners):
        """Least distances to the surface where one parameter alone comes ever closer to 0, to that of a
        corner of a place's triangle, or to where the surface leaps most about the triangle. Beside a
        pole, as that of u/cbrt(v), v*ln(u) or v^2*tan(u), the surface is a wall that is much thinner
        than steps in the unit square of parameters may be."""
        uv = np.stack(self.surface.uv(st), axis=-1)
        rows = np.arange(len(points))[:, None]
        best = np.full(len(points), np.inf)
        for axis in (0, 1):
            ends = [(np.zeros(len(points)), corner) for corner in corners[:, :, axis].T]
            ends += [(corner, uv[:, axis]) for corner in corners[:, :, axis].T]
            around = self._around(st, axis, corners[:, :, axis])
            ends += [(leap, end) for leap in self._leap(uv, axis, around) for end in around]
            for to, start in ends:
                line = np.repeat(uv[:, None], len(TOWARD_WALL), axis=1)
                line[:, :, axis] = to[:, None] + TOWARD_WALL * (start - to)[:, None]
                values = self._at_uv(line)
                pairs = [line[:, 1:], line[:, :-1], values[:, 1:], values[:, :-1]]
                near = self._to_segments(points[:, None], *pairs[2:])
                chosen = np.argsort(near, axis=1)[:, :NARROW]
                got, _, _ = self._halve(points[:, None], *(array[rows, chosen] for array in pairs),
                                        40, self._at_uv)
                best = np.minimum(best, got.min(axis=1))
        return best

    def _around(self, st, axis, corners):
        """The least and the largest value of one parameter at a triangle's corners, and half as much
        beyond them within the domain."""
        low, high = corners.min(axis=1), corners.max(axis=1)
        ends = np.repeat(st[:, None], 2, axis=1)
        ends[:, :, axis] = [0, 1]
        of_domain = np.sort(self.surface.uv(ends)[axis], axis=1)  # a range may run backwards
        return np.maximum(1.5 * low - 0.5 * high, of_domain[:, 0]), \
            np.minimum(1.5 * high - 0.5 * low, of_domain[:, 1])

    def _leap(self, uv, axis, around):
        """The neighbouring values of one parameter between which the surface changes most."""
        line = np.repeat(uv[:, None], LINE_PLACES, axis=1)
        line[:, :, axis] = np.linspace(*around, LINE_PLACES, axis=1)
        values = self._at_uv(line)
        rows = np.arange(len(uv))
        most = where.gap(values[:, 1:], values[:, :-1]).argmax(axis=1)
        on_way = where.Places(self._at_uv)
        a, b = where.bisect(self._at_uv, line[rows, most], line[rows, most + 1], on_way, 60)
        return a[:, axis], b[:, axis]

    def _at_uv(self, uv):
        with np.errstate(all="ignore"):
            return self.surface.at_uv(uv[..., 0], uv[..., 1])

    def _to_segments(self, points, a, b):
        """Distances to segments; to the defined end of those that leave the surface."""
        lost = np.isnan(a[..., :1])
        start = np.where(lost, b, a)
        d = np.where(lost | np.isnan(b[..., :1]), 0, b - a)
        square = np.einsum("...k,...k", d, d)
        with np.errstate(all="ignore"):  # beside a pole both may be infinite
            along = np.einsum("...k,...k", points - start, d) / np.where(square > 0, square, 1)
        foot = start + np.clip(along, 0, 1)[..., None] * d
        return _length(points - foot)

    def _halve(self, points, a, b, ra, rb, steps, surface=None):
        """Halves pairs toward points; the nearest places on the way, and the last pairs."""
        surface = surface or self.surface
        best, at = np.full(a.shape[:-1], np.inf), a
        for _ in range(steps):
            middle = (a + b) / 2
            rm = surface(middle)
            distance = _length(rm - points)
            at = np.where((distance < best)[..., None], middle, at)
            best = np.minimum(best, distance)
            left, right = self._to_segments(points, ra, rm), self._to_segments(points, rm, rb)
            # Where one end is undefined, toward the end of the surface.
            lost_a, lost_b, lost = (np.isnan(r[..., 0]) for r in (ra, rb, rm))
            keep_left = np.where(lost_a & ~lost_b, ~lost, np.where(lost_b & ~lost_a, lost, left <= right))
            keep_left = keep_left[..., None]
            a, ra = np.where(keep_left, a, middle), np.where(keep_left, ra, rm)
            b, rb = np.where(keep_left, middle, b), np.where(keep_left, rm, rb)
        return best, at, [a, b, ra, rb]

    def _descend(self, points, st, sizes, steps=26):
        """Steps of Gauss and Newton, and to the sides, from the best place so far."""
        best, at = self._distance(points, st), st
        step = np.maximum(sizes, 1e-3)
        sides = np.array([[1, 0], [-1, 0], [0, 1], [0, -1]], dtype=float)
        for _ in range(steps):
            h = np.clip(step * 1e-3, 1e-9, 1e-5)[:, None]
            tried = [inside(at + step[:, None] * side) for side in sides]
            ds, dt = h * sides[0], h * sides[2]
            du = (self.surface(inside(at + ds)) - self.surface(inside(at - ds))) / (2 * h)
            dv = (self.surface(inside(at + dt)) - self.surface(inside(at - dt))) / (2 * h)
            rest = points - self.surface(at)
            tried.append(inside(at + _solve(du, dv, rest)))
            candidates = np.stack(tried, axis=1)
            distance = _length(self.surface(candidates) - points[:, None])
            which = distance.argmin(axis=1)
            rows = np.arange(len(points))
            better = distance[rows, which] < best
            at = np.where(better[:, None], candidates[rows, which], at)
            best = np.minimum(best, distance[rows, which])
            step = np.where(better, step, step / 3)
        return best, at


def _solve(du, dv, rest):
    """Steps of Gauss and Newton: the least squares of two tangents; none where they are undefined."""
    a, b, c = (du * du).sum(axis=-1), (du * dv).sum(axis=-1), (dv * dv).sum(axis=-1)
    p, q = (du * rest).sum(axis=-1), (dv * rest).sum(axis=-1)
    # 1e-12 of both squares keeps a tangent that vanishes from blowing up the step.
    a, c = a * (1 + 1e-12) + 1e-300, c * (1 + 1e-12) + 1e-300
    with np.errstate(all="ignore"):
        det = a * c - b * b
        step = np.stack([(c * p - b * q) / det, (a * q - b * p) / det], axis=-1)
    return np.clip(np.nan_to_num(step, nan=0, posinf=0, neginf=0), -0.5, 0.5)
