#!/usr/bin/python3 -B
"""The oracle against meshes whose distances from their surfaces are known."""
import math
import unittest

import numpy as np

import thickened
import verdict
from language import Surface
from mesh import Mesh
from nearest import Triangles
from oracle import Oracle, is_solid


def grid_mesh(formulas, us, vs):
    """The surface's own points on a grid; each cell has two triangles."""
    surface = Surface(formulas)
    u, v = np.meshgrid(us, vs, indexing="ij")
    uv = np.stack([u, v], axis=-1).reshape(-1, 2)
    index = np.arange(len(uv)).reshape(len(us), len(vs))
    a, b, c, d = (x.ravel() for x in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]))
    triangles = np.concatenate([np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)])
    return surface, Mesh(surface.at_uv(uv[:, 0], uv[:, 1]), triangles, uv)


def errors(surface, mesh, unit, clip=None):
    """Distances that are proved, in units: of the surface from the mesh, and of the mesh from it."""
    oracle = Oracle(surface, mesh, unit, clip, 1)
    both = oracle.forward(), oracle.backward()
    return [(verdict.confirmed(found, oracle, 1) if found.distance > unit else found).distance / unit
            for found in both]


EVEN = np.linspace(-1, 1, 11)


class LanguageTest(unittest.TestCase):
    def test_sees_where_defined_functions_jump(self):
        surface = Surface(["f(a)=sign(a)", "z=f(u-0.3)-f(u+0.4)"])
        values = surface.critical(surface.st(np.array([[0.3, 0.0], [-0.4, 0.0]])))
        zeros = [np.flatnonzero(np.abs(value) < 1e-12).tolist() for value in values]
        self.assertIn([0], zeros)
        self.assertIn([1], zeros)

    def test_reads_thickened_surfaces(self):
        for case in thickened.cases(thickened.SEED, thickened.COUNT):
            with self.subTest(number=case.number):
                st = np.random.default_rng(1).random((40, 2))
                self.assertTrue(np.isfinite(Surface(case.formulas)(st)).any())


