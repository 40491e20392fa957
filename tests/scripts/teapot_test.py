# SPDX-License-Identifier: GPL-3.0-or-later
"""The normals du x dv of the teapot point outwards, and the mesh has its vertices on the surface."""
import json
import unittest
from math import hypot

from fake_tree import ROOT
from mesh_files import read_mesh

PATCHES = json.loads((ROOT / "datasets/surfaces/teapot.json").read_text())["patches"]
TURNED = {"pot": [*range(12), *range(28, 32)], "lid": list(range(20, 28))}
TUBES = range(12, 20)
MM_PER_UNIT = 30
STEP = 1e-5


def bernstein(t):
    return [(1 - t)**3, 3 * t * (1 - t)**2, 3 * t * t * (1 - t), t**3]


def point(net, u, v):
    return [sum(a * b * net[j][i][k] for j, a in enumerate(bernstein(v))
                for i, b in enumerate(bernstein(u))) for k in range(3)]


def normal(net, u, v):
    """The unit normal du x dv, by central differences."""
    du = [b - a for a, b in zip(point(net, u - STEP, v), point(net, u + STEP, v))]
    dv = [b - a for a, b in zip(point(net, u, v - STEP), point(net, u, v + STEP))]
    cross = [du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2],
             du[0] * dv[1] - du[1] * dv[0]]
    return [c / hypot(*cross) for c in cross]


def profile(numbers):
    """(radius, z) along the patches in the half plane y = 0, x > 0, in the order of their chain."""
    points = [point(PATCHES[n], 0, k / 50) for n in numbers for k in range(51)]
    return [(x, z) for x, _, z in points]


def inside(outline, r, z):
    """Whether a ray towards greater r crosses the outline an odd number of times."""
    odd = False
    for (r0, z0), (r1, z1) in zip(outline, outline[1:] + outline[:1]):
        if (z0 > z) != (z1 > z) and r < r0 + (z - z0) / (z1 - z0) * (r1 - r0):
            odd = not odd
    return odd


class Teapot(unittest.TestCase):
    def test_normals_of_pot_and_lid_point_outwards(self):
        bottom = profile([28])[::-1]
        outline = profile([20, 24]) + profile([0, 4, 8]) + bottom
        for n in TURNED["pot"] + TURNED["lid"]:
            for u, v in ((0.1, 0.5), (0.5, 0.2), (0.5, 0.5), (0.5, 0.8), (0.9, 0.5)):
                at, out = point(PATCHES[n], u, v), normal(PATCHES[n], u, v)
                for side, expected in ((-0.6, True), (0.6, False)):
                    x, y, z = (a + side * b for a, b in zip(at, out))
                    self.assertEqual(inside(outline, hypot(x, y), z), expected, (n, u, v))

    def test_normals_of_tubes_point_outwards(self):
        # A section at constant v is plane and convex, and its centre is that of the row of the net.
        # The last pair is the lip of the spout, which turns inwards.
        for n in TUBES[:6]:
            for u, v in ((0.1, 0.5), (0.5, 0.1), (0.5, 0.9), (0.9, 0.5)):
                at = point(PATCHES[n], u, v)
                ends = point(PATCHES[n], 0, v), point(PATCHES[n], 1, v)
                middle = [(a + b) / 2 for a, b in zip(*ends)]
                out = normal(PATCHES[n], u, v)
                self.assertGreater(sum((a - m) * c for a, m, c in zip(at, middle, out)), 0)
        for lower, lip in ((16, 18), (17, 19)):
            self.assertEqual(PATCHES[lower][3], PATCHES[lip][0])

    def test_vertices_of_the_mesh_lie_on_the_surface(self):
        """The mesh has vertices at the corners of the pot, the handle and the spout."""
        vertices = {tuple(round(MM_PER_UNIT * c, 6) + 0.0 for c in vertex)
                    for vertex in read_mesh(ROOT / "datasets/meshes/teapot-288.off")[0]}
        for n in range(20):
            for row in (PATCHES[n][0], PATCHES[n][3]):
                for corner in (row[0], row[3]):
                    self.assertIn(tuple(round(c, 6) + 0.0 for c in corner), vertices)


if __name__ == "__main__":
    unittest.main()
