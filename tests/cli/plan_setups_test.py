#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The chain from setup to post: --skip-facets, plan --axis and --setup on meshes, and plan --setups (3+2 axes)."""

import csv
import json
import math
import unittest

from program import ROOT, ProgramTest, endmill

MACHINES = ROOT / "datasets/machines"
LIMITS = ["--scallop", "0.2", "--inner-tolerance", "0.02"]
BALL = ["--cutter", "ball:4", "--bound", "none", *LIMITS]
CORNERS = ([1, 1, 1], [-1, -1, 1])


def cube(side=8):
    """A mesh file (OFF) of a cube on the plane z = 0. The first two facets are its bottom."""
    corners = [[side * (k >> c & 1) for c in range(3)] for k in range(8)]
    faces = ["0 2 3", "0 3 1", "4 5 7", "4 7 6", "0 1 5", "0 5 4", "2 6 7", "2 7 3", "0 4 6", "0 6 2", "1 3 7", "1 7 5"]
    lines = ["OFF", "8 12 0", *(" ".join(map(str, corner)) for corner in corners), *(f"3 {face}" for face in faces)]
    return "\n".join(lines) + "\n"


def step():
    """A mesh file of a block with a step along y, and the facets of its ends and its bottom."""
    outline = [(0, 0), (12, 0), (12, 4), (6, 4), (6, 12), (0, 12)]
    points = [(x, y, z) for y in (0, 8) for x, z in outline]
    ends = ["0 1 2", "0 2 3", "0 3 4", "0 4 5", "6 8 7", "6 9 8", "6 10 9", "6 11 10"]
    sides = []
    for k in range(6):
        a, b = k, (k + 1) % 6
        sides += [f"{a} {a + 6} {b + 6}", f"{a} {b + 6} {b}"]
    lines = ["OFF", "12 20 0", *(" ".join(map(str, point)) for point in points), *(f"3 {face}" for face in ends + sides)]
    return "\n".join(lines) + "\n", range(10)


def setups(*directions):
    """The summary.json of a setup with these directions."""
    axes = [[x / math.hypot(*direction) for x in direction] for direction in directions]
    return {"configuration": "W/xyBz/T", "setups": [{"tool_axis": axis, "facets": []} for axis in axes]}


class Chain(ProgramTest):
    def setUp(self):
        super().setUp()
        self.part = self.file(cube(), "cube.off")
        self.bottom = self.file("# the cube stands on these\n0\n1\n", "bottom.txt")

    def points(self, folder):
        with (self.folder / folder / "toolpath.csv").open() as file:
            return list(csv.DictReader(file))

    def axes(self, folder):
        return {tuple(round(float(row[f"axis_{c}"]), 9) for c in "xyz") for row in self.points(folder)}