class OracleTest(unittest.TestCase):
    unit = 1e-3

    def test_passes_an_exact_mesh(self):
        surface, mesh = grid_mesh(["z=0.3*u-0.2*v"], EVEN, EVEN)
        self.assertLess(max(errors(surface, mesh, self.unit)), 0.9)

    def test_passes_an_exact_steep_wall(self):
        surface, mesh = grid_mesh(["z=clamp(1e6*(u-0.1),-1,1)"], [-1, 0.1 - 1e-6, 0.1 + 1e-6, 1], EVEN)
        self.assertLess(max(errors(surface, mesh, self.unit)), 0.9)

    def test_passes_a_jump_without_a_wall(self):
        surface, left = grid_mesh(["z=sign(u)"], [-1, -1e-12], EVEN)
        _, right = grid_mesh(["z=sign(u)"], [1e-12, 1], EVEN)
        both = Mesh(np.concatenate([left.points, right.points]),
                    np.concatenate([left.triangles, right.triangles + len(left.points)]),
                    np.concatenate([left.uv, right.uv]))
        self.assertLess(max(errors(surface, both, self.unit)), 0.9)

    def test_finds_a_missing_triangle(self):
        # The farthest point of the hole is the centre of the inscribed circle, except at the edges.
        surface, mesh = grid_mesh(["z=0"], EVEN, EVEN)
        cell = 0.2
        lost = np.flatnonzero((mesh.points[mesh.triangles][:, :, :2].mean(axis=1) ** 2).sum(axis=1) < 0.03)[0]
        mesh.triangles = np.delete(mesh.triangles, lost, axis=0)
        forward, backward = errors(surface, mesh, self.unit)
        self.assertAlmostEqual(forward * self.unit, cell * (2 - math.sqrt(2)) / 2, delta=2e-4)
        self.assertLess(backward, 0.9)

    def test_finds_a_corner_moved_by_two_units(self):
        surface, mesh = grid_mesh(["z=0"], EVEN, EVEN)
        mesh.points[60, 2] = 2 * self.unit
        forward, backward = errors(surface, mesh, self.unit)
        self.assertAlmostEqual(backward, 2, delta=0.01)
        self.assertAlmostEqual(forward, 2, delta=0.05)

    def test_finds_a_wall_across_a_jump(self):
        surface, mesh = grid_mesh(["z=u>0.1?1:0"], [-1, 0.1 - 1e-9, 0.1 + 1e-9, 1], EVEN)
        self.assertAlmostEqual(errors(surface, mesh, self.unit)[1] * self.unit, 0.5, delta=0.01)

    def test_finds_a_missing_disc_and_a_filled_hole(self):
        _, plane = grid_mesh(["z=0"], EVEN, EVEN)
        disc = Surface(["z=(hypot(u-0.31,v-0.22)<0.003)?1:0"])
        self.assertAlmostEqual(errors(disc, plane, self.unit)[0] * self.unit, 1, delta=1e-6)
        hole = Surface(["z=(hypot(u-0.31,v-0.22)<0.1)?nan:0"])
        # Places of the mesh are tried about 0.006 apart: 10^5 of them on an area of 4.
        self.assertAlmostEqual(errors(hole, plane, self.unit)[1] * self.unit, 0.1, delta=0.006)

    def test_finds_a_missing_ridge(self):
        _, plane = grid_mesh(["z=0"], EVEN, EVEN)
        ridge = Surface(["z=exp(-((u-0.3333)/1e-6)^2)"])
        self.assertAlmostEqual(errors(ridge, plane, self.unit)[0] * self.unit, 1, delta=1e-3)

    def test_climbs_a_pole_but_no_jump(self):
        _, mesh = grid_mesh(["z=0"], EVEN, EVEN)
        around = np.array([[[0.7854, -0.01], [0.7855, -0.01], [0.7854, 0.01]]])
        for formula, expected in {"z=tan(2*u)*v^2": 0, "z=u<pi/4?0:-4": 2}.items():
            with self.subTest(formula):
                surface = Surface([formula])
                oracle = Oracle(surface, mesh, self.unit, None, 0)
                uv = np.array([[0.78545, -3e-4]])
                point = np.array([[math.pi / 4, -3e-4, -2]])
                distance = oracle.beside_walls(point, surface.st(uv), around)[0]
                self.assertAlmostEqual(distance, expected, delta=1e-4)

    def test_leaves_out_places_beyond_the_clip(self):
        _, plane = grid_mesh(["z=0"], EVEN, EVEN)
        step = Surface(["z=u>0.1?5:0"])
        clip = np.array([[-np.inf] * 3, [np.inf, np.inf, 4]])
        forward, backward = errors(step, plane, self.unit, clip)
        self.assertLess(forward, 0.9)
        self.assertAlmostEqual(backward * self.unit, 0.9, delta=0.01)

    def test_takes_single_values_for_no_part(self):
        for formula, place in (["z=floor(1-u^2)+v", (0.5 - 6e-12, 1)],
                               ["z=mod(u*8,1)*mod(v*8,1)", (1, 1 - 8.9e-16)],
                               ["z=floor(u)+v u=1e5:1e5+3", (1, 1)]):
            surface = Surface(formula.split())
            for seed in range(12):
                with self.subTest(formula=formula, seed=seed):
                    rng = np.random.default_rng(seed)
                    self.assertFalse(is_solid(surface, np.array([place]), 1e-3, rng, precise=True)[0])

    def test_reads_the_clip_as_the_command_line_does(self):
        for options in (["--clip=-1:1,-2:2,-3:3"], ["--grid", "off", "--clip", "-1:1,-2:2,-3:3"]):
            with self.subTest(options):
                box = verdict.clip_box({"warnings": []}, options)
                self.assertEqual(box.tolist(), [[-1, -2, -3], [1, 2, 3]])
        self.assertIsNone(verdict.clip_box({"warnings": []}, ["--clip", "off"]))

    def test_measures_a_coarse_sphere(self):
        # Sagitta of the flattest chord: the middle of a quadrilateral's diagonal at the equator.
        angles = np.linspace(0, 2 * math.pi, 41)
        surface, mesh = grid_mesh(["x=cos(v)*cos(u)", "y=cos(v)*sin(u)", "z=sin(v)", "u=0:2*pi",
                                   "v=-pi/2:pi/2"], angles, np.linspace(-math.pi / 2, math.pi / 2, 21))
        forward, backward = errors(surface, mesh, self.unit)
        step = math.pi / 20
        exact = 1 - np.linalg.norm((np.array([1, 0, 0]) + np.array(
            [math.cos(step) ** 2, math.cos(step) * math.sin(step), math.sin(step)])) / 2)
        self.assertAlmostEqual(backward * self.unit, exact, delta=0.02 * exact)
        self.assertAlmostEqual(forward * self.unit, exact, delta=0.05 * exact)


