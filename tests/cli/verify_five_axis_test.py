# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill verify of paths whose tool axis turns: verdicts against closed forms, files, and refused input."""
import json
import math
import shutil
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

    def test_a_posted_program_read_back_has_the_verdict_of_its_path(self):
        machines = ROOT / "datasets/machines"
        for name, content, verdict in (("clean", passes(range(31)), "clean"),
                                       ("dipped", passes(range(31), dip=15), "gouged"),
                                       ("skipped", passes([y for y in range(31) if y != 15]), "uncut")):
            status = 0 if verdict == "clean" else 1
            self.assertEqual(self.verify(content, status=status, out="path")["verdict"], verdict)
            for machine, height in (("ca-table-table", 0), ("ca-head-head", 180)):
                with self.subTest(name=name, machine=machine):
                    made = endmill("post", self.file(content, "p.csv"), "--cutter", "ball:10", "--feed", 900,
                                   "--machine", machines / f"{machine}.json", "--clamp", f"0,0,{height}",
                                   "--tolerance", 0.001, "--decimals", 6, "--angle-decimals", 6, "--force",
                                   "-o", "code", cwd=self.folder)
                    self.assertEqual(made.returncode, 0, made.stderr)
                    # 0.01 of the path and 0.001 of the program
                    done = endmill("verify", "code/p.ngc", "--part", self.file(plane()), "--resolution", 0.5,
                                   "--scallop", 0.05, "--tolerance", 0.011, "--force", "--json", "-o", "back",
                                   cwd=self.folder)
                    self.assertEqual(json.loads(done.stdout)["verdict"], verdict, done.stderr)

    def test_one_block_of_a_turning_table_cuts_a_ring(self):
        # A ball of radius 5 mm, 1 mm deep at 20 mm from the axis of C: its section by the circle. With a quarter turn
        # half a cap at each end.
        section = 25 * math.acos(0.8) - 4 * 3
        cap = math.pi * (5 - 1 / 3)
        # The tip describes the circle of radius 20 mm, and so does the middle of each section.
        for turn, volume in ((360, 2 * math.pi * 20 * section), (90, 0.5 * math.pi * 20 * section + cap)):
            program = self.file("G21 G90 G94 G17\nS1000 M3\nG0 Z10 A0 C0\nG0 X20 Y0\nG1 Z-1 F100\n"
                                f"G93 G1 C{turn} F1\nG94 G0 Z10\nM2\n", f"ring{turn}.ngc")
            done = endmill("verify", program, "--part", "none", "--machine", "W/caxyBz/T", "--frame", "joint",
                           "--cutter", "ball:10", "--stock=-27,-27,-2,27,27,0", "--resolution", 0.2, "--json",
                           "-o", f"ring{turn}", cwd=self.folder)
            facts = json.loads(done.stdout)
            error = facts["removed_bound_mm3"] + facts["removed_spread_mm3"]
            self.assertAlmostEqual(facts["removed_mm3"], volume, delta=error)
            self.assertLess(error, 0.01 * volume)

    def test_rapid_through_the_stock_is_found(self):
        facts = self.verify(passes(range(31), rapid=0), status=1)
        self.assertEqual((facts["verdict"], facts["rapid_cuts"], facts["first_of_rapid_cuts"]), ("gouged", 1, 16))
        self.assertGreater(facts["deepest_of_rapid_cuts_mm"], 0.5)

    def test_holder_in_the_part_is_found(self):
        tool = {"format": "endmill-tool/1", "name": "short", "source": "a test", "cutter": "ball:10",
                "holder": [{"diameter_mm": 40, "from_mm": 8, "to_mm": 60}]}
        path = self.file(passes(range(0, 31, 6), leads=(10, 35)), "p.csv")
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
                                                              "expected five-axis"))):
            done = endmill("verify", path, *part, *options, cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)

    OTHER_TOP = ("--stock", "0,-6,-1,60,36,2")

    def test_second_run_in_the_stock_of_the_first_equals_one_path_of_both(self):
        first, second = passes(range(16)), passes(range(16, 31))
        before = self.verify(first, *self.OTHER_TOP, "--write-stock", "--write-mesh", status=1)
        self.assertEqual(before["verdict"], "uncut")
        files = {file.name for file in (self.folder / "out").iterdir()}
        self.assertEqual(files, {"summary.json", "removal.csv", "deviation.vtp", "deviation.svg", "histogram.csv",
                                 "stock.dexels", "rest.stl"})
        shutil.move(self.folder / "out/stock.dexels", self.folder / "rest.dexels")
        shutil.move(self.folder / "out/rest.stl", self.folder / "rest.stl")
        after = self.verify(second, "--stock", "rest.dexels", "--write-stock", out="after")
        one = self.verify(first + second[len(COLUMNS):], *self.OTHER_TOP, "--write-stock", out="one")
        self.assertEqual(after["verdict"], "clean")
        for key in ("max_gouge_mm", "max_scallop_mm", "gouge_bound_mm", "scallop_bound_mm", "judged_area_mm2", "min_z_mm",
                    "max_z_mm"):
            self.assertEqual(after[key], one[key], key)
        self.assertAlmostEqual(before["removed_mm3"] + after["removed_mm3"], one["removed_mm3"], delta=1e-6)
        self.assertEqual(after["earlier_moves"], before["points"] - 1)
        # The dexels stand at the end of the file, behind the moves of both runs.
        size = (self.folder / "one/stock.dexels").stat().st_size // 2
        self.assertEqual((self.folder / "after/stock.dexels").read_bytes()[-size:],
                         (self.folder / "one/stock.dexels").read_bytes()[-size:])
        # The mesh is closed and has the volume of the rest.
        mesh = self.summary("info", "rest.stl")
        rest = 60 * 42 * 3 - before["removed_mm3"]
        self.assertEqual(mesh["boundary_edges"], 0)
        self.assertAlmostEqual(mesh["volume_mm3"], rest, delta=0.005 * rest)

    def test_heights_and_meshes_become_dexels(self):
        upright = passes(range(16), leads=(0, 0))
        self.verify(upright, *self.OTHER_TOP, "--write-stock", status=1)
        shutil.move(self.folder / "out/stock.vti", self.folder / "rest.vti")
        before = self.verify(upright, *self.OTHER_TOP, "--engine", "five-axis", "--write-mesh", status=1)
        shutil.move(self.folder / "out/rest.stl", self.folder / "rest.stl")
        second = passes(range(16, 31))
        after = self.verify(second, "--stock", "rest.vti")
        self.assertEqual((after["verdict"], after["engine"]), ("clean", "five-axis"))
        self.assertIn("the heights of the stock become dexels: its block is cut again by its", " ".join(after["remarks"]))
        one = self.verify(upright + second[len(COLUMNS):], *self.OTHER_TOP)
        self.assertAlmostEqual(before["removed_mm3"] + after["removed_mm3"], one["removed_mm3"], delta=1e-6)
        self.assertEqual(after["max_scallop_mm"], one["max_scallop_mm"])
        of_mesh = self.verify(second, "--stock", "rest.stl", status=1)
        self.assertIn(of_mesh["verdict"], ("clean", "undecided"))
        self.assertIn("bounds between the centres of the cells", " ".join(of_mesh["remarks"]))
        self.assertAlmostEqual(of_mesh["removed_mm3"], after["removed_mm3"], delta=0.05 * after["removed_mm3"])
        done = endmill("verify", "p.csv", "--part", self.file(plane()), "--cutter", "ball:10", "--stock", "rest.stl",
                       "--write-stock", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("--write-stock: the moves that made the stock rest.stl are not known", done.stderr)

    def test_dexels_select_the_five_axis_engine(self):
        self.verify(passes(range(16)), *self.OTHER_TOP, "--write-stock", status=1)
        shutil.move(self.folder / "out/stock.dexels", self.folder / "rest.dexels")
        facts = self.verify(passes(range(16, 31), leads=(0, 0)), "--stock", "rest.dexels")
        self.assertEqual((facts["verdict"], facts["engine"]), ("clean", "five-axis"))
        done = endmill("verify", "p.csv", "--part", self.file(plane()), "--cutter", "ball:10", "--stock", "rest.dexels",
                       "--engine", "three-axis", cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("--engine three-axis: --stock names dexels; expected five-axis", done.stderr)
        (self.folder / "rest.dexels").write_bytes((self.folder / "rest.dexels").read_bytes()[:-5])
        done = endmill("verify", "p.csv", "--part", self.file(plane()), "--cutter", "ball:10", "--stock", "rest.dexels",
                       cwd=self.folder)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("rest.dexels", done.stderr)

    def test_cutting_length_of_a_tool_file(self):
        tool = {"format": "endmill-tool/1", "cutter": "ball:10", "cutting_length_mm": 6}
        stock = ("--stock", "0,-6,-1,60,36,12", "--part", "none", "--resolution", "1", "--json", "-o", "out", "--force")
        path = self.file(passes(range(5)), "p.csv")
        short = endmill("verify", path, "--tool", self.file(tool, "short.json"), *stock, cwd=self.folder)
        self.assertEqual(short.returncode, 1, short.stderr)
        facts = json.loads(short.stdout)
        self.assertEqual(facts["verdict"], "collides")
        endless = endmill("verify", path, "--cutter", "ball:10", *stock, cwd=self.folder)
        self.assertEqual(endless.returncode, 0, endless.stderr)
        self.assertGreater(json.loads(endless.stdout)["removed_mm3"], 1.2 * facts["removed_mm3"])
        tool["cutting_length_mm"] = 4.9
        done = endmill("verify", path, "--tool", self.file(tool, "bad.json"), *stock, cwd=self.folder)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("cutting_length_mm: 4.9; expected at least the corner radius of the cutter, 5 mm", done.stderr)
        # Three axes say that they do not use it.
        tool["cutting_length_mm"] = 6
        upright = self.file(passes(range(5), leads=(0, 0)), "u.csv")
        done = endmill("verify", upright, "--tool", self.file(tool, "short.json"), *stock, cwd=self.folder)
        self.assertIn("cutting_length_mm is not used with three axes", done.stderr)

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
