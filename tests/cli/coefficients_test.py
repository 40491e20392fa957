# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill coefficients: test vectors, forces computed by hand, the profile, and refused options."""
import csv
import json
import math
import unittest

from program import ROOT, ProgramTest, endmill

STEEL = ROOT / "datasets/materials/steel.json"


def engagement(mu=0.0, slope=0.0, pick=0.5, depth=1.0):
    return ["--mu-deg", math.degrees(mu), "--lambda-deg", math.degrees(slope), "--pick-feed-ratio", pick,
            "--depth-ratio", depth]


# docs/methods/ball-end-milling.md, section 9: (mu, lambda, R_p, R_l), chip, I1 to I8.
VECTORS = [
    ((0, 0, .5, 2), "paper", [.1235246716864, .1301029447756, .2777270912488, .1945774798852, .1945774798852,
                              .3739361126434, .1583180609274, .3155540626321]),
    ((.3, .2, .4, .6), "paper", [.0316159346849, .02943131640905, .05812337710207, .04448801011338,
                                 .04448801011338, .07589292923858, .03018571943075, .05326083171592]),
    ((-.8, -.6, .6, .35), "paper", [.0150423052654, -.01311755906893, .02556511239622, -.0176396352222,
                                    .1367783847508, .2467053914451, .06124594264783, .1168575680558]),
    ((0, -.3, .5, 1), "exact", [.1012987699252, .07185435904011, .1723655763416, .06161075877685,
                                .1853378741299, .2311426874405, .09318422145028, .1580250864177]),
]