class PlanSetups(Chain):
    def test_cube_from_two_corners_is_clean_but_for_its_bottom(self):
        facts = self.summary("plan", self.part, *BALL, "--setups", self.file(setups(*CORNERS), "s.json"),
                             "--skip-facets", self.bottom, "--strategy", "planar", "-o", "out")
        self.assertEqual((facts["uncovered_facets"], facts["is_good"], facts["skipped"]), ([], True, 2))
        self.assertEqual([one["facets"] for one in facts["directions"]], [6, 4])
        seen = self.summary("verify", self.folder / "out/toolpath.csv", "--resolution", "0.4", "-o", "seen")
        self.assertEqual((seen["verdict"], seen["engine"]), ("clean", "five-axis"))
        # code for two machines of different kinds
        for machine, clamp in (("ca-table-table", "0,0,0"), ("cb-head-head", "0,0,120")):
            posted = self.summary("post", self.folder / "out/toolpath.csv", "--machine", MACHINES / f"{machine}.json",
                                  "--feed", "600", "--clamp", clamp, "-o", machine)
            self.assertLessEqual(posted["max_tip_error_mm"], 0.01)
            self.assertTrue(any((self.folder / machine).glob("*.ngc")))

    def test_setups_of_the_command_setup_lead_to_a_plan(self):
        # all rays within 60 degrees of a facet's normal: directions near the corners of the cube
        found = self.summary("setup", self.part, "--machine", "W/xyBz/T", "--max-setups", "4", "--skip-facets", self.bottom,
                             "--incidence-deg", "60", "-o", "setup", status=1)
        self.assertEqual((found["uncovered"], found["skipped_facets"]), ([], [0, 1]))
        facts = self.summary("plan", self.part, *BALL, "--setups", self.folder / "setup/summary.json", "--skip-facets",
                             self.bottom, "--strategy", "planar", "-o", "out")
        self.assertTrue(facts["is_good"])
        self.assertLessEqual(len(facts["directions"]), len(found["setups"]))

    def test_corner_that_no_ball_reaches_is_not_judged(self):
        mesh, left = step()
        part = self.file(mesh, "step.off")
        skipped = self.file("".join(f"{facet}\n" for facet in left), "left.txt")
        facts = self.summary("plan", part, *BALL, "--setups", self.file(setups([1, 0.2, 1.2], [-1, 0.2, 1]), "s.json"),
                             "--skip-facets", skipped, "--strategy", "planar", "-o", "out")
        self.assertEqual((facts["is_good"], facts["inaccessible"]), (True, "report"))
        path = self.folder / "out/toolpath.csv"
        seen = self.summary("verify", path, "--resolution", "0.2", "-o", "seen")
        self.assertEqual(seen["verdict"], "clean")
        # on both sides of the corner the ball, R = 2, leaves at least half of the limit, 0.1, up to s:
        # R - sqrt(R^2 - (R - s)^2) = 0.1
        s = 2 - math.sqrt(4 - 1.9 ** 2)
        self.assertGreater(seen["inaccessible_area_mm2"], 2 * 8 * s - 0.5)
        self.assertLess(seen["inaccessible_area_mm2"], 2 * 8 * 2)
        counted = self.summary("verify", path, "--resolution", "0.2", "--inaccessible", "count", "-o", "counted", status=1)
        self.assertEqual(counted["verdict"], "uncut")

    def test_facets_that_no_direction_sees_are_named(self):
        facts = self.summary("plan", self.part, *BALL, "--setups", self.file(setups(*CORNERS), "s.json"), "--strategy",
                             "planar", "-o", "out", status=1)
        self.assertEqual(facts["uncovered_facets"], [0, 1])
        self.assertEqual(len(self.axes("out") & {tuple(round(x / math.sqrt(3), 9) for x in axis) for axis in CORNERS}), 2)

    def test_path_does_not_depend_on_the_number_of_threads(self):
        summary = self.file(setups(*CORNERS), "s.json")
        tables = []
        for threads in (1, 2, 3, 8):
            self.summary("plan", self.part, *BALL, "--setups", summary, "--skip-facets", self.bottom, "--strategy",
                         "planar", "--threads", threads, "-o", f"by{threads}")
            tables.append((self.folder / f"by{threads}" / "toolpath.csv").read_bytes())
        self.assertEqual(len(set(tables)), 1)

    def test_refusals(self):
        good = self.file(setups(*CORNERS), "s.json")
        surface = ROOT / "datasets/surfaces/plane.json"
        cases = [
            (2, [surface, *BALL, "--setups", good], "mesh"),
            (2, [self.part, "--setups", good], "--cutter"),
            (2, [self.part, "--cutter", "flat:4", "--setups", good], "ball"),
            (2, [self.part, *BALL, "--setups", good, "--axis", "1,0,0"], "--axis"),
            (2, [self.part, *BALL, "--setups", good, "--setup", good], "--setup"),
            (3, [self.part, *BALL, "--setups", self.folder / "missing.json"], "missing.json"),
            (3, [self.part, *BALL, "--setups", self.file({"setups": []}, "none.json")], "no setup"),
            (3, [self.part, *BALL, "--setups", self.file({"setups": [{"tool_axis": [0, 0, 3]}]}, "l.json")],
             "/setups/0/tool_axis"),
            (4, [self.part, *BALL, "--setups", self.file(setups([0, 0, -1]), "down.json"), "--skip-facets", self.bottom],
             "no facet"),
            (3, [self.part, *BALL, "--skip-facets", self.file("".join(f"{k}\n" for k in range(12)), "all.txt")],
             "all.txt: the list names all facets"),
            (3, [self.part, *BALL, "--setups", self.file({**setups(*CORNERS), "facets": 9999}, "other.json")],
             "other.json:/facets: 9999; expected 12"),
            (2, [self.part, *BALL, "--setups", good, "--machine", "W/caxyBz/T"], "no effect with --setups"),
        ]
        for code, command, word in cases:
            with self.subTest(command=command):
                done = endmill("plan", *command, "-o", "no", cwd=self.folder)
                self.assert_refused(done, code, word)
                self.assertFalse((self.folder / "no").exists())


