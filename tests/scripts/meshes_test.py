# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the numbers in datasets/meshes/README.md with the files that they describe."""
import re
import unittest
from math import cos, dist, fsum, pi, sin

from fake_tree import ROOT
from mesh_files import border_edges, edges, read_mesh, sheets_at, volume
from readme_tables import number, rounds_to, table

FOLDER = ROOT / "datasets/meshes"
README = FOLDER / "README.md"
BOTTOMS = {name: FOLDER / f"{name}-bottom.txt" for name in ("bladed-wheel", "walled-saddle")}  # lists of facets
STATED = table(README, "Files")


def frusta(radius, sides, rings):
    """The volume of the mesh of a half ball, from pyramid frusta over regular polygons and a pyramid."""
    def area(ring):
        return sides / 2 * sin(2 * pi / sides) * (radius * cos(pi / 2 * ring / rings))**2

    def height(ring):
        return radius * sin(pi / 2 * ring / rings)

    return sum((height(k + 1) - height(k)) / 3
               * (area(k) + area(k + 1) + (area(k) * area(k + 1))**0.5) for k in range(rings))


def section_area(vertices, triangles, z):
    """The area of a level section between the heights of vertices: the sum over the edges that the facets cut out."""
    doubled = 0
    for triangle in triangles:
        corners = [vertices[k] for k in triangle]
        ends = {}
        for a, b in zip(corners, corners[1:] + corners[:1]):
            if (a[2] < z) != (b[2] < z):
                share = (z - a[2]) / (b[2] - a[2])
                ends[a[2] < z] = [p + share * (q - p) for p, q in zip(a, b)]
        if ends:  # from the side that leads down to the one that leads up, counter-clockwise
            (x0, y0, _), (x1, y1, _) = ends[False], ends[True]
            doubled += x0 * y1 - x1 * y0
    return doubled / 2


def integral_of_sections(vertices, triangles):
    """The volume by Gauss's rule of two points, which is exact between the heights of neighbouring vertices."""
    heights = sorted({z for _, _, z in vertices})
    volumes = []
    for low, high in zip(heights, heights[1:]):
        middle, half = (low + high) / 2, (high - low) / 2
        volumes += [half * section_area(vertices, triangles, middle + s * half / 3**0.5) for s in (-1, 1)]
    return fsum(volumes)


CLOSED_FORMS = {
    "pocket.stl": 60 * 40 * 20 - 40 * 20 * 10,
    "dome.stl": 60 * 60 * 10 + frusta(20, 48, 12),
    "v-groove.stl": 60 * 40 * 20 - 24 * 9 / 2 * 40,
    "walled-saddle.off": 60 * 48 * 10 + 2 * 60 * 6 * 26,  # the rise along x and the fall along y cancel
    "prism.obj": 40 * 15 / 2 * 60, "prism.ply": 40 * 15 / 2 * 60, "prism.off": 40 * 15 / 2 * 60,
}


def distance_to_facet(radius, sides, rings, ring):
    """The distance of the centre of the half ball from a flat facet between two rings."""
    (x0, z0), (x1, z1) = ((radius * cos(pi / sides) * cos(angle), radius * sin(angle))
                          for angle in (pi / 2 * k / rings for k in (ring, ring + 1)))
    return abs(x0 * z1 - x1 * z0) / dist((x0, z0), (x1, z1))


def distance_to_triangle(corners, parts=20):
    """The smallest distance of the origin from a grid of points on the triangle."""
    a, b, c = corners
    return min(sum(((i * x + j * y + (parts - i - j) * z) / parts)**2 for x, y, z in zip(a, b, c))
               for i in range(parts + 1) for j in range(parts + 1 - i))**0.5


