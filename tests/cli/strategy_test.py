#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill plan --strategy: the strategies, their comparison, and the verdict of `verify` on their paths."""

import csv
import io
import json
import math
import unittest

from program import SURFACES, ProgramTest, endmill, plane

BALL = ["--cutter", "ball:15", "--scallop", "0.5"]
PLANE_SIZE = (60, 40)
# Width of a strip on a plane, mm: 2 sqrt(h (2R - h)).
WIDTH = 2 * math.sqrt(0.5 * (15 - 0.5))


def cut_length(path):
    """Sum of the chords between contacts of cutting moves, from the written points."""
    with path.open() as file:
        points = list(csv.DictReader(file))
    total = 0.0
    for before, point in zip(points, points[1:]):
        if point["move"] == "cut":
            total += math.dist([float(before[f"contact_{axis}_mm"]) for axis in "xyz"],
                               [float(point[f"contact_{axis}_mm"]) for axis in "xyz"])
    return total


class Strategies(ProgramTest):
    def test_every_strategy_covers_and_verify_agrees(self):
        part = SURFACES / "saddle.json"
        for strategy in ("iso-u", "iso-v", "planar", "iso-scallop"):
            with self.subTest(strategy=strategy):
                facts = self.summary("plan", part, *BALL, "--strategy", strategy, "--bound", "none", "-o", strategy)
                self.assertEqual(facts["strategy"], strategy)
                self.assertEqual((facts["verdict"], facts["uncovered_mm2"]), ("clean", 0))
                seen = self.summary("verify", self.folder / strategy / "toolpath.csv", "--resolution", "0.4", "-o", f"{strategy}-seen")
                self.assertEqual(seen["verdict"], "clean")
                self.assertAlmostEqual(cut_length(self.folder / strategy / "toolpath.csv") / facts["cut_contact_mm"],
                                       1, delta=1e-9)

    def test_verify_finds_what_a_missing_pass_leaves(self):
        part = SURFACES / "saddle.json"
        self.summary("plan", part, *BALL, "--strategy", "iso-scallop", "--bound", "none", "-o", "whole")
        with (self.folder / "whole" / "toolpath.csv").open() as file:
            table = csv.DictReader(file)
            names, points = table.fieldnames, list(table)
        last = points[-1]["pass"]
        self.assertGreater(int(last), 5)
        text = io.StringIO()
        writer = csv.DictWriter(text, names, lineterminator="\n")
        writer.writeheader()
        writer.writerows(point for point in points if point["pass"] != last)
        limits = ["--part", part, "--cutter", "ball:15", "--tolerance", "0.01", "--scallop", "0.5", "--resolution", "0.4"]
        self.summary("verify", self.folder / "whole" / "toolpath.csv", *limits, "-o", "all")
        done = endmill("verify", self.file(text.getvalue(), "rest.csv"), *limits, "-o", "rest", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        facts = json.loads((self.folder / "rest" / "summary.json").read_text())
        self.assertEqual(facts["verdict"], "uncut")
        # between the neighbours of a pass that is a strip apart, at least the scallop of two strips remains
        self.assertGreater(facts["max_scallop_mm"], 1)

    def test_small_ball_on_a_part_of_many_samples_is_clean(self):
        # with samples only 2.5 across a strip this path left 0.502 mm
        facts = self.summary("plan", SURFACES / "net_rot24_7D.json", "--cutter", "ball:7.5", "--scallop", "0.5", "--strategy",
                             "iso-scallop", "--bound", "none", "-o", "small")
        self.assertEqual(facts["verdict"], "clean")
        self.assertLessEqual(facts["max_left_mm"], 0.5)

    def test_best_is_the_shortest_of_those_tried(self):
        for distance, key in (("contact", "cut_contact_mm"), ("cl", "cut_tip_mm")):
            with self.subTest(distance=distance):
                facts = self.summary("plan", SURFACES / "saddle.json", *BALL, "--strategy", "best", "--bound", "none",
                                     "--distance", distance, "-o", distance)
                lengths = {one["strategy"]: one["cut_mm"] for one in facts["tried"]}
                self.assertGreaterEqual(set(lengths), {"iso-u", "iso-v", "planar", "iso-scallop"})
                self.assertEqual(facts[key], min(length for length in lengths.values() if length is not None))
                for one in facts["tried"]:
                    if one["cut_mm"] is None:
                        self.assertGreater(one["estimated_mm"], 1.05 * facts[key])
                self.assertEqual(lengths[facts["strategy"]], facts[key])
                alone = self.summary("plan", SURFACES / "saddle.json", *BALL, "--strategy", "iso-v", "--bound", "none",
                                     "--distance", distance, "-o", f"{distance}-v")
                self.assertEqual(alone[key], lengths["iso-v"])

    def test_flat_and_bull_nose_cutters_in_upright_planes(self):
        part = self.file(json.dumps(plane(size=PLANE_SIZE)), "plane.json")
        for cutter, width in (("flat:10", 10), ("bull:10:2", 6 + 2 * math.sqrt(0.2 * 3.8))):
            with self.subTest(cutter=cutter):
                facts = self.summary("plan", part, "--cutter", cutter, "--scallop", "0.2", "-o", cutter.replace(":", "-"))
                self.assertEqual((facts["strategy"], facts["cutter"], facts["verdict"]), ("planar", cutter, "clean"))
                self.assertIsNone(facts["cut_contact_mm"])
                self.assertNotIn("bound_mm", facts)
                self.assertGreaterEqual(facts["cut_tip_mm"], PLANE_SIZE[0] * (PLANE_SIZE[1] / width - 1))
        result = endmill("plan", part, "--cutter", "flat:10", "--strategy", "field")
        self.assertEqual(result.returncode, 2)
        self.assertIn("--cutter flat:10 with --strategy field", result.stderr)

    def test_mesh_is_a_part_and_verify_agrees(self):
        # a roof of two planes with a ridge along x
        roof = "OFF\n6 4 0\n0 0 0\n40 0 0\n0 20 8\n40 20 8\n0 40 0\n40 40 0\n" \
               "3 0 1 3\n3 0 3 2\n3 2 3 5\n3 2 5 4\n"
        part = self.file(roof, "roof.off")
        facts = self.summary("plan", part, *BALL, "--strategy", "best", "-o", "out")
        self.assertEqual((facts["verdict"], facts["uncovered_mm2"], facts["unreached_mm2"]), ("clean", 0, 0))
        # of tips: both planes together have 1723 mm2, the strip is 5.4 mm wide
        self.assertEqual((facts["bound_grade"], facts["bound_distance"]), ("estimated", "cl"))
        self.assertAlmostEqual(facts["bound_density_mm"], 1723 / 5.44, delta=0.03 * 1723 / 5.44)
        self.assertAlmostEqual(facts["travel_over_bound"], facts["cut_tip_mm"] / facts["bound_mm"], places=12)
        self.assertGreater(facts["travel_over_bound"], 1)
        self.assertTrue((self.folder / "out/density.svg").exists())
        refused = {one["strategy"] for one in facts["tried"] if one["cut_mm"] is None}
        self.assertGreaterEqual(refused, {"iso-u", "iso-v"})
        seen = self.summary("verify", self.folder / "out" / "toolpath.csv", "--resolution", "0.4", "-o", "seen")
        self.assertEqual(seen["verdict"], "clean")
        for name in ("toolpath.svg", "toolpath.vtp"):
            self.assertGreater((self.folder / "out" / name).stat().st_size, 1000)

    def test_mesh_of_a_surface_is_cut_in_a_path_as_long_as_on_the_surface(self):
        part = SURFACES / "saddle.json"
        self.summary("sample", part, "--chord-tolerance", "0.01", "--format", "off", "-o", "mesh")
        options = [*BALL, "--strategy", "iso-scallop", "--bound", "none"]
        on_surface = self.summary("plan", part, *options, "-o", "surface")
        on_mesh = self.summary("plan", self.folder / "mesh/mesh.off", *options, "-o", "facets")
        self.assertEqual((on_mesh["verdict"], on_mesh["uncovered_mm2"]), ("clean", 0))
        for key in ("cut_contact_mm", "cut_tip_mm"):
            self.assertAlmostEqual(on_mesh[key] / on_surface[key], 1, delta=0.015)

    def test_certified_bound_of_a_mesh_is_refused_with_a_reason(self):
        part = self.file("OFF\n3 1 0\n0 0 0\n40 0 0\n0 40 0\n3 0 1 2\n", "one.off")
        facts = self.summary("plan", part, *BALL, "--strategy", "planar", "--bound", "certified", "-o", "out")
        self.assertIsNone(facts["bound_mm"])
        self.assertIn("can only be estimated", facts["bound_reason"])

    def test_mesh_needs_a_cutter_and_a_strategy_without_parameters(self):
        part = self.file("OFF\n3 1 0\n0 0 0\n20 0 0\n0 20 0\n3 0 1 2\n", "one.off")
        for options, word in ((["--strategy", "iso"], "--strategy iso"), ([], "--cutter")):
            with self.subTest(options=options):
                done = endmill("plan", part, *options, "-o", self.folder / "no")
                self.assertEqual(done.returncode, 2)
                self.assertIn(word, done.stderr)
        down = self.file("OFF\n3 1 0\n0 0 0\n20 0 0\n0 20 0\n3 0 2 1\n", "down.off")
        done = endmill("plan", down, *BALL, "--strategy", "best", "-o", self.folder / "no")
        self.assertEqual(done.returncode, 4)
        self.assertIn("faces the tool", done.stderr)

    def test_lower_bound_of_a_plane_has_its_closed_form(self):
        facts = self.summary("plan", self.file(plane(size=PLANE_SIZE)), *BALL, "--strategy", "best", "-o", "out")
        pieces = facts["pieces"]
        # the bound is for paths that stray by gamma, which widens the strip
        gamma = facts["bound_gamma_mm"]
        width = 2 * math.sqrt((7.5 + gamma) ** 2 - 7 ** 2)
        area = PLANE_SIZE[0] * PLANE_SIZE[1]
        self.assertAlmostEqual(facts["bound_density_mm"], area / width, delta=1e-9 * area)
        self.assertAlmostEqual(facts["bound_disc_mm"], math.pi * width / 4, delta=1e-9)
        self.assertAlmostEqual(facts["bound_mm"], area / width - pieces * math.pi * width / 4, delta=1e-9 * area)
        self.assertEqual(facts["bound_grade"], "closed")
        self.assertAlmostEqual(facts["travel_over_bound"], facts["cut_contact_mm"] / facts["bound_mm"], places=12)
        self.assertLess(facts["cut_contact_mm"], 1.15 * area / WIDTH)

    def test_part_smaller_than_a_disc_has_no_bound(self):
        done = endmill("plan", self.file(plane(size=(1, 1))), *BALL, "--strategy", "iso-scallop", "-o", "out",
                       cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        facts = json.loads((self.folder / "out/summary.json").read_text())
        self.assertIsNone(facts["bound_mm"])
        self.assertIsNone(facts["travel_over_bound"])
        self.assertIn("lower bound   none", done.stdout)


class UprightPlanes(ProgramTest):
    def test_best_direction_is_the_least_of_those_compared(self):
        facts = self.summary("plan", self.file(plane(size=PLANE_SIZE)), *BALL, "--strategy", "planar", "--bound", "none",
                             "-o", "out")
        with (self.folder / "out/angles.csv").open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["angle_deg", "cut_contact_mm", "cut_tip_mm", "passes"])
        angles = [float(row["angle_deg"]) for row in rows]
        self.assertEqual(angles, sorted(angles))
        for step in range(36):
            self.assertTrue(any(abs(angle - 5 * step) < 1e-9 for angle in angles), step)
        # strips across 60 mm: 12 of 40 mm; across 40 mm: 8 of 60 mm; an end may stop 0.57 mm before the border
        self.assertLessEqual(facts["cut_contact_mm"], 480)
        self.assertGreaterEqual(facts["cut_contact_mm"], 480 - 2 * 12 * 0.57)
        self.assertIn(facts["direction_deg"], (0, 90))
        self.assertIn("by contacts", (self.folder / "out/angles.svg").read_text())

    def test_given_direction_is_followed_and_not_compared(self):
        part = self.file(plane(size=PLANE_SIZE))
        self.summary("plan", part, *BALL, "--direction", "best", "--bound", "none", "-o", "out")
        facts = self.summary("plan", part, *BALL, "--direction-deg", "45", "--bound", "none", "-o", "out", "--force")
        self.assertEqual((facts["strategy"], facts["direction_deg"]), ("planar", 45))
        self.assertFalse((self.folder / "out/angles.csv").exists())
        self.assertFalse((self.folder / "out/angles.svg").exists())
        # but for contact links between passes, the cuts run in that direction
        with (self.folder / "out/toolpath.csv").open() as file:
            points = list(csv.DictReader(file))
        along = sum(math.dist([float(before[f"contact_{axis}_mm"]) for axis in "xy"],
                              [float(point[f"contact_{axis}_mm"]) for axis in "xy"])
                    for before, point in zip(points, points[1:]) if point["move"] == "cut" and
                    abs(sum(sign * (float(point[f"contact_{axis}_mm"]) - float(before[f"contact_{axis}_mm"]))
                            for axis, sign in (("x", 1), ("y", -1)))) < 1e-6)
        self.assertGreaterEqual(along, 0.9 * facts["cut_contact_mm"])

    def test_directions_are_refused_where_they_have_no_effect(self):
        part = self.file(plane())
        for options, expected in ((["--strategy", "planar", "--direction", "u"], "--direction best"),
                                  (["--strategy", "iso-scallop", "--direction-deg", "3"], "--strategy planar"),
                                  (["--strategy", "iso", "--direction-deg", "3"], "--strategy planar"),
                                  (["--strategy", "iso", "--direction", "best"], "--strategy planar"),
                                  (["--direction", "best", "--direction-deg", "3"], "one of the two")):
            with self.subTest(options=options):
                done = endmill("plan", part, *options, "-o", "out", cwd=self.folder)
                self.assert_refused(done, 2, "--direction", expected)
        self.assert_refused(endmill("plan", part, "--direction-deg", "nan", "-o", "out", cwd=self.folder), 2,
                            "--direction-deg", "360")


class Defaults(ProgramTest):
    def test_best_is_the_default(self):
        part = self.file(plane(size=PLANE_SIZE))
        by_default = self.summary("plan", part, *BALL, "--bound", "none", "-o", "default")
        by_name = self.summary("plan", part, *BALL, "--bound", "none", "--strategy", "best", "-o", "best")
        self.assertEqual(by_default["tried"], by_name["tried"])
        self.assertEqual((self.folder / "default/toolpath.csv").read_bytes(), (self.folder / "best/toolpath.csv").read_bytes())

    def test_mode_paper_chooses_iso(self):
        self.summary("plan", self.file(plane(size=PLANE_SIZE)), *BALL, "--mode", "paper", "-o", "out")
        self.assertEqual(sorted(path.name for path in (self.folder / "out").iterdir() if path.is_dir()), ["u", "v"])

    def test_option_of_iso_chooses_iso(self):
        part = self.file(plane(size=(60, 30)))
        self.summary("plan", part, *BALL, "--direction", "u", "-o", "u")
        self.summary("plan", part, *BALL, "--outer-tolerance", "0.01", "-o", "both")
        self.assertTrue((self.folder / "both/u/toolpath.csv").is_file())
        facts = json.loads((self.folder / "u/summary.json").read_text())
        self.assertNotIn("strategy", facts)

    def test_options_of_iso_are_refused_by_name(self):
        part = self.file(plane())
        for option in (["--direction", "u"], ["--outer-tolerance", "0.1"], ["--mode", "paper"],
                       ["--inner-tolerance", "0"]):
            with self.subTest(option=option):
                done = endmill("plan", part, "--strategy", "iso-scallop", *option, "-o", "out", cwd=self.folder)
                self.assert_refused(done, 2, option[0], "--strategy iso")

    def test_other_axis_changes_nothing_but_the_tips(self):
        # a ball touches a plane in the same contacts, however it leans
        part = self.file(plane())
        for strategy in ("iso-scallop", "planar", "best"):
            with self.subTest(strategy=strategy):
                upright = self.summary("plan", part, *BALL, "--strategy", strategy, "--bound", "none", "-o", f"{strategy}-up")
                facts = self.summary("plan", part, *BALL, "--strategy", strategy, "--axis", "1,0,1", "--bound", "none", "-o",
                                     f"{strategy}-tilted")
                self.assertEqual(facts["verdict"], "clean")
                self.assertAlmostEqual(facts["axis"][0], math.sqrt(0.5), places=12)
                self.assertLess(abs(facts["cut_contact_mm"] / upright["cut_contact_mm"] - 1), 0.05)


if __name__ == "__main__":
    unittest.main()