class SkipFacets(Chain):
    def test_setup_needs_no_direction_for_them(self):
        # every axis is below the plane of one face by asin(1/sqrt(3)) = 35.3 degrees or more
        machine = ["--machine", "W/caxyBz/T", "--limits", "a=-30:30"]
        down = self.summary("setup", self.part, *machine, "-o", "all", status=1)
        self.assertFalse(down["machinable"])
        found = self.summary("setup", self.part, *machine, "--skip-facets", self.bottom, "-o", "without")
        self.assertTrue(found["machinable"])
        self.assertEqual((found["facets"], found["skipped_facets"]), (12, [0, 1]))

    def test_they_still_hide_others(self):
        # a plate under the cube, left out itself, bars every direction from below
        plate = ["-20 -20 -1", "30 -20 -1", "30 30 -1", "-20 30 -1"]
        lines = cube().splitlines()
        lines[1] = "12 14 0"
        mesh = [*lines[:10], *plate, *lines[10:], "3 8 10 9", "3 8 11 10"]
        part = self.file("\n".join(mesh) + "\n", "plate.off")
        skipped = self.file("12\n13\n", "plate.txt")
        found = self.summary("setup", part, "--machine", "W/caxyBz/T", "--skip-facets", skipped, "-o", "out", status=1)
        self.assertEqual(found["empty_cones"], [0, 1])

    def test_plan_leaves_them_uncut_and_verify_agrees(self):
        top = self.file("2\n3\n", "top.txt")
        facts = self.summary("plan", self.part, *BALL, "--skip-facets", top, "--strategy", "planar", "-o", "sides")
        self.assertEqual(facts["skipped"], 2)
        self.assertEqual(facts["verdict"], "clean")
        # nothing of the top is cut but by the roundings of the sides
        for row in self.points("sides"):
            if row["move"] == "cut":
                x, y = float(row["contact_x_mm"]), float(row["contact_y_mm"])
                self.assertFalse(0.3 < x < 7.7 and 0.3 < y < 7.7, (x, y))
        seen = self.summary("verify", self.folder / "sides/toolpath.csv", "--resolution", "0.4", "-o", "seen")
        self.assertEqual(seen["verdict"], "clean")
        self.assertEqual(seen["skipped"], 2)
        uncut = self.summary("verify", self.folder / "sides/toolpath.csv", "--resolution", "0.4", "--skip-facets", "none",
                             "-o", "whole", status=1)
        self.assertEqual(uncut["verdict"], "uncut")

    def test_verify_finds_gouges_of_them(self):
        path = "move,tip_x_mm,tip_y_mm,tip_z_mm\n" + "".join(
            f"{move},{x},4,{z}\n" for move, x, z in (("rapid", 4, 20), ("plunge", 4, 7.5), ("cut", 5, 7.5)))
        gouge = self.file(path, "gouge.csv")
        seen = self.summary("verify", gouge, "--part", self.part, "--cutter", "ball:4", "--skip-facets",
                            self.file("".join(f"{k}\n" for k in range(12)), "all.txt"), "-o", "out", status=1)
        self.assertEqual(seen["verdict"], "gouged")
        self.assertAlmostEqual(seen["max_gouge_mm"], 0.5, places=2)

    def test_bad_lists_are_refused(self):
        for content, words in (("0\n12\n", (":2:", "\"12\"")), ("0\n0\n", (":2:", "line 1")), ("x\n", (":1:", "\"x\"")),
                               ("# none\n", ("no facet number",))):
            bad = self.file(content, "bad.txt")
            for command in (["setup", self.part, "--machine", "W/xyBz/T"], ["plan", self.part, *BALL]):
                with self.subTest(command=command, content=content):
                    done = endmill(*command, "--skip-facets", bad, "-o", "no", cwd=self.folder)
                    self.assert_refused(done, 3, "bad.txt", *words)
        surface = ROOT / "datasets/surfaces/plane.json"
        done = endmill("plan", surface, *BALL, "--skip-facets", self.bottom, "-o", "no", cwd=self.folder)
        self.assert_refused(done, 2, "--skip-facets", "surface")


class PlanAlongAnAxis(Chain):
    def test_mesh_is_planned_along_an_axis_and_verified(self):
        self.summary("plan", self.part, *BALL, "--axis", "1,0,0", "--skip-facets", self.file("4\n5\n6\n7\n", "s.txt"),
                     "--strategy", "planar", "-o", "out")
        self.assertEqual(self.axes("out"), {(1, 0, 0)})

    def test_setup_gives_axis_and_frame(self):
        # x of the part points up, y along X
        pose = {"configuration": "W/xyBz/T", "tool_axis": [1, 0, 0], "part_to_machine": [[0, 1, 0], [0, 0, 1], [1, 0, 0]],
                "clamp_mm": [0, 0, 0]}
        pose = self.file(pose, "pose.json")
        others = self.file("".join(f"{facet}\n" for facet in range(10)), "others.txt")
        facts = self.summary("plan", self.part, *BALL, "--setup", pose, "--skip-facets", others, "--strategy", "planar",
                             "--direction-deg", "0", "-o", "out")
        self.assertEqual(self.axes("out"), {(1, 0, 0)})
        self.assertEqual(facts["axis"], [1, 0, 0])
        # passes along X of the machine are passes along y of the part
        rows = self.points("out")
        along = [abs(float(b["tip_y_mm"]) - float(a["tip_y_mm"])) for a, b in zip(rows, rows[1:]) if b["move"] == "cut"]
        across = [abs(float(b["tip_z_mm"]) - float(a["tip_z_mm"])) for a, b in zip(rows, rows[1:]) if b["move"] == "cut"]
        self.assertGreater(sum(along), 10 * sum(across))
        missing = self.file({"configuration": "W/xyBz/T"}, "nothing.json")
        done = endmill("plan", self.part, *BALL, "--setup", missing, "-o", "no", cwd=self.folder)
        self.assert_refused(done, 3, "part_to_machine")


if __name__ == "__main__":
    unittest.main()
