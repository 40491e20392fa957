# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill info on surfaces with facts in closed form."""
import math
import unittest

from program import SURFACES, ProgramTest, endmill, plane


def roof(rise):
    """Two plane patches that meet along u = 1 with a ridge."""
    surface = plane(patches_u=2)
    for row in surface["control_points"]:
        for i, point in enumerate(row):
            point[2] = rise * (3 - abs(i - 3)) / 3
    return surface


class Info(ProgramTest):
    def test_plane_has_no_curvature_and_no_cutter_limit(self):
        facts = self.summary("info", self.file(plane()))
        self.assertEqual(facts["size_mm"], [60, 30, 0])
        self.assertAlmostEqual(facts["area_mm2"], 1800, delta=1e-9)
        self.assertEqual(facts["patches"], 1)
        self.assertEqual(facts["continuity"], "G1")
        self.assertEqual(facts["max_curvature_per_mm"], 0)
        self.assertIsNone(facts["max_cutter_radius_mm"])
        self.assertIsNone(facts["max_cutter_radius_at"])

    def test_parabolic_trough_admits_a_ball_of_its_bottom_radius(self):
        # z = y^2 / 40 has the radius of curvature 20 mm at its bottom, y = 0.
        facts = self.summary("info", SURFACES / "parabolic-cylinder.json")
        self.assertAlmostEqual(facts["max_cutter_radius_mm"], 20, delta=1e-7)
        self.assertAlmostEqual(facts["max_cutter_radius_at"]["point_mm"][1], 0, delta=1e-3)
        self.assertAlmostEqual(facts["min_curvature_per_mm"], -0.05, delta=1e-10)

    def test_default_example_has_the_limit_of_three_independent_programs(self):
        facts = self.summary("info", SURFACES / "net_rot24_7D.json")
        self.assertAlmostEqual(facts["max_cutter_radius_mm"], 10.009374, delta=1e-6)
        at = facts["max_cutter_radius_at"]
        mirror = min(abs(at["u"] - 2.1310), abs(3 - at["u"] - 2.1310))
        self.assertAlmostEqual(mirror, 0, delta=1e-4)

    def test_roof_is_g0_with_the_angle_of_its_ridge(self):
        done = endmill("info", self.file(roof(rise=30)), "--require", "g1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--require g1 is not met", done.stderr)
        facts = self.summary("info", self.folder / "surface.json")
        self.assertEqual(facts["continuity"], "G0")
        self.assertAlmostEqual(facts["worst_break_deg"], 2 * math.degrees(math.atan2(30, 30)), delta=1e-9)
        self.assertEqual(facts["worst_break_at"]["u"], 1)
        done = endmill("info", self.folder / "surface.json")
        self.assertIn(", continuity G0, largest break 90 degrees at u = 1, v = 0 (30, 0, 30 mm)\n", done.stdout)
        self.assertEqual(done.stderr, "")  # the report has it

    def test_surface_without_a_break_has_no_place_of_a_break(self):
        for patches in (1, 2):
            path = self.file(plane(patches, patches))
            facts = self.summary("info", path)
            self.assertEqual((facts["worst_break_deg"], facts["worst_break_at"]), (0, None))
            done = endmill("info", path)
            self.assertIn(", continuity G1\n", done.stdout)
            self.assertEqual(len(done.stdout.splitlines()), 5)

    def test_zero_is_printed_without_a_sign(self):
        surface = plane(2, 2)
        for row in surface["control_points"]:
            for point in row:
                point[:] = [0.0 - point[0], 0.0 - point[1], -0.0]
        for axis in ("0,0,1", "0,0,-1"):
            done = endmill("info", self.file(surface), "--axis", axis)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotRegex(done.stdout, r"-0(\s|,)")

    def test_summary_is_written_only_with_output(self):
        path = self.file(plane())
        self.summary("info", path)
        self.assert_nothing_left("surface.json")
        self.summary("info", path, "-o", "facts")
        self.assert_nothing_left("surface.json", "facts")

    def test_unit_inch_is_converted(self):
        surface = plane()
        surface["units"] = "inch"
        self.assertAlmostEqual(self.summary("info", self.file(surface))["size_mm"][0], 60 * 25.4, delta=1e-9)


class InfoPath(ProgramTest):
    """endmill info on tool paths. The content of a file decides that it is one."""

    PROGRAM = ("G21 G90 G94\nT3 M6\nS900 M3\nG0 X0 Y0 Z20\nG1 Z0 F40\nX3 Y4 F100\nG0 Z20\nM2\n")

    def test_program_has_lengths_time_tools_and_extent(self):
        facts = self.summary("info", self.file(self.PROGRAM, "p.ngc"))
        self.assertEqual([facts[key] for key in ("cut_mm", "plunge_mm", "link_mm", "rapid_mm", "tools")],
                         [5, 20, 0, 20, [3]])
        self.assertAlmostEqual(facts["time_min"], 0.5 + 0.05, delta=1e-12)
        self.assertEqual((facts["min_mm"], facts["max_mm"]), ([0, 0, 0], [3, 4, 20]))
        self.assertEqual((facts["min_feed_mm_per_min"], facts["max_feed_mm_per_min"]), (40, 100))
        self.assertEqual(facts["max_spindle_rpm"], 900)
        self.assert_nothing_left("p.ngc")

    def test_content_decides(self):
        table = "tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n3,4,0\n"
        for content, name in ((self.PROGRAM, "program.txt"), (table, "path.dat"), (table, "path.csv"),
                              ("UNITS/MM\nFEDRAT/50,MMPM\nGOTO/0,0,0\nGOTO/3,4,0\nFINI\n", "p.apt")):
            done = endmill("info", self.file(content, name), cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("path        cuts ", done.stdout)
        self.assertIn("time not known (no feeds)", endmill("info", self.folder / "path.csv").stdout)

    def test_wrong_files_and_options_are_refused(self):
        program = self.file(self.PROGRAM, "p.ngc")
        self.assert_refused(endmill("info", program, "--axis", "0,0,1"), 2, "--axis: has no effect with a tool path")
        self.assert_refused(endmill("info", self.file(plane()), "--block-delete"), 2,
                            "--block-delete: has no effect with a part")
        self.assert_refused(endmill("info", self.file("x,y\n1,2\n", "p.csv")), 3, "p.csv:1", "tip_x_mm")
        self.assert_refused(endmill("info", self.file("nothing known\n", "p.txt")), 3, "p.txt")
        self.assert_refused(endmill("info", self.file("", "p.ngc"), "--cutter", "flat:6"), 3, "p.ngc", "empty")


if __name__ == "__main__":
    unittest.main()
