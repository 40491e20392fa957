# SPDX-License-Identifier: GPL-3.0-or-later
"""The random curves, surfaces and parts of the studies."""
import json
import unittest
from math import dist, pi, sin

from fake_tree import ROOT
from generation import random_curves, random_parts, random_surfaces
from generation.profile_families import convex, wavy
from generation.random_curves import RADIUS, Block
from mesh_files import border_edges, edges, volume


class RandomCurves(unittest.TestCase):
    def test_blocks_are_prefixes_of_longer_blocks_and_differ_from_each_other(self):
        block = Block("wavy", 41, 3)
        long = list(random_curves.curves(block, 5))
        self.assertEqual(list(random_curves.curves(block, 2)), long[:2])
        seeds = {Block(family, points, number).seed for family in random_curves.FAMILIES
                 for points in random_curves.POINTS for number in range(200)}
        self.assertEqual(len(seeds), 2 * 4 * 200)
        self.assertTrue(seeds.isdisjoint({7, 11}))

    def test_a_scaled_curve_is_the_offset_of_the_scaled_profile(self):
        # The middle points of neighbouring contacts: the ball of 10 mm touches z = a t^2 + b t^4 + m x there.
        for (a, b, m, c, radius), points in [next(convex(101)), next(convex(1601))]:
            scaled = random_curves.scaled(points, radius)
            size = RADIUS / radius
            end = 4 + 2 * radius
            for k in range(0, len(points), 17):
                x = -end + 2 * end * k / (len(points) - 1)
                t = x - c
                contact = (size * x, size * (a * t * t + b * t**4 + m * x))
                self.assertAlmostEqual(dist(contact, scaled[k]), RADIUS, delta=1e-7)

    def test_dataset_is_unchanged(self):
        # random-families/wavy.json holds the parameters of the same draws.
        stated = json.loads((ROOT / "datasets/offset-curves/random-families/wavy.json").read_text(encoding="utf-8"))
        for (parameters, _), profile in zip(wavy(), stated[:5]):
            self.assertEqual(parameters, profile["parameters"])

    def test_file_has_a_plane_for_each_curve(self):
        text = random_curves.polyline_text(random_curves.curves(Block("convex", 41, 0), 3))
        rows = [line.split(",") for line in text.splitlines()]
        self.assertEqual(rows[0], ["plane", "s_mm", "z_mm"])
        self.assertEqual([row[0] for row in rows[1:]], [str(k) for k in range(3) for _ in range(41)])


def points_of(content):
    """All control points, or grid points, of a surface."""
    nets = content.get("patches") or [content["control_points"]] if content["type"] != "height-grid" else []
    return [point for net in nets for row in net for point in row]


class RandomSurfaces(unittest.TestCase):
    SURFACES = random_surfaces.random_surfaces()

    def test_there_are_200_different_ones_and_they_are_reproducible(self):
        self.assertEqual(len(self.SURFACES), 200)
        texts = {json.dumps(content) for content in self.SURFACES.values()}
        self.assertEqual(len(texts), 200)
        self.assertEqual(random_surfaces.random_surfaces(1)["nurbs-000"], self.SURFACES["nurbs-000"])

    def test_nets_are_graphs_over_a_rectangle_within_the_stated_lengths(self):
        for name, content in self.SURFACES.items():
            points = points_of(content)
            xs = [p[0] for p in points] or content["x"]
            ys = [p[1] for p in points] or content["y"]
            self.assertEqual((min(xs), min(ys)), (0, 0), name)
            longer, shorter = max(max(xs), max(ys)), min(max(xs), max(ys))
            self.assertTrue(60 <= longer <= 120 and longer / 4.001 <= shorter, name)

    def test_the_curvature_of_waves_is_the_stated_one(self):
        # Second differences along the grid line nearest to the direction of the waves cannot exceed the curvature.
        for number in range(10):
            content = self.SURFACES[f"anisotropic-{number:03}"]
            stated = 1 / float(content["source"].split("1 / ")[1].split(" mm")[0])
            x, rows = content["x"], content["z"]
            step = x[1] - x[0]
            second = max(abs(row[k - 1] - 2 * row[k] + row[k + 1]) for row in rows for k in range(1, len(x) - 1))
            self.assertLess(second / step**2, 1.05 * stated)


class RandomParts(unittest.TestCase):
    def test_the_100_parts_are_closed_oriented_and_different(self):
        parts = random_parts.random_parts()
        self.assertEqual(len(parts), 100)
        volumes = set()
        for part in parts:
            vertices, triangles = part.solid()
            self.assertEqual(border_edges(triangles), [], part)
            self.assertTrue(200 <= len(triangles) <= 4000, part)
            self.assertEqual(len(vertices) - len(edges(triangles)) // 2 + len(triangles), 2, part)  # a sphere, by Euler
            self.assertEqual(len(set(vertices)), len(vertices), part)
            self.assertEqual(min(z for _, _, z in vertices), 0, part)
            volumes.add(round(volume(vertices, triangles), 3))
        self.assertEqual(len(volumes), 100)
        self.assertGreater(min(volumes), 0)

    def test_a_part_of_revolution_has_the_volume_of_its_frusta(self):
        # Prismatoids over regular polygons: h / 3 (A + B + sqrt(A B)).
        profile = [(10, 0), (8, 5), (3, 9)]
        vertices, triangles = random_parts.revolved(profile)
        sectors = random_parts.SECTORS
        area = sectors / 2 * 10**2 * sin(2 * pi / sectors)
        areas = [area * (r / 10)**2 for r, _ in profile]
        expected = sum((z1 - z0) / 3 * (a + b + (a * b)**0.5)
                       for a, b, (_, z0), (_, z1) in zip(areas, areas[1:], profile, profile[1:]))
        self.assertAlmostEqual(volume(vertices, triangles), expected, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