class Meshes(unittest.TestCase):
    def setUp(self):
        self.meshes = {path.name: read_mesh(path) for path in FOLDER.iterdir() if path not in (README, *BOTTOMS.values())}

    def test_every_mesh_is_described(self):
        self.assertEqual(set(STATED), set(self.meshes))

    def test_counts_and_sizes_are_those_of_the_readme(self):
        for name, (vertices, triangles) in self.meshes.items():
            _, _, count, points, size, *_ = STATED[name]
            self.assertEqual((len(triangles), len(vertices)), (number(count), number(points)), name)
            for text, values in zip(size.split(" x "), zip(*vertices)):
                self.assertTrue(rounds_to(max(values) - min(values), text), (name, text))

    def test_every_edge_occurs_once_in_each_direction(self):
        for name, (_, triangles) in self.meshes.items():
            with self.subTest(name):
                self.assertEqual(max(edges(triangles).values()), 1)
                border = len(border_edges(triangles))
                self.assertEqual(STATED[name][5], f"{border} border edges" if border else "closed")

    def test_every_vertex_has_one_fan_of_triangles(self):
        touching = {name: [vertices[k] for k, sheets in sheets_at(triangles).items() if sheets > 1]
                    for name, (vertices, triangles) in self.meshes.items()}
        # The lower end of the handle of the teapot touches the body.
        self.assertEqual(touching.pop("teapot-288.off"), [(-2, 0, 0.9)])
        self.assertFalse(any(touching.values()), touching)

    def test_volumes_are_those_of_the_readme(self):
        for name, (vertices, triangles) in self.meshes.items():
            stated = STATED[name][6]
            if border_edges(triangles):
                self.assertEqual(stated, "–")
                continue
            relative = {"dome.stl": 1e-6, "bladed-wheel.off": 1e-10}.get(name, 1e-14)  # single precision; sections
            found = volume(vertices, triangles)
            expected = CLOSED_FORMS.get(name) or integral_of_sections(vertices, triangles)
            self.assertLessEqual(abs(found / expected - 1), relative, name)
            self.assertTrue(rounds_to(expected, stated), (name, expected))

    def test_bottoms_are_the_facets_on_the_lowest_level(self):
        # the wheel: a fan over the 60 columns of the hub; the saddle: two triangles for 3 by 12 rectangles
        for name, count in (("bladed-wheel", 60), ("walled-saddle", 72)):
            vertices, triangles = self.meshes[f"{name}.off"]
            lines = BOTTOMS[name].read_text(encoding="ascii").splitlines()
            listed = [int(line) for line in lines if not line.startswith("#")]
            self.assertEqual(listed, [k for k, (a, b, c) in enumerate(triangles)
                                      if (vertices[a][2], vertices[b][2], vertices[c][2]) == (0, 0, 0)])
            self.assertEqual(len(listed), count)

    def test_saddle_has_its_formula_between_the_walls(self):
        vertices, _ = self.meshes["walled-saddle.off"]
        floor = [(x, y, z) for x, y, z in vertices if abs(y) <= 24 and 0 < z < 26]
        self.assertEqual(len(floor), 13 * 13)
        for x, y, z in floor:
            self.assertAlmostEqual(z, 10 + 4 * ((x / 30)**2 - (y / 24)**2), delta=1e-8)
        for x, y, z in vertices:
            self.assertTrue(abs(y) <= 24 or z in (0, 26), (x, y, z))

    def test_prism_is_the_same_in_three_formats(self):
        self.assertEqual(self.meshes["prism.obj"], self.meshes["prism.ply"])
        self.assertEqual(self.meshes["prism.obj"], self.meshes["prism.off"])

    def test_dome_is_within_its_chord_error(self):
        vertices, triangles = self.meshes["dome.stl"]
        top = [(x, y, z - 10) for x, y, z in vertices]
        radii = [dist(v, (0, 0, 0)) for v in top if v[2] > 1]
        self.assertLessEqual(max(abs(r - 20) for r in radii), 3e-6)  # single precision
        cap = [[top[k] for k in triangle] for triangle in triangles
               if any(top[k][2] > 1 for k in triangle)]
        self.assertEqual(len(cap), 48 * 23)
        error = 20 - min(distance_to_facet(20, 48, 12, ring) for ring in range(12))
        stated = re.search(r"chord error ([\d.]+) mm", STATED["dome.stl"][0]).group(1)
        self.assertTrue(rounds_to(error, stated), error)
        sampled = 20 - min(map(distance_to_triangle, cap))
        self.assertLessEqual(abs(sampled - error), 1e-3)


if __name__ == "__main__":
    unittest.main()
