# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill verify of paths whose tool axis turns: verdicts against closed forms, files, and refused input."""
import json
import math
import unittest

from program import ROOT, ProgramTest, endmill, plane

COLUMNS = "move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z\n"


def row(move, tip, axis):
    return ",".join([move, *(repr(float(c)) for c in (*tip, *axis))]) + "\n"


def passes(ys, cutter_radius=5, corner_radius=5, leads=(10, 25), dip=None, rapid=None, points=31):
    """Passes along x over the plane of 60 by 30 mm. The lead changes evenly along each pass, in degrees. The middle
    point of the pass at y = dip is 0.05 mm too low, the move to the middle of the pass at y = rapid is a rapid."""
    text = COLUMNS
    for y in ys:
        rows = []
        for k in range(points):
            share = k / (points - 1)
            lead = math.radians(leads[0] + share * (leads[1] - leads[0]))
            axis = (math.sin(lead), 0, math.cos(lead))
            # The contact is (x, y, 0) with the normal +z.
            across = cutter_radius - corner_radius
            tip = (70 * share - 5 - across * math.cos(lead) - corner_radius * math.sin(lead), y,
                   corner_radius + across * math.sin(lead) - corner_radius * math.cos(lead))
            is_middle = k == points // 2
            if is_middle and y == dip:
                tip = (tip[0], y, tip[2] - 0.05)
            rows.append(("rapid" if is_middle and y == rapid else "cut", tip, axis))
        above = [(0, 0, 30)]
        first, last = rows[0], rows[-1]
        text += row("rapid", (first[1][0], y, first[1][2] + above[0][2]), first[2])
        rows[0] = ("plunge", first[1], first[2])
        text += "".join(row(*one) for one in rows)
        text += row("retract", (last[1][0], y, last[1][2] + above[0][2]), last[2])
    return text


