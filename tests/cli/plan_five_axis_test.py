#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill plan --axis-mode: paths with a leaning tool, the chain to verify and post, and refused options."""
import csv
import math
import unittest

from program import ROOT, ProgramTest, endmill, plane

MACHINES = ROOT / "datasets/machines"
TOOL = ROOT / "datasets/tools/ball-10-shrink-fit.json"
LIMITS = ["--scallop", "0.1", "--inner-tolerance", "0.02"]


def cap(radius=40, half_width=12, steps=9):
    """A height grid over a spherical cap, convex."""
    at = [half_width * (2 * k / (steps - 1) - 1) for k in range(steps)]
    z = [[math.sqrt(radius ** 2 - x * x - y * y) - radius for x in at] for y in at]
    return {"format": "endmill-surface/1", "name": "cap", "source": "a test", "type": "height-grid", "x": at, "y": at,
            "z": z}


class PlanFiveAxis(ProgramTest):
    def plan(self, part, cutter, *options):
        return self.summary("plan", part, "--cutter", cutter, *LIMITS, *options, "-o", "out", "--force")

    def test_lead_on_a_plane_is_that_of_every_row(self):
        facts = self.plan(self.file(plane(size=(30, 20))), "flat:10", "--axis-mode", "fixed", "--lead-deg", "10")
        self.assertEqual((facts["verdict"], facts["lead_range_deg"]), ("clean", [10, 10]))
        # the closed form of the strip of an inclined circle
        strip = 2 * math.sqrt(2 * 0.1 * 5 / math.sin(math.radians(10)))
        self.assertAlmostEqual(facts["narrowest_strip_mm"], strip, places=9)
        with (self.folder / "out/toolpath.csv").open() as file:
            for row in csv.DictReader(file):
                self.assertAlmostEqual(float(row["axis_z"]), math.cos(math.radians(10)), places=12)

    def test_wider_strips_make_a_shorter_path_than_a_ball(self):
        part = self.file(cap())
        ball = self.plan(part, "ball:10", "--axis-mode", "lead")
        bull = self.plan(part, "bull:10:1", "--axis-mode", "lead", "--lead-deg", "3")
        self.assertEqual((ball["verdict"], bull["verdict"]), ("clean", "clean"))
        self.assertLess(bull["cut_contact_mm"], 0.8 * ball["cut_contact_mm"])

    def test_chain_ends_clean_and_as_code_for_two_kinds_of_machines(self):
        self.plan(self.file(cap()), "ball:10", "--axis-mode", "lead", "--lead-deg", "10")
        path = self.folder / "out/toolpath.csv"
        seen = self.summary("verify", path, "--resolution", "0.5", "-o", "seen")
        self.assertEqual((seen["verdict"], seen["engine"]), ("clean", "five-axis"))
        for machine, clamp in (("ca-table-table", "0,0,0"), ("cb-head-head", "0,0,100")):
            facts = self.summary("post", path, "--machine", MACHINES / f"{machine}.json", "--tool", TOOL, "--feed", "600",
                                 "--clamp", clamp, "-o", machine)
            self.assertLessEqual(facts["max_tip_error_mm"], 0.01)
            self.assertTrue(any((self.folder / machine).glob("*.ngc")))

    def test_field_turns_less_than_lead_and_stays_within_its_ranges(self):
        part = self.file(cap(radius=40, half_width=15))
        lead = self.plan(part, "ball:10", "--axis-mode", "lead", "--direction", "u")
        field = self.plan(part, "ball:10", "--axis-mode", "field", "--direction", "u", "--lead-range=-20:20",
                          "--tilt-range=-25:25")
        self.assertEqual((lead["verdict"], field["verdict"]), ("clean", "clean"))
        self.assertLess(field["rotary_travel_deg"], 0.5 * lead["rotary_travel_deg"])
        self.assertGreaterEqual(field["lead_range_deg"][0], -20 - 1e-6)
        self.assertLessEqual(field["tilt_range_deg"][1], 25 + 1e-6)
        self.assertGreaterEqual(field["min_gap_mm"], -0.02)
        self.assertIsNone(lead["min_gap_mm"])
        self.assertEqual(field["strip_mm"][0], field["narrowest_strip_mm"])

    def test_field_takes_directions_that_the_machine_reaches(self):
        part = self.file(cap(radius=40, half_width=15))
        machine = MACHINES / "ca-table-table.json"
        facts = self.plan(part, "ball:10", "--axis-mode", "field", "--direction", "u", "--machine", machine, "--tool", TOOL)
        self.assertEqual(facts["verdict"], "clean")
        done = endmill("plan", part, "--cutter", "ball:10", "--axis-mode", "field", "--machine", "W/xyzB/T", "--lead-range",
                       "5:20", *LIMITS, "-o", "no", cwd=self.folder)
        self.assert_refused(done, 4, "no tool axis is allowed at contact 0", "the range of the machine")
        self.assertFalse((self.folder / "no").exists())

    def test_field_options_are_refused_by_name(self):
        part = self.file(plane())
        field = ["--axis-mode", "field"]
        for options, words in (
                ([*field, "--lead-range", "10:5"], ("--lead-range", "expected A:B with A at most B")),
                ([*field, "--tilt-range", "5"], ("--tilt-range", "expected A:B")),
                ([*field, "--lead-range=-89:5"], ("--lead-range", "-89")),
                ([*field, "--tilt-range", "0:89"], ("--tilt-range", "89")),
                ([*field, "--lead-deg", "89"], ("--lead-deg", "89")),
                ([*field, "--tool", TOOL], ("--tool", "ball:10", "ball:12")),
                ([*field, "--clamp", "0,0,0"], ("--clamp", "--machine")),
                (["--axis-mode", "lead", "--lead-range", "0:5"], ("--lead-range", "--axis-mode field")),
                (["--axis-mode", "fixed", "--machine", "W/caxyBz/T"], ("--machine", "--axis-mode field")),
                (["--tool", TOOL], ("--tool", "--axis-mode field"))):
            with self.subTest(options=options):
                done = endmill("plan", part, "--cutter", "ball:12", *options, "-o", "no", cwd=self.folder)
                self.assert_refused(done, 2, *words)

    def test_cutter_that_does_not_fit_is_refused_with_the_place(self):
        bowl = cap(radius=20, half_width=10)
        bowl["z"] = [[-z for z in row] for row in bowl["z"]]
        done = endmill("plan", self.file(bowl), "--cutter", "flat:10", "--axis-mode", "fixed", "--lead-deg", "1", "-o",
                       "no", cwd=self.folder)
        self.assert_refused(done, 4, "does not fit at u = ", "the least lead there is")
        self.assertFalse((self.folder / "no").exists())

    def test_options_of_three_axes_are_refused_by_name(self):
        part = self.file(plane())
        for options, word in ((["--strategy", "best"], "--strategy"), (["--bound", "none"], "--bound"),
                              (["--mode", "paper"], "--mode"), (["--axis", "0,0,1"], "--axis"),
                              (["--direction", "best"], "--direction"), (["--inner-tolerance", "0"], "--inner-tolerance"),
                              (["--lead-deg", "90"], "--lead-deg")):
            with self.subTest(word=word):
                done = endmill("plan", part, "--cutter", "ball:10", "--axis-mode", "lead", *options, "-o", "no",
                               cwd=self.folder)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(word, done.stderr)
        done = endmill("plan", part, "--lead-deg", "10", "-o", "no", cwd=self.folder)
        self.assert_refused(done, 2, "--lead-deg", "--axis-mode")
        done = endmill("plan", part, "--axis-mode", "lead", "-o", "no", cwd=self.folder)
        self.assert_refused(done, 2, "--cutter")

    def dome_mesh(self, cells=60, size=24, radius=40):
        """A cap of a sphere as an open mesh."""
        points, triangles = [], []
        for j in range(cells + 1):
            for i in range(cells + 1):
                x, y = size * (i / cells - 0.5), size * (j / cells - 0.5)
                points.append(f"{x} {y} {math.sqrt(radius ** 2 - x * x - y * y) - radius}")
        for j in range(cells):
            for i in range(cells):
                a = j * (cells + 1) + i
                triangles += [f"3 {a} {a + 1} {a + cells + 2}", f"3 {a} {a + cells + 2} {a + cells + 1}"]
        return self.file("\n".join(["OFF", f"{len(points)} {len(triangles)} 0", *points, *triangles]) + "\n", "cap.off")

    def test_mesh_is_cut_clean_with_leads_and_fields(self):
        part = self.dome_mesh()
        lead = self.plan(part, "ball:10", "--axis-mode", "lead")
        self.assertEqual((lead["verdict"], lead["strategy"]), ("clean", "iso-scallop"))
        field = self.plan(part, "ball:10", "--axis-mode", "field")
        self.assertEqual(field["verdict"], "clean")
        self.assertLess(field["rotary_travel_deg"], 0.5 * lead["rotary_travel_deg"])
        seen = self.summary("verify", self.folder / "out/toolpath.csv", "--resolution", "0.5", "-o", "seen")
        self.assertEqual((seen["verdict"], seen["engine"]), ("clean", "five-axis"))

    def test_mesh_with_a_bull_nose_cutter_needs_fewer_passes(self):
        part = self.dome_mesh()
        planar = ["--axis-mode", "lead", "--lead-deg", "5", "--direction-deg", "0"]
        ball = self.plan(part, "ball:10", *planar)
        bull = self.plan(part, "bull:10:1", *planar)
        self.assertEqual((bull["verdict"], bull["strategy"]), ("clean", "planar"))
        self.assertLess(bull["passes"], 0.8 * ball["passes"])

    def test_options_of_surfaces_and_meshes_are_refused_by_name(self):
        mesh = self.file("OFF\n3 1 0\n0 0 0\n9 0 0\n0 9 0\n3 0 1 2\n", "m.off")
        facets = self.file("0\n", "facets.txt")
        for part, options, words in (
                (mesh, ["--direction", "u"], ("--direction", "--direction-deg")),
                (mesh, ["--strategy", "best"], ("--strategy best", "planar, iso-scallop or field")),
                (mesh, ["--strategy", "field", "--direction-deg", "0"], ("--direction-deg", "--strategy planar")),
                (mesh, ["--require", "g1"], ("--require g1", "surface file")),
                (self.file(plane()), ["--strategy", "planar"], ("--strategy", "a mesh")),
                (self.file(plane()), ["--skip-facets", facets], ("--skip-facets", "expected a mesh"))):
            with self.subTest(options=options):
                done = endmill("plan", part, "--cutter", "ball:4", "--axis-mode", "lead", *options, "-o", "no",
                               cwd=self.folder)
                self.assert_refused(done, 2, *words)

    def test_mesh_with_a_triangle_turned_over_is_mended_with_a_warning(self):
        mesh = self.file("OFF\n4 2 0\n0 0 0\n9 0 0\n0 9 0\n9 9 0\n3 0 1 2\n3 1 2 3\n", "m.off")
        done = endmill("plan", mesh, "--cutter", "ball:4", "--axis-mode", "lead", *LIMITS, "-o", "no", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 triangle was turned over", done.stderr)


if __name__ == "__main__":
    unittest.main()