class Coefficients(ProgramTest):
    def test_coefficients_are_those_of_the_test_vectors(self):
        for (mu, slope, pick, depth), chip, expected in VECTORS:
            found = self.summary("coefficients", *engagement(mu, slope, pick, depth), "--chip", chip)
            for k, value in enumerate(expected):
                self.assertAlmostEqual(found[f"I{k + 1}"], value, delta=1e-10)

    def test_slot_edge_and_air_have_their_closed_forms(self):
        slot = self.summary("coefficients", "--mu-deg", 0, "--lambda-deg", 0, "--depth-ratio", 1, "--previous", "none")
        closed = [0, 1 / 4, 0, 1 / math.pi, 1 / math.pi, 1 / 2, 1 / 4, math.pi / 8]
        for k, value in enumerate(closed):
            self.assertAlmostEqual(slot[f"I{k + 1}"], value, delta=1e-11)
        self.assertAlmostEqual(slot["engaged_angle_deg"], 180, delta=1e-9)
        edge = self.summary("coefficients", "--mu-deg", 0, "--lambda-deg", 0, "--depth-ratio", 1, "--previous", "edge")
        self.assertAlmostEqual(edge["I7"], 1 / 8, delta=1e-11)
        for options in (engagement(depth=0), engagement(depth=-2), engagement(pick=0)):
            air = self.summary("coefficients", *options)
            self.assertEqual([air[f"I{k}"] for k in range(1, 9)], [0] * 8)

    def test_engaged_angle_and_peak_factor_are_reported(self):
        found = self.summary("coefficients", *engagement(), "--flutes", 2, "--helix-deg", 30)
        self.assertAlmostEqual(found["engaged_angle_deg"], 60, delta=1e-9)
        self.assertAlmostEqual(found["peak_factor"], 4.35746842, delta=2e-5)
        self.assertNotIn("force_x_n", found)

    def test_forces_follow_from_the_coefficients(self):
        options = [*engagement(.3, .2, .4, .6), "--flutes", 2, "--material", STEEL, "--feed-per-tooth", 0.1,
                   "--cutter", "ball:10"]
        m = json.loads(STEEL.read_text())
        scale = 2 * 5 * m["specific_resistance_n_per_mm2"]
        f, h = 0.1, m["edge_thickness_mm"]
        for milling, s in (("down", -1), ("up", 1)):
            c = self.summary("coefficients", *options, "--milling", milling)
            self.assertAlmostEqual(c["force_x_n"], scale * (f * (s * c["I1"] + m["r1"] * c["I2"])
                                                            + h * (s * c["I3"] + m["r2"] * c["I4"])), delta=1e-9)
            self.assertAlmostEqual(c["force_y_n"], scale * (f * (-s * c["I2"] + m["r1"] * c["I1"])
                                                            + h * (-s * c["I4"] + m["r2"] * c["I3"])), delta=1e-9)
            self.assertAlmostEqual(c["force_z_n"], scale * (f * m["r3"] * c["I5"] + h * m["r4"] * c["I6"]), delta=1e-9)
            self.assertAlmostEqual(c["torque_n_m"], s * scale * 5 / 1000 * (f * c["I7"] + h * c["I8"]), delta=1e-12)

    def test_profile_has_the_mean_forces_on_average(self):
        options = [*engagement(), "--flutes", 2, "--helix-deg", 30, "--material", STEEL, "--feed-per-tooth", 0.1,
                   "--cutter", "ball:10", "--profile", "-o", "out", "--force"]
        profiles = []
        for runout in ([], ["--runout-mm", 0.02, "--runout-deg", 40]):
            facts = self.summary("coefficients", *options, *runout)
            with (self.folder / "out/profile.csv").open(encoding="ascii", newline="") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(list(rows[0]), ["theta_deg", "force_x_n", "force_y_n", "force_z_n", "torque_n_m"])
            self.assertEqual([float(row["theta_deg"]) for row in rows], list(range(360)))
            for key in ("force_x_n", "force_y_n", "force_z_n", "torque_n_m"):
                profiles.append([float(row[key]) for row in rows])
                if not runout:
                    self.assertAlmostEqual(sum(profiles[-1]) / 360, facts[key], delta=2e-3 * abs(facts[key]))
        self.assertNotEqual(profiles[0], profiles[4])
        # Without runout both flutes give the same forces.
        for k in range(180):
            self.assertAlmostEqual(profiles[0][k], profiles[0][k + 180], delta=1e-6)

    def test_files_are_written_only_with_output(self):
        self.assertEqual(endmill("coefficients", *engagement(), cwd=self.folder).returncode, 0)
        self.assert_nothing_left()
        facts = self.summary("coefficients", *engagement(), "-o", "out")
        self.assertEqual(facts, json.loads((self.folder / "out/summary.json").read_text()))

    def test_sense_of_the_helix_gives_a_warning(self):
        def run(*options):
            done = endmill("coefficients", *engagement(), "--flutes", 2, *options, "--json", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            return json.loads(done.stdout)["peak_factor"], done.stderr
        down, said = run("--helix-deg", 30)
        self.assertIn("--helix-deg -30", said)
        self.assertAlmostEqual(down, 4.35746842, delta=1e-5)  # docs/methods/ball-end-milling.md, section 4
        right_hand, said = run("--helix-deg", -30)
        self.assertEqual(said, "")
        self.assertLess(right_hand, 0.9 * down)
        self.assertEqual(run("--helix-deg", 30, "--milling", "up"), (down, ""))
        self.assertGreaterEqual(run("--helix-deg", 80, "--milling", "up")[0], 1)

    def test_required_options_have_no_default(self):
        text = endmill("coefficients", "--help").stdout
        for line in text.splitlines():
            self.assertFalse("(required)" in line and "default" in line, line)

    def refused(self, *options, words=()):
        done = endmill("coefficients", *options, cwd=self.folder)
        self.assert_refused(done, 2, *words)
        self.assert_nothing_left()

    def test_invalid_engagements_are_refused(self):
        self.refused(*engagement(pick=-0.1), words=["--pick-feed-ratio"])
        self.refused("--mu-deg", 90, "--lambda-deg", 0, "--pick-feed-ratio", 1, "--depth-ratio", 1,
                     words=["--mu-deg", '"90"', "between -90 and 90"])
        self.refused("--mu-deg", 0, "--lambda-deg", -90, "--pick-feed-ratio", 1, "--depth-ratio", 1,
                     words=["--lambda-deg", '"-90"'])
        for bad in ("nan", "inf", "-inf", "x"):
            self.refused(*engagement(depth=bad), words=["--depth-ratio"])
            self.refused("--mu-deg", bad, "--lambda-deg", 0, "--pick-feed-ratio", 1, "--depth-ratio", 1)
        self.refused("--mu-deg", 0, "--lambda-deg", 0, "--depth-ratio", 1, words=["--pick-feed-ratio"])
        self.refused(*engagement(), "--accuracy", 0)
        for accuracy in (1, .5, 1e-18):
            self.refused(*engagement(), "--accuracy", accuracy, words=["--accuracy", "from 1e-12 to 0.001"])
        self.refused(*engagement(), "--flutes", 0)
        for helix in (90, 80.1, -81):
            self.refused(*engagement(), "--flutes", 2, "--helix-deg", helix, words=["--helix-deg", str(helix)])
        self.refused(*engagement(), "--cutter", "ball:10", words=["--cutter", "--material"])
        self.refused(*engagement(), "--feed-per-tooth", 0.1, words=["--feed-per-tooth", "--material"])
        self.refused(*engagement(), "--material", STEEL, words=["--material", "--flutes"])
        self.refused(*engagement(), "--flutes", 2, words=["--flutes", "--helix-deg"])
        self.refused(*engagement(), "--helix-deg", 20, words=["--helix-deg", "--flutes"])
        for previous in ("none", "edge"):
            self.refused(*engagement(), "--previous", previous, words=["--pick-feed-ratio"])
        self.refused(*engagement(), "--cutter", "flat:10", words=["flat"])
        self.refused(*engagement(), "--feed-per-tooth", -1)
        self.refused(*engagement(), "--profile", words=["--profile"])
        self.refused(*engagement(), "--runout-mm", 0.1, words=["--profile"])


if __name__ == "__main__":
    unittest.main()