class VerifyFiveAxis(ProgramTest):
    def verify(self, content, *options, cutter="ball:10", status=0, out="out"):
        path = self.file(content, "p.csv")
        done = endmill("verify", path, "--part", self.file(plane()), "--cutter", cutter, "--resolution", "0.5",
                       "--scallop", "0.05", "--tolerance", "0.01", *options, "-o", out, "--force", "--json",
                       cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        facts = json.loads(done.stdout)
        self.assertEqual(facts, json.loads((self.folder / out / "summary.json").read_text()))
        return facts

    def test_clean_path_has_the_scallop_of_the_closed_form(self):
        facts = self.verify(passes(range(31)))
        self.assertEqual((facts["verdict"], facts["engine"]), ("clean", "five-axis"))
        exact = 5 - math.sqrt(25 - 0.25)
        self.assertLessEqual(facts["max_scallop_mm"], exact + 1e-6)
        self.assertGreaterEqual(facts["max_scallop_mm"] + facts["scallop_bound_mm"], exact)
        self.assertAlmostEqual(facts["judged_area_mm2"], 1800, delta=1e-3)
        self.assertLess(facts["removed_bound_mm3"], 0.01 * facts["removed_mm3"])
        self.assertEqual((facts["rapid_cuts"], facts["collisions"], facts["part_collisions"]), (0, 0, 0))
        files = {file.name for file in (self.folder / "out").iterdir()}
        self.assertEqual(files, {"summary.json", "removal.csv", "deviation.vtp", "deviation.svg", "histogram.csv"})

    def test_bull_nose_cutter_with_a_constant_lead(self):
        facts = self.verify(passes(range(0, 31, 2), corner_radius=1, leads=(10, 10)), "--engine", "five-axis",
                            cutter="bull:10:1")
        self.assertEqual(facts["verdict"], "clean")
        self.assertLessEqual(facts["max_scallop_mm"], 0.021097259 + 1e-6)
        self.assertGreaterEqual(facts["max_scallop_mm"] + facts["scallop_bound_mm"], 0.021097259)

    def test_gouge_is_found_with_its_place(self):
        facts = self.verify(passes(range(31), dip=10), status=1)
        self.assertEqual(facts["verdict"], "gouged")
        self.assertLessEqual(facts["max_gouge_mm"], 0.05 + 1e-6)
        self.assertGreaterEqual(facts["max_gouge_mm"], 0.04)
        x, y, _ = facts["max_gouge_at"]["point_mm"]
        self.assertTrue(abs(x - 30) < 1 and abs(y - 10) < 0.5, (x, y))
        self.assertAlmostEqual(facts["max_gouge_at"]["point"], 10 * 33 + 16, delta=1)

    def test_skipped_pass_is_found_with_its_place(self):
        facts = self.verify(passes([y for y in range(31) if y != 12]), status=1)
        self.assertEqual(facts["verdict"], "uncut")
        self.assertLessEqual(facts["max_scallop_mm"], 5 - math.sqrt(24) + 1e-6)
        self.assertGreaterEqual(facts["max_scallop_mm"] + facts["scallop_bound_mm"], 5 - math.sqrt(24))
        self.assertAlmostEqual(facts["max_scallop_at"]["point_mm"][1], 12, delta=0.5)

    def test_rapid_through_the_stock_is_found(self):
        facts = self.verify(passes(range(31), rapid=0), status=1)
        self.assertEqual((facts["verdict"], facts["rapid_cuts"], facts["first_of_rapid_cuts"]), ("gouged", 1, 16))
        self.assertGreater(facts["deepest_of_rapid_cuts_mm"], 0.5)

    def test_holder_in_the_part_is_found(self):
        tool = {"format": "endmill-tool/1", "name": "short", "source": "a test", "cutter": "ball:10",
                "holder": [{"diameter_mm": 40, "from_mm": 8, "to_mm": 60}]}
        path = self.file(passes(range(31), leads=(10, 35)), "p.csv")
        done = endmill("verify", path, "--part", self.file(plane()), "--tool", self.file(tool, "tool.json"),
                       "--resolution", "1", "--json", "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        facts = json.loads(done.stdout)
        self.assertEqual(facts["verdict"], "gouged")
        self.assertGreater(facts["part_collisions"], 0)
        # The rim of the holder is lowest at 35 degrees, at the end of the pass.
        self.assertLess(facts["deepest_of_part_collisions_mm"], 20 * math.sin(math.radians(35)))

    def test_without_a_part_only_the_removal_is_known(self):
        path = self.file(passes(range(5)), "p.csv")
        done = endmill("verify", path, "--part", "none", "--cutter", "ball:10", "--resolution", "1", "--json",
                       "--stock", "0,-5,-1,60,9,2", "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        facts = json.loads(done.stdout)
        self.assertEqual((facts["verdict"], facts["max_gouge_mm"]), ("not judged", None))
        self.assertGreater(facts["removed_mm3"], 0)

    def test_both_engines_agree_on_a_fixed_axis(self):
        content = passes(range(31), leads=(0, 0), dip=10)
        three = self.verify(content, "--engine", "three-axis", status=1)
        five = self.verify(content, "--engine", "five-axis", status=1, out="five")
        self.assertEqual(three["verdict"], five["verdict"])
        self.assertEqual((three["engine"], five["engine"]), ("three-axis", "five-axis"))
        for name in ("gouge", "scallop"):
            bound = three[f"{name}_bound_mm"] + five[f"{name}_bound_mm"] + 1e-6
            self.assertAlmostEqual(three[f"max_{name}_mm"], five[f"max_{name}_mm"], delta=bound)
        self.assertAlmostEqual(three["removed_mm3"], five["removed_mm3"],
                               delta=five["removed_bound_mm3"] + five["removed_spread_mm3"] +
                               0.005 * three["removed_mm3"])

    def test_same_bytes_with_any_number_of_threads(self):
        content = passes(range(0, 31, 3), corner_radius=1)
        seen = set()
        for threads in (1, 2, 3, 8):
            self.verify(content, "--threads", threads, cutter="bull:10:1", status=1)
            seen.add(tuple((self.folder / "out" / name).read_bytes()
                           for name in ("summary.json", "removal.csv", "deviation.vtp")))
        self.assertEqual(len(seen), 1)

    def test_options_for_three_axes_are_refused_with_the_reason(self):
        content = passes(range(5))
        path = self.file(content, "p.csv")
        part = ("--part", self.file(plane()), "--cutter", "ball:10")
        for options, words in ((("--engagement",), ("--engagement: the tool turns", "three axes only")),
                               (("--engine", "three-axis"), ("--engine three-axis", "the tool turns",
                                                              "expected five-axis")),
                               (("--write-stock",), ("--write-stock", "the tool turns")),
                               (("--write-mesh",), ("--write-mesh", "the tool turns"))):
            done = endmill("verify", path, *part, *options, cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)

    def test_opposite_axes_are_refused_with_the_point(self):
        content = COLUMNS + row("rapid", (0, 0, 9), (0, 0, 1)) + row("cut", (1, 0, 0), (0, 0, 1)) + \
            row("cut", (2, 0, 0), (0, 0, -1))
        done = endmill("verify", self.file(content, "p.csv"), "--part", self.file(plane()), "--cutter", "ball:10",
                       cwd=self.folder)
        self.assertEqual(done.returncode, 4, done.stderr)
        for word in ("p.csv", "point 2", "opposite", "expected points between"):
            self.assertIn(word, done.stderr)

    def test_too_fine_resolution_is_refused_with_one_that_fits(self):
        done = endmill("verify", self.file(passes(range(3)), "p.csv"), "--part", self.file(plane()), "--cutter",
                       "ball:10", "--resolution", "0.001", "--max-memory", "0.1", cwd=self.folder)
        self.assertEqual(done.returncode, 6, done.stderr)
        self.assertIn("which a resolution of", done.stderr)


if __name__ == "__main__":
    unittest.main()
