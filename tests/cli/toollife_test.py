# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill toollife: the printed example, and exit codes."""
import json
import math
import unittest

from program import ROOT, ProgramTest, endmill

SPEEDS = ROOT / "datasets/materials/steel-cutting-speeds.csv"
COSTS = ("--tool-change-min", 40, "--tool-cost", 20000, "--machine-cost-per-min", 200)
HEADER = "phi_over_pi,v_m_per_min\n"


class ToolLife(ProgramTest):
    def refused(self, content, status, *words):
        """Asserts that the contents of a file are refused with their place."""
        path = self.file(content, "speeds.csv")
        self.assert_refused(endmill("toollife", path, *COSTS, cwd=self.folder), status, *words)

    def test_printed_example_is_reproduced(self):
        value = self.summary("toollife", SPEEDS, *COSTS)
        self.assertEqual(list(value), ["alpha", "cb", "t0_min", "v1_m_per_min"])
        self.assertAlmostEqual(value["alpha"], 0.368012948365, delta=1e-10)
        self.assertAlmostEqual(value["t0_min"], 240.421397, delta=1e-6)
        self.assertAlmostEqual(value["cb"], 213.808861, delta=1e-6)
        self.assertAlmostEqual(value["v1_m_per_min"], 28.4313029690, delta=1e-9)
        for key, printed in (("alpha", 0.3680141), ("t0_min", 240.4202), ("cb", 213.8094)):
            self.assertLess(abs(value[key] / printed - 1), 1e-5)

    def test_printed_exponent_is_accepted(self):
        value = self.summary("toollife", SPEEDS, *COSTS, "--alpha", 0.3680141)
        self.assertEqual(value["alpha"], 0.3680141)
        self.assertAlmostEqual(value["t0_min"], 240.420207, delta=1e-6)
        self.assertAlmostEqual(value["cb"], 213.809481, delta=1e-6)

    def test_two_points_are_fitted_exactly(self):
        path = self.file(HEADER + f"0.25,{10 * 0.25**-0.3!r}\n1,10\n", "speeds.csv")
        value = self.summary("toollife", path, "--tool-change-min", 0, "--tool-cost", 10,
                             "--machine-cost-per-min", 1)
        self.assertAlmostEqual(value["alpha"], 0.3, delta=1e-14)
        self.assertAlmostEqual(value["t0_min"], 10 * (1 / 0.3 - 1), delta=1e-12)
        self.assertAlmostEqual(value["cb"], 10 * math.pow(value["t0_min"], 0.3), delta=1e-12)

    def test_answer_is_printed_and_written(self):
        done = endmill("toollife", SPEEDS, *COSTS, "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("alpha = 0.368", done.stdout)
        summary = json.loads((self.folder / "out/summary.json").read_text())
        self.assertEqual(summary, self.summary("toollife", SPEEDS, *COSTS))

    def test_help_has_an_example(self):
        done = endmill("toollife", "--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("Example:", done.stdout)

    def test_files_that_determine_no_line_are_refused(self):
        self.refused(HEADER + "0.1,64\n", 3, "speeds.csv:2: one row", "different phi_over_pi")
        self.refused(HEADER + "0.1,64\n0.1,60\n", 3, "speeds.csv:3:", "same in all rows")
        self.refused(HEADER, 3, "no row")
        self.refused(HEADER + "0.1,64\n1.2,60\n", 3, 'speeds.csv:3: phi_over_pi is "1.2"')
        self.refused(HEADER + "0,64\n0.5,60\n", 3, 'speeds.csv:2: phi_over_pi is "0"')
        self.refused(HEADER + "0.1,-64\n0.5,60\n", 3, 'speeds.csv:2: v_m_per_min is "-64"')
        self.refused(HEADER + "0.1,nan\n0.5,60\n", 3, 'speeds.csv:2: v_m_per_min is "nan"')
        self.refused(HEADER + "0.1\n0.5,60\n", 3, "speeds.csv:2: row has 1 cell")
        self.refused("phi,v_m_per_min\n0.1,64\n", 3, 'unknown column "phi"')
        self.refused("\n", 3, "empty")
        self.assert_refused(endmill("toollife", "none.csv", *COSTS), 3, "none.csv")

    def test_speeds_that_do_not_fall_are_refused(self):
        self.refused(HEADER + "0.1,50\n0.5,60\n", 4, "speeds.csv: the cutting speed must fall")

    def test_arguments_outside_their_domain_are_refused(self):
        for position, name in ((1, "--tool-change-min"), (3, "--tool-cost"),
                               (5, "--machine-cost-per-min")):
            costs = list(COSTS)
            costs[position] = -1
            self.assert_refused(endmill("toollife", SPEEDS, *costs), 2, name)
            costs[position] = "nan"
            self.assert_refused(endmill("toollife", SPEEDS, *costs), 2, name)
        for alpha in (0, -0.3, "inf"):
            self.assert_refused(endmill("toollife", SPEEDS, *COSTS, "--alpha", alpha), 2, "--alpha")
        self.assert_refused(endmill("toollife", SPEEDS, *COSTS, "--alpha", 1.5), 2, "--alpha", "1.5",
                            "between 0 and 1")
        self.assert_refused(endmill("toollife", SPEEDS), 2, "--tool-change-min is required")
        free = ("--tool-change-min", 0, "--tool-cost", 0, "--machine-cost-per-min", 1)
        self.assert_refused(endmill("toollife", SPEEDS, *free), 2, "costs nothing")


class Datasets(ProgramTest):
    def test_every_material_machine_and_tool_is_described(self):
        for folder in ("materials", "machines", "tools"):
            readme = (ROOT / "datasets" / folder / "README.md").read_text(encoding="utf-8")
            for path in (ROOT / "datasets" / folder).iterdir():
                if path.name != "README.md":
                    self.assertIn(f"`{path.name}`", readme)


if __name__ == "__main__":
    unittest.main()
