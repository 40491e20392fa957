#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill plan --protect and verify --protect: another part that the path must not enter."""

import csv
import hashlib
import json
import unittest

from program import SURFACES, ProgramTest, endmill, plane

BALL = ["--cutter", "ball:10", "--scallop", "0.5", "--bound", "none"]
SIZE = (60, 40)
RADIUS = 5
# That contacts keep from a protected mesh, mm: a quarter of the inner tolerance.
KEPT = 0.0025
SCALLOP_STRATEGY = ["--strategy", "iso-scallop"]


def box(low, high):
    """A mesh file (OFF) of the closed box between two corners."""
    corners = [[(high if k >> c & 1 else low)[c] for c in range(3)] for k in range(8)]
    faces = ["0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5"]
    lines = ["OFF", "8 6 0", *(" ".join(map(str, corner)) for corner in corners), *(f"4 {face}" for face in faces)]
    return "\n".join(lines) + "\n"


WALL = box((50, -20, -5), (70, 60, 30))


class Protect(ProgramTest):
    def setUp(self):
        super().setUp()
        self.part = self.file(json.dumps(plane(size=SIZE)), "floor.json")
        self.wall = self.file(WALL, "wall.off")

    def points(self, folder):
        with (self.folder / folder / "toolpath.csv").open() as file:
            return list(csv.DictReader(file))

    def test_path_beside_a_wall_keeps_off_it_and_verify_agrees(self):
        facts = self.summary("plan", self.part, "--protect", self.wall, *BALL, *SCALLOP_STRATEGY, "-o", "beside")
        self.assertEqual((facts["verdict"], facts["uncovered_mm2"]), ("clean", 0))
        self.assertLessEqual(facts["protected_max_gouge_mm"], 0.01)
        self.assertEqual(facts["protected_sha256"], hashlib.sha256(WALL.encode()).hexdigest())
        self.assertAlmostEqual(facts["unreached_mm2"], (SIZE[0] - 50 + RADIUS + KEPT) * SIZE[1], delta=2)
        # 5 mm above the wall
        self.assertEqual(facts["safe_height_mm"], 35)
        for point in self.points("beside"):
            x, z = float(point["tip_x_mm"]), float(point["tip_z_mm"])
            self.assertTrue(x <= 50 - RADIUS or z >= 30, (x, z))
        seen = self.summary("verify", self.folder / "beside" / "toolpath.csv", "--resolution", "0.4", "-o", "seen")
        self.assertEqual(seen["verdict"], "clean")
        self.assertLessEqual(seen["protected_max_gouge_mm"], 0.01)
        self.assertGreater(seen["inaccessible_area_mm2"], 0)
        # without the wall, what it bars counts
        done = endmill("verify", self.folder / "beside" / "toolpath.csv", "--protect", "none", "--resolution", "0.4",
                       "-o", "alone", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(json.loads((self.folder / "alone" / "summary.json").read_text())["verdict"], "uncut")

    def test_verify_finds_the_gouge_of_a_path_without_protection(self):
        self.summary("plan", self.part, *BALL, *SCALLOP_STRATEGY, "-o", "through")
        done = endmill("verify", self.folder / "through" / "toolpath.csv", "--protect", self.wall, "--resolution", "0.4",
                       "-o", "seen", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        seen = json.loads((self.folder / "seen" / "summary.json").read_text())
        self.assertEqual(seen["verdict"], "gouged")
        self.assertGreater(seen["protected_max_gouge_mm"], 1)

    def test_distant_part_changes_no_byte_of_the_path(self):
        distant = self.file(box((500, 0, -9), (510, 10, -3)), "distant.off")
        part = SURFACES / "saddle.json"
        self.summary("plan", part, *BALL, *SCALLOP_STRATEGY, "-o", "alone")
        facts = self.summary("plan", part, "--protect", distant, *BALL, *SCALLOP_STRATEGY, "-o", "beside")
        self.assertEqual((facts["unreached_mm2"], facts["protected_max_gouge_mm"]), (0, 0))
        for name in ("toolpath.csv", "toolpath.vtp"):
            self.assertEqual((self.folder / "beside" / name).read_bytes(), (self.folder / "alone" / name).read_bytes())

    def test_path_does_not_depend_on_the_number_of_threads(self):
        tables = []
        for threads in (1, 2, 3):
            self.summary("plan", self.part, "--protect", self.wall, *BALL, *SCALLOP_STRATEGY, "--threads", threads,
                         "-o", f"by{threads}")
            tables.append((self.folder / f"by{threads}" / "toolpath.csv").read_bytes())
        self.assertEqual(tables[0], tables[1])
        self.assertEqual(tables[0], tables[2])

    def test_units_apply_to_the_mesh_beside_a_surface(self):
        inches = box((50 / 25.4, -1, -0.2), (70 / 25.4, 60 / 25.4, 30 / 25.4))
        wall = self.file(inches, "inches.off")
        facts = self.summary("plan", self.part, "--protect", wall, "--units", "inch", *BALL, *SCALLOP_STRATEGY, "-o", "inches")
        self.assertEqual(facts["protected_units"], "inch")
        self.assertNotIn("part_units", facts)
        self.assertAlmostEqual(facts["unreached_mm2"], (SIZE[0] - 50 + RADIUS + KEPT) * SIZE[1], delta=2)

    def test_refusals(self):
        roof = self.file(box((-20, -20, 20), (90, 70, 30)), "roof.off")
        through = self.file(box((28, -20, -5), (32, 60, 30)), "through.off")
        plan = ["plan", self.part, *BALL]
        cases = [
            (4, [*plan, "--protect", roof, "-o", "a"], "bars"),
            (4, [*plan, "--protect", self.wall, "--strategy", "iso-u", "-o", "b"], "protected part"),
            # a rapid over the wall from one side to the other
            (4, [*plan, "--protect", through, "--strategy", "iso-scallop", "--safe-height", "6", "-o", "c"],
             "the rapid from"),
            (2, [*plan[:2], "--cutter", "ball:10", "--protect", self.wall, "--strategy", "iso", "-o", "d"], "--protect"),
            (2, [*plan[:2], "--cutter", "flat:10", "--protect", self.wall, "-o", "e"], "--protect"),
            (2, [*plan, "--protect", self.wall, "--strategy", "iso-u", "--axis", "0,0.1,1", "-o", "f"], "--axis"),
            (3, [*plan, "--protect", self.file("OFF\n8 6", "cut.off"), "-o", "g"], "cut.off"),
            (3, [*plan, "--protect", self.folder / "missing.off", "-o", "h"], "missing.off"),
        ]
        for code, command, word in cases:
            with self.subTest(command=command):
                done = endmill(*command, cwd=self.folder)
                self.assertEqual(done.returncode, code, done.stderr)
                self.assertIn(word, done.stderr)


if __name__ == "__main__":
    unittest.main()