class NearestTest(unittest.TestCase):
    def test_agrees_with_every_triangle_tried(self):
        rng = np.random.default_rng(1)
        corners, places = rng.random((60, 3)), rng.random((200, 3)) * 2
        triangles = rng.integers(0, 60, (400, 3))
        found = Triangles(corners, triangles).distances(places)[0]
        single = [Triangles(corners, triangles[k:k + 1]).distances(places)[0] for k in range(400)]
        np.testing.assert_allclose(found, np.min(single, axis=0), rtol=1e-12)

    def test_knows_distances_from_a_triangle(self):
        triangle = Triangles(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0.0]]), np.array([[0, 1, 2]]))
        places = np.array([[0.2, 0.2, 3], [-3, -4, 0], [1, 1, 0], [0.5, -2, 0], [0.3, 0.3, 0.0]])
        np.testing.assert_allclose(triangle.distances(places)[0], [3, 5, math.sqrt(0.5), 2, 0], atol=1e-15)


class LanguageTest(unittest.TestCase):
    def value(self, formula, u, v, *more):
        return float(Surface([f"z={formula}", *more]).at_uv(np.array(u), np.array(v))[2])

    def test_follows_the_precedence_of_the_language(self):
        for formula, expected in {
                "-u^2": -9, "2^3^2": 512, "2^-1": 0.5, "1/2u": 1.5, "2^3u": 24, "0==1<2": 1,
                "1||0&&0": 1, "u>v?1:u<v?2:3": 1, "2*-3": -6, "mod(-u,2)": 1, "round(-2.5)": -3,
                "rint(-2.5)": -2, "u-v-1": 1, "2pi": 2 * math.pi, "hypot(u,4)": 5, "step(1,u)": 1,
                "smoothstep(0,6,u)": 0.5, "avg(u,v,4)": 8 / 3, "if(u>v,7,nan)": 7, "cbrt(-8)": -2,
                "f(u)+a": 11, "2e": 2 * math.e, "3(u+1)": 12, "sinc(0)": 1, "u!=v": 1}.items():
            with self.subTest(formula):
                self.assertAlmostEqual(self.value(formula, 3.0, 1.0, "f(s)=s*s", "a=2"), expected)
        self.assertTrue(math.isnan(self.value("(-8)^(1/3)*u", 3.0, 1.0)))

    def test_evaluates_every_function_precisely(self):
        for name in ("gamma", "lgamma", "erf", "besselj0", "besselj1", "tanh", "cbrt"):
            with self.subTest(name):
                surface = Surface([f"z={name}(u)*v", "u=1:2"])
                st = np.array([[0.5, 0.75]])
                np.testing.assert_allclose(surface.precisely(st), surface(st), rtol=1e-15)

    def test_reads_ranges(self):
        surface = Surface(["z=u", "u=0:tau", "v=-u:(u>1?2:3)"])
        u, v = surface.uv(np.array([[0.5, 0.0], [0.5, 1.0]]))
        np.testing.assert_allclose(u, [math.pi] * 2)
        np.testing.assert_allclose(v, [-math.pi, 2])


if __name__ == "__main__":
    unittest.main()
