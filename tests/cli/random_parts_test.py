#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill plan --strategy best on random parts: verdicts, and gouges and coverage by a second computation.

The tests run in a short form of 10 parts. With ENDMILL_FAULTS=long, which chooses the long form of all tests, 90 parts
are planned."""

import csv
import json
import math
import os
import random
import unittest

from program import ProgramTest, endmill

IS_LONG = os.environ.get("ENDMILL_FAULTS") == "long"
# Parts of each kind, from the seed 1 on.
GRIDS = 50 if IS_LONG else 6
MESHES = 20 if IS_LONG else 4
GENTLE, ROUGH, DEEP = 0.15, 0.7, 1.5  # roughness of meshes, mm: the ball reaches all of a gentle one
INNER = 0.01  # inner tolerance, mm
# Distances of this file's own computation agree with the exact ones to this, mm.
ROUNDING = 1e-9


def random_cutter(draw):
    """Diameter of a ball and scallop height, mm."""
    return draw.choice([4, 5, 6, 8]), draw.choice([0.1, 0.2, 0.3])


def height_grid(seed):
    """A surface of random heights over a random grid, a ball's diameter, and a scallop height. The steps of the grid
    are so long against the heights that most of the parts, but not all, are flatter than the ball."""
    draw = random.Random(seed)

    def lines():
        at = [0.0]
        for _ in range(draw.randint(2, 4)):
            at.append(round(at[-1] + draw.uniform(5, 8), 3))
        return at
    x, y = lines(), lines()
    rise = draw.uniform(0, 0.4)
    z = [[round(rise * a + draw.uniform(-0.8, 0.8), 3) for a in x] for _ in y]
    surface = {"format": "endmill-surface/1", "name": f"random grid {seed}", "source": "a test", "type": "height-grid",
               "x": x, "y": y, "z": z}
    return surface, *random_cutter(draw)


def random_mesh(seed, roughness):
    """Facets of a mesh over a grid of random steps, as triples of corners, a ball's diameter, and a scallop height.
    Every edge of the grid is a crease, convex or concave. The heights differ by up to twice the roughness."""
    draw = random.Random(1000 + seed)
    columns, rows = draw.randint(3, 6), draw.randint(3, 6)
    x = [0.0]
    y = [0.0]
    for _ in range(columns):
        x.append(round(x[-1] + draw.uniform(2, 6), 3))
    for _ in range(rows):
        y.append(round(y[-1] + draw.uniform(2, 6), 3))
    z = [[round(draw.uniform(-roughness, roughness), 3) for _ in x] for _ in y]
    facets = []
    for j in range(rows):
        for i in range(columns):
            a, b, c, d = [(x[i + p], y[j + q], z[j + q][i + p]) for p, q in ((0, 0), (1, 0), (1, 1), (0, 1))]
            facets += [(a, b, c), (a, c, d)] if draw.random() < 0.5 else [(a, b, d), (b, c, d)]
    return facets, *random_cutter(draw)


def as_off(facets):
    """The text of an OFF file."""
    corners = sorted({corner for facet in facets for corner in facet})
    number = {corner: k for k, corner in enumerate(corners)}
    lines = ["OFF", f"{len(corners)} {len(facets)} 0"]
    lines += [" ".join(map(str, corner)) for corner in corners]
    lines += ["3 " + " ".join(str(number[corner]) for corner in facet) for facet in facets]
    return "\n".join(lines) + "\n"


def normal_of(facet):
    """The unit normal of a facet."""
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = facet
    ux, uy, uz, vx, vy, vz = bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az
    normal = (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)
    length = math.hypot(*normal)
    return [part / length for part in normal]


class SweptTool:
    """The moves at feed of a written path, by the segments of the ball's centre."""

    def __init__(self, path, radius):
        self.moves = []
        with path.open() as file:
            points = list(csv.DictReader(file))
        for before, point in zip(points, points[1:]):
            if point["move"] not in ("cut", "link"):
                continue
            start, end = ([float(one[f"tip_{axis}_mm"]) for axis in "xyz"] for one in (before, point))
            start[2] += radius
            end[2] += radius
            self.moves.append((start, [b - a for a, b in zip(start, end)]))

    def distance(self, point):
        """Distance of a point from the upright half-lines over all centres. Along a move its square is convex, and
        composed of two parabolas, which meet where the centre is level with the point."""
        least = math.inf
        for (cx, cy, cz), (dx, dy, dz) in self.moves:
            px, py, pz = point[0] - cx, point[1] - cy, point[2] - cz
            level, flat = px * dx + py * dy, dx * dx + dy * dy
            steps = [0.0, 1.0]
            if flat > 0:
                steps.append(level / flat)
            if flat + dz * dz > 0:
                steps.append((level + pz * dz) / (flat + dz * dz))
            if dz:
                steps.append(pz / dz)
            for step in steps:
                s = min(1.0, max(0.0, step))
                below = min(0.0, pz - s * dz)
                least = min(least, (px - s * dx) ** 2 + (py - s * dy) ** 2 + below * below)
        return math.sqrt(least)


