# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill eval: values computed with 50 digits, and exit codes."""
import math
import unittest

from program import ProgramTest, endmill


class Eval(ProgramTest):
    def test_plane_interval_is_the_chord_of_the_ball(self):
        value = self.summary("eval", "path-interval", "--radius", 5, "--curvature", 0, "--scallop", 1)
        self.assertEqual(value, {"chord_mm": 6, "projected_mm": 6, "arc_mm": 6,
                                 "half_angle_rad": 0, "status": "ok"})

    def test_interval_on_a_concave_circle(self):
        value = self.summary("eval", "path-interval", "--radius", 5, "--curvature=-0.1", "--scallop", 0.5)
        self.assertAlmostEqual(value["chord_mm"], 6.24499799839840, delta=1e-13)
        self.assertAlmostEqual(value["projected_mm"], 5.93274809847848, delta=1e-13)
        self.assertAlmostEqual(value["half_angle_rad"], 0.317560429291521, delta=1e-14)

    def test_interval_beyond_45_degrees_is_clamped(self):
        value = self.summary("eval", "path-interval", "--radius", 10, "--curvature", 1, "--scallop", 0.5)
        self.assertEqual(value["status"], "clamped")
        self.assertAlmostEqual(value["chord_mm"], math.sqrt(2), delta=1e-14)
        self.assertAlmostEqual(value["half_angle_rad"], math.pi / 4, delta=1e-15)

    def test_interval_inside_a_tight_concavity_is_unlimited(self):
        value = self.summary("eval", "path-interval", "--radius", 5, "--curvature", -1 / 5.2,
                             "--scallop", 0.5)
        self.assertEqual(value, {"chord_mm": None, "projected_mm": None, "arc_mm": None,
                                 "half_angle_rad": None, "status": "unlimited"})

    def test_ball_that_does_not_fit_exits_4_with_the_limit(self):
        for rho in (-5, -4):
            done = endmill("eval", "path-interval", "--radius", 5, "--curvature", 1 / rho,
                           "--scallop", 0.5)
            self.assert_refused(done, 4, f"radius 5 mm does not fit a concavity of radius {-rho} mm")

    def test_step_on_a_straight_line_is_unlimited(self):
        value = self.summary("eval", "step-length", "--curvature", 0, "--chord-tolerance", 0.5)
        self.assertEqual(value, {"chord_mm": None, "projected_mm": None,
                                 "half_angle_rad": None, "status": "unlimited"})

    def test_text_has_units_and_no_unknown_numbers(self):
        straight = ("eval", "step-length", "--chord-tolerance", 0.5, "--curvature")
        self.assertEqual(endmill(*straight, 0).stdout, "status = unlimited\n")
        self.assertEqual(endmill(*straight, 0.01).stdout,
                         "chord = 19.975 mm\nprojected = 19.875 mm\nhalf angle = 0.10004 rad\nstatus = ok\n")

    def test_step_depends_on_the_magnitude_of_curvature(self):
        for curvature in (0.01, -0.01):
            value = self.summary("eval", "step-length", "--curvature", curvature,
                                 "--chord-tolerance", 0.5)
            self.assertAlmostEqual(value["chord_mm"], 19.9749843554382, delta=1e-12)
            self.assertAlmostEqual(value["projected_mm"], 19.8751094336610, delta=1e-12)

    def test_scallop_height_is_the_inverse_of_path_interval(self):
        value = self.summary("eval", "scallop-height", "--radius", 7.5, "--curvature", 0.02,
                             "--interval", 5)
        self.assertAlmostEqual(value["scallop_mm"], 0.501004520636059, delta=1e-14)

    def test_arguments_outside_their_domain_exit_2(self):
        positive, ball = "; expected a number above 0", ("path-interval", "--radius", "5")
        for arguments, word in (
                (("path-interval", "--radius", "0"), f'--radius: found "0"{positive}'),
                (("path-interval", "--radius", "inf"), f'--radius: found "inf"{positive}'),
                ((*ball, "--curvature", "nan"), '--curvature: found "nan"; expected a number'),
                ((*ball, "--curvature", "0", "--scallop", "-1"), f'--scallop: found "-1"{positive}'),
                ((*ball, "--curvature", "0", "--scallop", "10"), "need 0 < scallop height < 2 cutter radii"),
                (("step-length", "--curvature", "1", "--chord-tolerance", "0"),
                 f'--chord-tolerance: found "0"{positive}'),
                (("scallop-height", "--interval", "0"), f'--interval: found "0"{positive}'),
                (ball, "--curvature is required"),
                (("no-such-formula",), '"no-such-formula", which endmill eval does not know')):
            self.assert_refused(endmill("eval", *arguments), 2, word)

    def test_interval_too_wide_for_the_balls_exits_4(self):
        done = endmill("eval", "scallop-height", "--radius", 5, "--curvature", 0, "--interval", 11)
        self.assert_refused(done, 4, "further apart than 10 mm")

    def test_eval_alone_lists_the_formulas(self):
        names = [formula["name"] for formula in self.summary("eval")["formulas"]]
        self.assertIn("path-interval", names)
        for name in names:
            done = endmill("eval", name, "--help")
            self.assertIn("Example:", done.stdout)
            self.assertEqual(done.returncode, 0)


if __name__ == "__main__":
    unittest.main()