class RandomParts(ProgramTest):
    def plan(self, part, diameter, height, strategy="best"):
        """Plans a path and returns the exit status, the summary or None, and the messages."""
        done = endmill("plan", part, "--cutter", f"ball:{diameter}", "--scallop", height, "--inner-tolerance", INNER,
                       "--strategy", strategy, "--bound", "none", "-o", "out", "--force", "--json", cwd=self.folder)
        return done.returncode, json.loads(done.stdout) if done.stdout else None, done.stderr

    def assert_clean(self, facts, height):
        """Asserts that the path is judged clean, in a second run too."""
        self.assertEqual((facts["verdict"], facts["uncovered_mm2"]), ("clean", 0))
        self.assertLessEqual(facts["max_left_mm"], height)
        self.assertLessEqual(facts["max_gouge_mm"], INNER)
        seen = self.summary("verify", self.folder / "out/toolpath.csv", "--resolution", "0.3", "-o", "seen", "--force")
        self.assertEqual(seen["verdict"], "clean")

    def swept_tool(self, diameter):
        return SweptTool(self.folder / "out/toolpath.csv", diameter / 2)

    def assert_not_gouged(self, facets, diameter):
        """Asserts that the ball enters the mesh neither at its corners nor in the middle of its facets."""
        tool = self.swept_tool(diameter)
        centres = {tuple(sum(corner[k] for corner in facet) / 3 for k in range(3)) for facet in facets}
        for point in centres.union(*facets):
            self.assertGreaterEqual(tool.distance(point), diameter / 2 - INNER - ROUNDING)

    def test_height_grids_are_cut_clean_or_refused_with_the_place(self):
        planned = 0
        for seed in range(1, GRIDS + 1):
            with self.subTest(seed=seed):
                surface, diameter, height = height_grid(seed)
                status, facts, messages = self.plan(self.file(surface), diameter, height)
                if status == 4:  # the surface is curved more than the ball somewhere
                    self.assertRegex(messages, r"expected a smaller radius than the limit of the surface, .* at u = ")
                    continue
                self.assertEqual(status, 0, messages)
                self.assert_clean(facts, height)
                tool = self.swept_tool(diameter)
                for y, row in zip(surface["y"], surface["z"]):
                    for x, z in zip(surface["x"], row):
                        self.assertGreaterEqual(tool.distance((x, y, z)), diameter / 2 - INNER - ROUNDING)
                planned += 1
        self.assertGreaterEqual(planned, 0.9 * GRIDS)

    def test_meshes_are_cut_clean(self):
        for seed in range(1, MESHES + 1):
            with self.subTest(seed=seed):
                facets, diameter, height = random_mesh(seed, GENTLE)
                status, facts, messages = self.plan(self.file(as_off(facets), "part.off"), diameter, height)
                self.assertEqual(status, 0, messages)
                self.assert_clean(facts, height)
                self.assertEqual(facts["unreached_mm2"], 0)
                self.assert_not_gouged(facets, diameter)
                tool = self.swept_tool(diameter)
                for facet in facets:
                    centre = [sum(corner[k] for corner in facet) / 3 for k in range(3)]
                    raised = [a + height * b for a, b in zip(centre, normal_of(facet))]
                    self.assertLessEqual(tool.distance(raised), diameter / 2 + ROUNDING)

    def test_no_clean_path_over_a_mesh_is_shorter_than_its_bound(self):
        for seed in range(1, MESHES // 2 + 1):
            facets, diameter, height = random_mesh(seed, GENTLE)
            part = self.file(as_off(facets), "part.off")
            for strategy in ("planar", "iso-scallop"):
                with self.subTest(seed=seed, strategy=strategy):
                    facts = self.summary("plan", part, "--cutter", f"ball:{diameter}", "--scallop", height, "--strategy",
                                         strategy, "--distance", "cl", "-o", "out", "--force")
                    self.assertEqual((facts["verdict"], facts["bound_grade"]), ("clean", "estimated"))
                    self.assertGreater(facts["cut_tip_mm"], facts["bound_mm"])
                    # creases are flat here: a bound much lower would say little
                    self.assertLess(facts["travel_over_bound"], 2)

    @unittest.skipUnless(IS_LONG, "ENDMILL_FAULTS=long runs it")
    def test_rough_meshes_are_cut_clean_where_the_ball_reaches(self):
        for seed in range(1, MESHES + 1):
            with self.subTest(seed=seed):
                facets, diameter, height = random_mesh(seed, ROUGH)
                status, facts, messages = self.plan(self.file(as_off(facets), "part.off"), diameter, height)
                self.assertEqual(status, 0, messages)
                self.assert_clean(facts, height)
                self.assert_not_gouged(facets, diameter)

    def test_passes_over_deep_creases_end(self):
        # a stretch beside a crease could be straightened again and again, each time into more moves
        for seed in (5, 7):
            with self.subTest(seed=seed):
                facets, diameter, height = random_mesh(seed, DEEP)
                status, facts, messages = self.plan(self.file(as_off(facets), "part.off"), diameter, height, "planar")
                self.assertEqual(status, 0, messages)
                self.assert_clean(facts, height)
                self.assert_not_gouged(facets, diameter)

    def test_what_is_left_beside_deep_creases_is_cut_by_a_path_for_a_lower_height(self):
        # the first path leaves 0.106 and 0.116 mm
        for seed in (6, 12):
            with self.subTest(seed=seed):
                facets, diameter, height = random_mesh(seed, DEEP)
                status, facts, messages = self.plan(self.file(as_off(facets), "part.off"), diameter, height, "iso-scallop")
                self.assertEqual(status, 0, messages)
                self.assert_clean(facts, height)
                self.assert_not_gouged(facets, diameter)

    def test_a_detour_over_a_corner_of_a_mesh_is_tested(self):
        # the ball touches a corner beside the border of this mesh in many places
        facets, diameter, height = random_mesh(5, ROUGH)
        status, facts, messages = self.plan(self.file(as_off(facets), "part.off"), diameter, height, "iso-scallop")
        self.assertEqual(status, 0, messages)
        self.assert_clean(facts, height)
        self.assert_not_gouged(facets, diameter)


if __name__ == "__main__":
    unittest.main()
