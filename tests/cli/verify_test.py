# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill verify: verdicts and volumes on paths with closed forms, the files, and refused input."""
import csv
import hashlib
import json
import math
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree as ElementTree

from program import ENDMILL, ROOT, SURFACES, ProgramTest, endmill, plane

PLAN = ["--cutter", "ball:10", "--chord-tolerance", "0.05", "--scallop", "0.2", "--direction", "u"]
HOLDER = ROOT / "datasets/tools/ball-10-shrink-fit.json"
COLUMNS = "tip_x_mm,tip_y_mm,tip_z_mm\n"
# Cross section in mm2 of the cut of a ball of radius 5 mm, 1 mm deep.
SECTION = 25 * math.acos(1 - 1 / 5) - 4 * math.sqrt(9)
THROUGH = COLUMNS + "-30,0,-1\n30,0,-1\n"
BLOCK = ("--stock", "-10,-10,-10,10,10,0")


def scallop(pitch):
    """Scallop height in mm of balls of radius 5 mm between level passes."""
    return 5 - math.sqrt(25 - pitch * pitch / 4)


def passes(ys, dip=None):
    """Level passes along x over the plane of 60 by 30 mm. The pass at y = dip is 0.05 mm too deep for 20 mm."""
    lines = []
    for number, y in enumerate(ys):
        tips = [(0, 0), (20, 0), (20, -0.05), (40, -0.05), (40, 0), (60, 0)] if y == dip else [(0, 0), (60, 0)]
        lines += [f"{x},{y},{z}\n" for x, z in (tips if number % 2 == 0 else tips[::-1])]
    return COLUMNS + "".join(lines)


class VerifyTest(ProgramTest):
    def verify(self, path, *options, status=0, out="out"):
        """Runs verify and returns the summary. Asserts the exit status."""
        done = endmill("verify", path, *options, "-o", out, "--force", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        facts = json.loads(done.stdout)
        self.assertEqual(facts, json.loads((self.folder / out / "summary.json").read_text()))
        self.assertEqual(status == 0, facts["verdict"] in ("clean", "not judged"))
        return facts

    def planned(self, *options, part=None, out="plan"):
        mode = () if "--mode" in options else ("--mode", "paper")
        done = endmill("plan", part or self.file(plane()), *PLAN, *mode, *options, "-o", out, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / out / "toolpath.csv"

    def rows(self, name):
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))


def without_history(stock):
    """A stock.vti without the history of its moves, as other programs may write it."""
    end = stock.index(b"\n_") + 2
    head = re.sub(rb'   <DataArray [^>]*Name="(block_mm|run_cutters_mm|run_tips|tips_mm)"[^>]*/>\n', b"", stock[:end])
    columns, rows = (int(word) for word in re.search(rb'WholeExtent="0 (\d+) 0 (\d+) ', head).groups())
    return head + stock[end:end + 24 + 8 * columns * rows] + b"\n </AppendedData>\n</VTKFile>\n"


class Verdicts(VerifyTest):
    def judged(self, tips, *options, status=0):
        self.file(plane())
        return self.verify(self.file(tips, "p.csv"), "--part", "surface.json", "--cutter", "ball:10", "--scallop",
                           "0.05", *options, status=status)

    def test_part_cutter_and_limits_come_from_the_plan(self):
        facts = self.verify(self.planned("--mode", "verified"), "--resolution", "1")
        self.assertEqual((facts["name"], facts["cutter"]), ("plane", "ball:10"))
        self.assertEqual(facts["part"], str(self.folder / "surface.json"))
        self.assertEqual((facts["tolerance_mm"], facts["scallop_limit_mm"]), (0.05, 0.25))
        self.assertEqual((facts["max_gouge_mm"], facts["uncut_area_mm2"]), (0, 0))
        passes_at = sorted({float(row["tip_y_mm"]) for row in self.rows("plan/toolpath.csv")})
        widest = max(b - a for a, b in zip(passes_at, passes_at[1:]))
        self.assertLessEqual(facts["max_scallop_mm"], scallop(widest) + 1e-12)
        self.assertGreaterEqual(facts["max_scallop_mm"] + facts["scallop_bound_mm"], scallop(widest) - 1e-12)
        self.assertAlmostEqual(facts["judged_area_mm2"], 1800, delta=1e-6)

    def test_options_override_the_plan(self):
        facts = self.verify(self.planned(), "--resolution", "1", "--tolerance", "0.02", "--scallop", "0.1", status=1)
        self.assertEqual((facts["verdict"], facts["tolerance_mm"], facts["scallop_limit_mm"]), ("uncut", 0.02, 0.1))

    def test_one_sided_tolerances_are_the_limits(self):
        self.summary("plan", self.file(plane()), "--cutter", "ball:10", "--scallop", "0.2", "--direction", "u",
                     "--inner-tolerance", "0.03", "--outer-tolerance", "0.01", "-o", "plan")
        path = self.folder / "plan/toolpath.csv"
        facts = self.verify(path, "--resolution", "1")
        self.assertAlmostEqual(facts["tolerance_mm"], 0.03, delta=1e-15)
        self.assertAlmostEqual(facts["scallop_limit_mm"], 0.21, delta=1e-15)

    def test_gouge_is_found_with_its_place(self):
        facts = self.judged(passes(range(31), dip=10), "--resolution", "0.25", status=1)
        self.assertEqual(facts["verdict"], "gouged")
        self.assertLessEqual(facts["max_gouge_mm"], 0.05 + 1e-12)
        self.assertGreaterEqual(facts["max_gouge_mm"] + facts["gouge_bound_mm"], 0.05 - 1e-12)
        x, y, z = facts["max_gouge_at"]["point_mm"]
        self.assertTrue(19.5 <= x <= 40.5 and abs(y - 10) <= 0.25 and abs(z) < 1e-12, (x, y, z))
        self.assertTrue(22 <= facts["max_gouge_at"]["point"] <= 24, facts["max_gouge_at"])
        width = 2 * math.sqrt(25 - (5 - 0.05 + 0.01) ** 2)  # of the region where the dip exceeds the tolerance
        self.assertAlmostEqual(facts["gouge_area_mm2"], 20 * width, delta=0.25 * 20 + 2)
        done = endmill("verify", "p.csv", "--part", "surface.json", "--cutter", "ball:10", "--resolution", "1", "-o",
                       "said", cwd=self.folder)
        self.assertRegex(done.stdout, r"p: gouged\n  gouge       0\.04\d+, tolerance 0\.01 \+ 0\.001 mm at x .*, point 2[234];")

    def test_report_shows_on_which_side_of_its_limit_a_gouge_lies(self):
        facts = self.judged(passes(range(31), dip=10), "--resolution", "1", status=1)
        for share, is_beyond in ((0.9999, True), (1.0001, False)):
            limit = share * facts["max_gouge_mm"]
            done = endmill("verify", "p.csv", "--part", "surface.json", "--cutter", "ball:10", "--resolution", "1",
                           "--tolerance", limit, "--max-refine", "0", "-o", "said", "--force", cwd=self.folder)
            found = json.loads((self.folder / "said/summary.json").read_text())["max_gouge_mm"]
            self.assertEqual(found > limit, is_beyond)
            said = re.search(r"gouge +(\S+), tolerance (\S+) \+ 0\.001 mm", done.stdout)
            self.assertLessEqual(float(said[2]), limit)
            self.assertEqual(float(said[1]) > limit, is_beyond, said)

    def rest_of(self, tips, *options, status=0):
        """Runs verify and keeps its stock.vti as rest.vti."""
        facts = self.judged(tips, "--resolution", "0.5", "--write-stock", *options, status=status)
        shutil.move(self.folder / "out/stock.vti", self.folder / "rest.vti")
        return facts

    def test_gouge_of_an_earlier_run_is_found_with_its_place(self):
        self.rest_of(passes(range(31), dip=10), status=1)
        facts = self.judged(passes(range(31)), "--stock", "rest.vti", status=1)
        self.assertEqual((facts["verdict"], facts["earlier_moves"]), ("gouged", 66))
        self.assertEqual((facts["earlier_gouge_mm"], facts["earlier_gouge_bound_mm"]), (None, None))
        self.assertLessEqual(facts["max_gouge_mm"], 0.05 + 1e-12)
        self.assertGreaterEqual(facts["max_gouge_mm"] + facts["gouge_bound_mm"], 0.05 - 1e-12)
        place = facts["max_gouge_at"]
        self.assertEqual((place["point"], place["earlier_run"]), (None, True))
        self.assertTrue(19.5 <= place["point_mm"][0] <= 40.5, place)
        done = endmill("verify", "p.csv", "--part", "surface.json", "--cutter", "ball:10", "--stock", "rest.vti", "-o",
                       "said", cwd=self.folder)
        self.assertRegex(done.stdout, r"p: gouged\n  gouge       0\.0[45]\d*, tolerance 0\.01 \+ 0\.001 mm at x .*, by an earlier run;")

    def test_two_halves_of_a_path_are_clean_together(self):
        first = self.rest_of(passes(range(16)), status=1)
        self.assertEqual(first["verdict"], "uncut")
        self.assertIsNone(first["earlier_moves"])
        facts = self.judged(passes(range(15, 31)), "--stock", "rest.vti", "--resolution", "0.5", "--write-stock")
        self.assertEqual((facts["verdict"], facts["earlier_moves"]), ("clean", 32))
        # The remaining stock of the second run has the history of both.
        shutil.move(self.folder / "out/stock.vti", self.folder / "rest.vti")
        facts = self.judged(passes([15]), "--stock", "rest.vti")
        self.assertEqual((facts["verdict"], facts["earlier_moves"], facts["removed_mm3"]), ("clean", 64, 0))

    def test_stock_without_history_bounds_a_gouge(self):
        for dip in (None, 10):
            self.rest_of(passes(range(31), dip=dip), status=0 if dip is None else 1)
            old = without_history((self.folder / "rest.vti").read_bytes())
            (self.folder / "old.vti").write_bytes(old)
            facts = self.judged(passes(range(31)), "--stock", "old.vti", "--resolution", "0.5", status=1 if dip else 0)
            # The heights are uncertain by half a pitch beside the lowest place of the dip.
            self.assertIn(facts["verdict"], ("gouged", "undecided") if dip else ("clean",))
            self.assertIsNone(facts["earlier_moves"])
            truth = 0.05 if dip else 0
            self.assertLessEqual(facts["earlier_gouge_mm"], truth + 1e-12)
            self.assertGreaterEqual(facts["earlier_gouge_mm"] + facts["earlier_gouge_bound_mm"], truth - 1e-12)
        (self.folder / "old.vti").write_bytes(old[:-40])
        self.assert_refused(endmill("verify", "p.csv", "--part", "surface.json", "--cutter", "ball:10", "--stock",
                                    "old.vti", "-o", "none", cwd=self.folder), 3, "old.vti")

    def test_skipped_pass_leaves_material(self):
        facts = self.judged(passes([y for y in range(31) if y != 10]), "--resolution", "0.25", status=1)
        self.assertEqual((facts["verdict"], facts["max_gouge_mm"]), ("uncut", 0))
        self.assertLessEqual(facts["max_scallop_mm"], scallop(2) + 1e-12)
        self.assertGreaterEqual(facts["max_scallop_mm"] + facts["scallop_bound_mm"], scallop(2) - 1e-12)
        self.assertAlmostEqual(facts["max_scallop_at"]["point_mm"][1], 10, delta=0.25)
        width = 2 * (1 - math.sqrt(25 - 4.95 ** 2))  # of the region between the neighbouring balls
        self.assertAlmostEqual(facts["uncut_area_mm2"], 60 * width, delta=60 * 0.25)

    def test_refining_never_changes_a_decided_verdict(self):
        self.file(plane())
        for name, tips, truth in (("g", passes(range(31)), "clean"), ("d", passes(range(31), dip=10), "gouged"),
                                  ("s", passes([y for y in range(31) if y != 10]), "uncut")):
            path = self.file(tips, f"{name}.csv")
            decided = set()
            for resolution in (10, 6, 4, 1.5):
                for refine in (0, 4, 8):
                    done = endmill("verify", path, "--part", "surface.json", "--cutter", "ball:10", "--scallop", "0.05",
                                   "--resolution", resolution, "--max-refine", refine, "-o", "out", "--force", "--json",
                                   cwd=self.folder)
                    verdict = json.loads(done.stdout)["verdict"]
                    was_decided = any(pitch >= resolution and halvings <= refine for pitch, halvings in decided)
                    expected = (truth,) if was_decided else (truth, "undecided")
                    self.assertIn(verdict, expected, (name, resolution, refine))
                    if verdict == truth:
                        decided.add((resolution, refine))
                    self.assertEqual(done.returncode, 0 if verdict == "clean" else 1)
            self.assertIn((1.5, 8), decided)

    def test_undecided_verdict_exits_1_with_a_hint(self):
        path = self.file(passes(range(31)), "p.csv")
        done = endmill("verify", path, "--part", self.file(plane()), "--cutter", "ball:10", "--scallop", "0.0255",
                       "--resolution", "2", "--max-refine", "0", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"^p: undecided: .*use a finer --resolution\n")
        self.assertEqual(len(done.stdout.splitlines()), 6, "five lines and the folder")

    def test_rapid_that_cuts_is_a_gouge(self):
        text = "move," + COLUMNS + "cut,0,10,0\ncut,60,10,0\nrapid,60,20,0\nrapid,60,20,30\nrapid,0,0,30\n"
        self.file(plane())
        facts = self.verify(self.file(text, "p.csv"), "--part", "surface.json", "--cutter", "ball:10", "--scallop",
                            "2", "--resolution", "1", status=1)
        self.assertEqual((facts["verdict"], facts["rapid_cuts"], facts["first_of_rapid_cuts"]), ("gouged", 1, 2))
        self.assertAlmostEqual(facts["deepest_of_rapid_cuts_mm"], 1, delta=0.05)
        self.assertEqual(facts["max_gouge_mm"], 0)
        self.assertIn("verdict gouged: 1 rapid cut", (self.folder / "out/deviation.svg").read_text())

    def test_path_with_another_fixed_axis_is_rotated(self):
        facts = self.verify(self.planned("--mode", "verified", "--axis", "0,0.6,0.8"), "--resolution", "1")
        self.assertTrue(any("0,0.6,0.8 becomes +z" in remark for remark in facts["remarks"]), facts["remarks"])
        self.assertAlmostEqual(facts["judged_area_mm2"], 1800, delta=1e-6)
        self.assertLessEqual(facts["max_scallop_mm"], 0.2 + 0.001)

    def test_mesh_and_surface_give_the_same_verdict(self):
        self.planned("--mode", "verified")
        self.summary("sample", "surface.json", "--grid", "3", "--format", "stl", "-o", "mesh")
        facts = self.verify("plan/toolpath.csv", "--part", "mesh/mesh.stl", "--resolution", "1")
        self.assertIsInstance(facts["max_scallop_at"]["triangle"], int)
        self.assertAlmostEqual(facts["judged_area_mm2"], 1800, delta=1e-3)

    def test_missing_part_is_an_error(self):
        path = self.planned("--mode", "verified")
        (self.folder / "surface.json").unlink()
        done = endmill("verify", path, "--resolution", "1", "-o", "out", cwd=self.folder)
        self.assert_refused(done, 3, "its summary names the part ", "--part FILE")
        self.assertFalse((self.folder / "out").exists())
        done = endmill("verify", path, "--part", "none", "--resolution", "1", "-o", "out", cwd=self.folder)
        self.assertIn("no part is compared (--part none)", done.stdout)

    def test_program_is_judged_by_the_part_of_its_path(self):
        path = self.planned("--mode", "verified")
        endmill("post", path, "--feed", "500", "-o", "posted", cwd=self.folder)
        facts = [self.verify(file, "--resolution", "1") for file in (path, "posted/toolpath.ngc")]
        self.assertIsNotNone(facts[1]["part"])
        for key in ("verdict", "judged_area_mm2"):
            self.assertEqual(facts[0][key], facts[1][key])
        # Coordinates of a program are rounded to 5e-5 mm.
        self.assertAlmostEqual(facts[0]["max_scallop_mm"], facts[1]["max_scallop_mm"], delta=3e-4)


class Volumes(VerifyTest):
    def cut(self, *options, tips=THROUGH, name="p.csv", status=0):
        part = () if "--part" in options else ("--part", "none")
        return self.verify(self.file(tips, name), *part, *options, status=status)

    def test_without_a_part_nothing_is_judged(self):
        path = self.file(THROUGH, "p.csv")
        for options, status in (((), 1), (("--part", "none"), 0)):
            done = endmill("verify", path, "--cutter", "ball:10", *BLOCK, *options, "-o", "said", "--force",
                           cwd=self.folder)
            self.assertEqual(done.returncode, status, done.stderr)
            self.assertTrue(done.stdout.startswith("p: not judged: no part "), done.stdout)
            self.assertEqual("--part FILE" in done.stdout, not options, "a hint only where nothing was asked for")
        rapid = self.file("move," + COLUMNS + "cut,-30,0,-1\nrapid,30,0,-1\n", "r.csv")
        facts = self.verify(rapid, "--cutter", "ball:10", *BLOCK, "--part", "none", status=1)
        self.assertEqual(facts["verdict"], "collides")
        done = endmill("verify", rapid, "--cutter", "ball:10", *BLOCK, "-o", "hit", cwd=self.folder)
        self.assertRegex(done.stdout, r"^r: collides: 1 rapid cuts, up to 1 mm deep, the first to point 1\n")
        self.assertNotIn("--part", done.stdout)
        # The extent is that of the two points.
        self.assertIn("extent      x -30.000 to 30.000, y 0.000 to 0.000, z -1.000 to -1.000 mm\n", done.stdout)

    def test_summary_has_the_totals_of_the_path(self):
        rows = ("rapid,0,0,20,,\nplunge,0,0,-1,100,1\ncut,3,4,-1,50,1\nlink,3,5,-1,50,1\nretract,3,5,20,210,1\n"
                "rapid,15,5,20,,1\n")
        header = "move," + COLUMNS.strip() + ",feed_mm_per_min,tool\n"
        facts = self.cut("--cutter", "ball:10", *BLOCK, tips=header + rows)
        self.assertEqual([facts[key] for key in ("cut_mm", "plunge_mm", "link_mm", "rapid_mm", "tools")],
                         [5, 21, 1 + 21, 12, [1]])
        self.assertAlmostEqual(facts["time_min"], 0.21 + 0.1 + 0.02 + 0.1, delta=1e-12)
        self.assertEqual((facts["min_mm"], facts["max_mm"]), ([0, 0, -1], [15, 5, 20]))
        self.assertIsNone(self.cut("--cutter", "ball:10", *BLOCK)["time_min"])

    def test_volume_of_a_straight_cut_has_its_closed_form(self):
        facts = self.cut("--cutter", "ball:10", *BLOCK)
        # The midpoint rule across a section with steep ends has an error of O(pitch^1.5); along x it is exact.
        self.assertAlmostEqual(facts["removed_mm3"], 20 * SECTION, delta=20 * 0.1**1.5 * 0.2)
        self.assertEqual(facts["min_z_mm"], min(facts["min_z_mm"], -0.99))
        self.assertEqual((facts["max_z_mm"], facts["verdict"], facts["part"]), (0, "not judged", None))
        for key in ("max_gouge_mm", "gouge_area_mm2", "max_scallop_mm", "p99_scallop_mm", "mean_scallop_mm",
                    "uncut_area_mm2", "bound_mm"):
            self.assertIsNone(facts[key])
        self.assertEqual(sorted(file.name for file in (self.folder / "out").iterdir()),
                         ["removal.csv", "summary.json"])

    def test_removal_rate_is_volume_divided_by_time(self):
        header = "feed_mm_per_min," + COLUMNS
        facts = self.cut("--cutter", "flat:10", *BLOCK, "--resolution", "0.5",
                         tips=header + "500,-30,0,-1\n500,0,0,-1\n250,30,0,-1\n")
        rows = self.rows("out/removal.csv")
        self.assertEqual([float(row["length_mm"]) for row in rows], [0, 30, 30])
        self.assertAlmostEqual(sum(float(row["removed_mm3"]) for row in rows), facts["removed_mm3"], delta=1e-9)
        for row, feed in list(zip(rows, (500, 500, 250)))[1:]:
            self.assertAlmostEqual(float(row["rate_mm3_per_min"]),
                                   float(row["removed_mm3"]) * feed / float(row["length_mm"]), delta=1e-6)
        self.assertAlmostEqual(facts["removed_mm3"], 20 * 10 * 1, delta=1e-9)

    def test_programs_of_ball_centres_are_accepted(self):
        text = "G21 G90 G94 G17\nG0 X-30 Y0 Z4\nG1 X30 F100\nM2\n"
        facts = self.cut("--cutter", "ball:10", "--programmed-point", "centre", *BLOCK, tips=text, name="c.ngc")
        self.assertEqual(facts["removed_mm3"], self.cut("--cutter", "ball:10", *BLOCK)["removed_mm3"])

    def test_volume_of_an_arc_is_section_times_length(self):
        text = "G21 G90 G94 G17\nG0 X10 Y0 Z9\nG1 Z-1 F100\nG3 X10 Y0 I-10 J0\nM2\n"
        facts = self.cut("--cutter", "ball:10", "--stock", "-20,-20,-10,20,20,0", tips=text, name="a.ngc")
        # Pappus: the centroid of the section moves on a circle of radius 10 mm.
        self.assertAlmostEqual(facts["removed_mm3"], 20 * math.pi * SECTION, delta=0.03)

    def test_stock_of_an_earlier_run_is_cut_further(self):
        whole = self.cut("--cutter", "ball:10", *BLOCK, "--resolution", "0.5",
                         tips=COLUMNS + "-30,0,-1\n30,0,-1\n30,3,-1\n-30,3,-1\n")
        first = self.cut("--cutter", "ball:10", *BLOCK, "--resolution", "0.5", "--write-stock",
                         tips=COLUMNS + "-30,0,-1\n30,0,-1\n30,3,-1\n")
        shutil.move(self.folder / "out/stock.vti", self.folder / "rest.vti")
        second = self.cut("--cutter", "ball:10", "--stock", "rest.vti", tips=COLUMNS + "30,3,-1\n-30,3,-1\n")
        self.assertAlmostEqual(first["removed_mm3"] + second["removed_mm3"], whole["removed_mm3"], delta=1e-9)
        self.assertEqual(second["min_z_mm"], whole["min_z_mm"])
        self.assertIsNone(second["earlier_gouge_bound_mm"])  # no part

    def test_stock_and_remaining_stock_may_be_meshes(self):
        self.cut("--cutter", "ball:10", *BLOCK, "--resolution", "0.5", "--write-mesh")
        shutil.move(self.folder / "out/rest.stl", self.folder / "rest.stl")
        mesh = self.summary("info", "rest.stl")
        self.assertEqual(mesh["boundary_edges"], 0)
        # The mesh ends half a pitch inside the outermost cells.
        self.assertAlmostEqual(mesh["volume_mm3"], 19.5 * (19.5 * 10 - SECTION), delta=1)
        deeper = 25 * math.acos(1 - 2 / 5) - 3 * math.sqrt(16)  # the section 2 mm deep
        rest = self.cut("--cutter", "ball:10", "--stock", "rest.stl", "--resolution", "0.5",
                        tips=COLUMNS + "30,0,-2\n-30,0,-2\n")["removed_mm3"]
        self.assertAlmostEqual(rest, 19.5 * (deeper - SECTION), delta=2)

    def test_open_mesh_as_stock_is_refused_by_name(self):
        self.file("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                  "endloop\nendfacet\nendsolid a\n", "open.stl")
        path = self.file(COLUMNS + "0,0,0\n1,0,0\n", "p.csv")
        done = endmill("verify", path, "--cutter", "ball:10", "--stock", "open.stl", cwd=self.folder)
        self.assert_refused(done, 4, "error: open.stl: ", "a stock must be a closed mesh")

    def test_holder_in_the_material_is_a_collision(self):
        for deep, status in ((-1, 0), (-45, 1)):
            facts = self.cut("--tool", HOLDER, "--stock", "-20,-20,-60,20,20,0", "--resolution", "1",
                             tips=COLUMNS + f"-30,0,{deep}\n30,0,{deep}\n", status=status)
            self.assertEqual((facts["cutter"], facts["tool"]), ("ball:10", str(HOLDER)))
            self.assertEqual(facts["collisions"] > 0, status == 1)
        # The holder begins 40 mm above the tip.
        self.assertAlmostEqual(facts["deepest_of_collisions_mm"], 5, delta=1e-9)

    def test_holder_in_the_part_is_a_collision_without_material(self):
        slope = 0.5
        part = self.file(plane(size=(60, 30), slope=slope))
        tool = self.file({"format": "endmill-tool/1", "cutter": "ball:4",
                          "holder": [{"diameter_mm": 16, "from_mm": 1.5, "to_mm": 50}]}, "tool.json")
        # A plunge to the part. Where the holder enters the part, the stock lies below it.
        depth = 8 - (8 + 1.5) / (1 + slope)
        facts = self.cut("--part", part, "--tool", tool, "--stock", "0,0,-9,60,30,16", "--resolution", "0.5",
                         tips=COLUMNS + "30,15,20\n30,15,15\n", status=1)
        self.assertEqual((facts["collisions"], facts["part_collisions"], facts["verdict"]), (0, 1, "gouged"))
        self.assertAlmostEqual(facts["deepest_of_part_collisions_mm"], depth, delta=0.03 * depth)
        x, y, z = facts["deepest_of_part_collisions_at"]["point_mm"]
        self.assertAlmostEqual(z, slope * x, delta=1e-9)
        self.assertEqual(facts["first_of_part_collisions"], 1)

    def test_rapid_through_a_ridge_between_cells_is_found(self):
        # The ridge between two slots is 0.3 mm wide with its top at 0. The rapid moves along it 1 mm deep.
        lines = ["G21 G90 F100"] + [f"G{g} X{x} Y{y} Z{z}" for g, x, y, z in (
            (0, -30, -5.15, -2), (1, 30, -5.15, -2), (0, 30, 0, 20), (0, 30, 5.15, 20), (0, 30, 5.15, -2),
            (1, -30, 5.15, -2), (0, -30, 0, 20), (0, -30, 0, -1), (0, 30, 0, -1))] + ["M2"]
        facts = self.cut("--cutter", "flat:10", *BLOCK, "--resolution", "0.5", tips="\n".join(lines), name="c.ngc",
                         status=1)
        self.assertEqual((facts["rapid_cuts"], facts["deepest_of_rapid_cuts_mm"]), (1, 1))
        self.assertAlmostEqual(facts["contact_width_bound_mm"], 0.5 * math.sqrt(2) / 9, delta=1e-12)
        # A rapid above the block cannot cut.
        self.assertEqual(self.cut("--cutter", "ball:10", *BLOCK)["contact_width_bound_mm"], 0)

    def test_engagement_of_half_a_slot(self):
        self.cut("--cutter", "flat:10", "--stock", "-10,0,-10,10,10,0", "--resolution", "0.25", "--engagement")
        rows = [row for row in self.rows("out/engagement.csv") if row["latitude_deg"] == "90"]
        self.assertTrue(rows)
        for row in rows:  # only the left side of the feed along x is engaged
            self.assertAlmostEqual(float(row["from_deg"]), 0, delta=3)
            self.assertAlmostEqual(float(row["to_deg"]), 90, delta=3)

    def test_path_above_its_block_gets_a_hint_about_stock(self):
        done = endmill("verify", self.file(THROUGH, "p.csv"), "--cutter", "ball:10", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("--stock sets where the material is", done.stdout)


class Summaries(VerifyTest):
    """The summary.json beside a path is used only if it describes this path."""

    def warned(self, path, *options, status=0):
        """The summary and the warnings of verify."""
        done = endmill("verify", path, "--resolution", "1", *options, "-o", "out", "--force", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout), done.stderr

    def test_summary_names_the_digest_of_its_path(self):
        path = self.planned("--mode", "verified")
        facts = json.loads((self.folder / "plan/summary.json").read_text())
        self.assertEqual(facts["toolpath_sha256"], hashlib.sha256(path.read_bytes()).hexdigest())
        self.assertEqual(facts["toolpath_points"], len(path.read_text().splitlines()) - 1)
        self.assertEqual(self.warned(path)[1], "")
        self.summary("post", path, "--feed", "500", "-o", "posted")
        facts = json.loads((self.folder / "posted/summary.json").read_text())
        program = self.folder / "posted/toolpath.ngc"
        self.assertEqual(facts["toolpath_sha256"], hashlib.sha256(program.read_bytes()).hexdigest())

    def test_changed_path_is_judged_without_the_summary(self):
        path = self.planned("--mode", "verified")
        path.write_text(path.read_text() + path.read_text().splitlines()[-1] + "\n")
        facts, said = self.warned(path, "--cutter", "ball:10", status=1)
        self.assertEqual((facts["verdict"], facts["part"]), ("not judged", None))
        self.assertIn("describes another path (toolpath_sha256) and is not used", said)
        done = endmill("verify", path, "-o", "none", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("names the cutter; expected --cutter", done.stderr)

    def test_program_beside_the_summary_of_another_path_is_safe(self):
        self.planned("--mode", "verified")
        program = self.file("G21 G90\nG0 X0 Y0 Z9\nG1 Z1 F100\nX9\nM2\n", "plan/part.ngc")
        facts, said = self.warned(program, "--cutter", "ball:6", status=1)
        self.assertEqual((facts["cutter"], facts["tolerance_mm"]), ("ball:6", 0.01))
        self.assertIn("is not used", said)

    def test_summary_without_a_digest_is_used_with_a_warning(self):
        path = self.planned("--mode", "verified")
        file = self.folder / "plan/summary.json"
        facts = json.loads(file.read_text())
        del facts["toolpath_sha256"], facts["toolpath_points"]
        file.write_text(json.dumps(facts))
        found, said = self.warned(path)
        self.assertEqual(found["cutter"], "ball:10")
        self.assertIn("names no toolpath_sha256 and may describe an earlier path", said)


class SeveralTools(VerifyTest):
    HEADER = "move," + COLUMNS.strip() + ",tool\n"
    # Two slots that cross: 10 mm wide and 2 mm deep, then 4 mm wide and 4 mm deep.
    SLOTS = HEADER + ("rapid,-30,0,5,1\ncut,-30,0,-2,1\ncut,30,0,-2,1\nrapid,30,0,9,1\nrapid,0,-30,9,2\n"
                      "cut,0,-30,-4,2\ncut,0,30,-4,2\n")
    TABLE = {"format": "endmill-tools/1", "tools": [{"number": 2, "tool": {"cutter": "flat:4"}},
                                                     {"number": 1, "tool": "flat:10"}]}
    OPTIONS = ("--part", "none", "--stock", "-15,-15,-10,15,15,0", "--resolution", "0.5")

    def test_each_tool_cuts_with_its_own_cutter(self):
        path = self.file(self.SLOTS, "p.csv")
        for table in (self.file(self.TABLE, "t.json"), self.file("T1 D10\nT2 D4 ;flat:4 finishing\n", "t.tbl"),
                      self.file(f"T1 D{10 / 25.4:.6f}\nT2 D{4 / 25.4:.6f}\n", "i.tbl")):
            unit = {"t.tbl": ("--tools-units", "mm"), "i.tbl": ("--tools-units", "inch")}.get(table.name, ())
            facts = self.verify(path, *self.OPTIONS, "--tools", table, *unit)
            self.assertAlmostEqual(facts["removed_mm3"], 30 * 10 * 2 + 30 * 4 * 4 - 10 * 4 * 2, delta=0.01)
            self.assertEqual((facts["cutter"], facts["tools"]), (None, [1, 2]))
            self.assertEqual([entry["tool"] for entry in facts["cutters"]], [1, 2])

    def test_tools_of_apt(self):
        path = self.file(self.SLOTS, "p.csv")
        table = self.file(self.TABLE, "t.json")
        expected = self.verify(path, *self.OPTIONS, "--tools", table)
        goto = [f"{'RAPID' if move == 'rapid' else '$$'}\nGOTO/{x},{y},{z}\n" for move, x, y, z, _ in
                (row.split(",") for row in self.SLOTS.splitlines()[1:])]
        apt = self.file("UNITS/MM\nLOADTL/1,$\nLENGTH,100\nCUTTER/10\nFEDRAT/100,MMPM\n" + "".join(goto[:3]) +
                        "RAPID\n" + "LOADTL/2\nCUTTER/4\n" + "".join(goto[3:]) + "FINI\n", "p.apt")
        found = self.verify(apt, *self.OPTIONS, "--tools", table)
        for key in ("removed_mm3", "tools", "cutters", "points"):
            self.assertEqual(found[key], expected[key])
        self.assert_refused(endmill("verify", apt, *self.OPTIONS, "--cutter", "flat:10", cwd=self.folder), 3,
                            'p.apt:14: "CUTTER/4"', "--tools FILE")

    def test_holder_of_the_second_tool_collides(self):
        table = json.loads(json.dumps(self.TABLE))
        table["tools"][0]["tool"]["holder"] = [{"diameter_mm": 20, "from_mm": 3, "to_mm": 30}]
        facts = self.verify(self.file(self.SLOTS, "p.csv"), *self.OPTIONS, "--tools", self.file(table, "t.json"),
                            status=1)
        self.assertEqual((facts["verdict"], facts["first_of_collisions"]), ("collides", 6))

    def test_cut_before_the_first_tool_is_refused(self):
        path = self.file(self.SLOTS.replace(",1\n", ",\n"), "p.csv")
        for tools in (("--tools", self.file(self.TABLE, "t.json")), ("--cutter", "flat:4")):
            self.assert_refused(endmill("verify", path, *self.OPTIONS, *tools, cwd=self.folder), 2,
                                "the move to point 1 cuts before the first tool T2 at point 4")

    def test_rest_of_several_tools_is_cut_further(self):
        path = self.file(self.SLOTS, "p.csv")
        self.verify(path, *self.OPTIONS, "--tools", self.file(self.TABLE, "t.json"), "--write-stock")
        shutil.move(self.folder / "out/stock.vti", self.folder / "rest.vti")
        again = self.verify(path, "--part", "none", "--stock", "rest.vti", "--tools", "t.json")
        self.assertEqual(again["removed_mm3"], 0)

    def test_place_that_only_the_second_tool_can_touch_is_judged(self):
        # A pocket of 6 by 20 mm, 2 mm deep, in a plane that the first tool cuts.
        xs, ys = (-20, -3, 3, 20), (-20, -10, 10, 20)
        quads = [[(x, y, -2 * (i == j == 1)) for x, y in ((xs[i], ys[j]), (xs[i + 1], ys[j]), (xs[i + 1], ys[j + 1]),
                                                          (xs[i], ys[j + 1]))] for i in range(3) for j in range(3)]
        rim = [(-3, -10), (3, -10), (3, 10), (-3, 10)]
        quads += [[(*a, -2), (*a, 0), (*b, 0), (*b, -2)] for a, b in zip(rim, rim[1:] + rim[:1])]
        stl = "solid s\n" + "".join(
            "facet normal 0 0 1\nouter loop\n" + "".join("vertex {} {} {}\n".format(*corner) for corner in facet) +
            "endloop\nendfacet\n" for a, b, c, d in quads for facet in ((a, b, c), (a, c, d))) + "endsolid s\n"
        path = self.file(self.HEADER + "".join(
            f"{'cut' if k else 'rapid'},{x},{y},0,1\n" for k, (x, y) in enumerate(
                (x, y if n % 2 else -y) for n, x in enumerate(range(-20, 21, 5)) for y in (-26, 26))) +
            "rapid,18,0,9,2\ncut,18,0,0,2\ncut,19,0,0,2\n", "p.csv")
        for second, verdict in (("flat:4", "uncut"), ("flat:8", "clean")):
            table = self.file({"format": "endmill-tools/1", "tools": [{"number": 1, "tool": "flat:10"},
                                                                      {"number": 2, "tool": second}]}, "t.json")
            options = ("--tools", table, "--part", self.file(stl, "part.stl"), "--units", "mm", "--inaccessible",
                       "report", "--resolution", "0.5", "--stock", "-20,-20,-9,20,20,1")
            facts = self.verify(path, *options, status=int(verdict == "uncut"))
            self.assertEqual(facts["verdict"], verdict)
            if verdict == "clean":
                pocket = 6 * 20 + 2 * 2 * (6 + 20)  # floor and walls
                self.assertAlmostEqual(facts["inaccessible_area_mm2"], pocket, delta=0.01)
                done = endmill("verify", path, *options, "-o", "said", cwd=self.folder)
                self.assertIn("mm2 that no tool can touch", done.stdout)

    def test_wrong_tables_are_refused(self):
        path = self.file(self.SLOTS, "p.csv")
        table = self.file(self.TABLE, "t.json")
        one = self.file("T1 D10\n", "one.tbl")
        for status, words, options in (
                (2, ("several tools cut (T1, T2)", "--tools FILE"), ("--cutter", "flat:10")),
                (3, ("one.tbl: no row with a cutter for tool 2", "with a diameter D above 0"),
                 ("--tools", one, "--tools-units", "mm")),
                (3, ("none.tbl: no row with a diameter; expected rows such as T1 P1 D6.0",),
                 ("--tools", self.file("T1 P1\nT2 D0\n", "none.tbl"), "--tools-units", "mm")),
                (3, ("mac.tbl:1: a carriage return without a line feed",),
                 ("--tools", self.file("T1 D10\rT2 D4\r", "mac.tbl"), "--tools-units", "mm")),
                (2, ("one.tbl", "does not state its unit", "--tools-units"), ("--tools", one)),
                (2, ("--tools-units: has no effect",), ("--tools", table, "--tools-units", "mm")),
                (2, ("--tools-units: has no effect", "expected --tools"), ("--tools-units", "mm")),
                (2, ("--cutter: has no effect with --tools",), ("--tools", table, "--cutter", "flat:10")),
                (2, ("--engagement",), ("--tools", table, "--engagement")),
                (3, ("none.json", "No such file"), ("--tools", "none.json"))):
            self.assert_refused(endmill("verify", path, *options, cwd=self.folder), status, *words)
        self.assertFalse((self.folder / "p-verify").exists())


class Origins(VerifyTest):
    def test_paths_of_every_format_get_the_same_verdict_and_volume(self):
        path = self.planned("--mode", "verified", "--feed", "400")
        self.summary("post", path, "-o", "gcode")
        self.summary("post", path, "--format", "apt", "-o", "apt")
        with open(path, encoding="utf-8") as file:
            tips = "".join(",".join(line.split(",")[3:6]) + "\n" for line in file)
        self.file(tips.rstrip("\n") + "\n", "tips.csv")
        files = [path, "gcode/toolpath.ngc", "apt/toolpath.apt", "tips.csv"]
        if shutil.which("rs274"):
            self.file("T1 P1 D0.3937 Z0.0 ;ball\n", "tool.tbl")
            done = subprocess.run(["rs274", "-g", "-t", "tool.tbl", "gcode/toolpath.ngc"], cwd=self.folder,
                                  capture_output=True, text=True, check=True, timeout=600)
            self.file(done.stdout, "canonical.txt")
            files.append("canonical.txt")
        found = [self.verify(file, "--part", "surface.json", "--cutter", "ball:10", "--tolerance", "0.05", "--scallop",
                             "0.25", "--resolution", "1") for file in files]
        for facts in found[1:]:
            self.assertEqual(facts["verdict"], found[0]["verdict"])
            for key in ("removed_mm3", "max_gouge_mm", "max_scallop_mm"):
                self.assertAlmostEqual(facts[key], found[0][key], delta=1e-4 * max(1, found[0][key]))
        self.assertIn("no column move: every move is assumed to be a cut", found[3]["remarks"])

    def test_apt_cl_data_names_the_cutter(self):
        self.summary("post", self.planned("--mode", "verified"), "--format", "apt", "--feed", "1", "-o", "apt")
        facts = self.verify("apt/toolpath.apt", "--part", "surface.json", "--scallop", "0.25", "--resolution", "1")
        self.assertEqual(facts["cutter"], "ball:10")

    def test_files_do_not_depend_on_the_number_of_threads(self):
        self.summary("plan", SURFACES / "net_rot24_7D.json", "--mode", "paper", "--direction", "v", "-o", "plan", status=1)
        found = set()
        for threads in (1, 2, 3, 8):
            self.verify("plan/toolpath.csv", "--resolution", "6", "--threads", threads, "--write-stock",
                        "--write-mesh", "--engagement", status=1)
            files = sorted((self.folder / "out").iterdir())
            found.add(tuple((file.name, file.read_bytes()) for file in files))
        self.assertEqual(len(found), 1)
        self.assertEqual([name for name, _ in found.pop()],
                         ["deviation.svg", "deviation.vtp", "engagement.csv", "histogram.csv", "removal.csv",
                          "rest.stl", "stock.vti", "summary.json"])

    def test_files_are_well_formed_and_replaced_by_a_second_run(self):
        path = self.planned()
        facts = self.verify(path, "--resolution", "1", "--write-stock", "--write-mesh", "--engagement")
        ElementTree.parse(self.folder / "out/deviation.svg")
        self.assertIn(b"VTKFile", (self.folder / "out/deviation.vtp").read_bytes()[:400])
        bins = self.rows("out/histogram.csv")
        self.assertAlmostEqual(sum(float(row["area_mm2"]) for row in bins), facts["judged_area_mm2"], delta=1e-3)
        for text in ("ball:10", "rays 1 mm apart", facts["verdict"]):
            self.assertIn(text, (self.folder / "out/deviation.svg").read_text())
        self.verify(path, "--resolution", "1")
        self.assertEqual(sorted(file.name for file in (self.folder / "out").iterdir()),
                         ["deviation.svg", "deviation.vtp", "histogram.csv", "removal.csv", "summary.json"])

    def test_path_in_the_output_folder_is_kept(self):
        path = self.planned()
        before = path.read_bytes()
        done = endmill("verify", path, "--resolution", "1", "-o", self.folder / "plan", "--force", cwd=self.folder)
        self.assertIn(done.returncode, (0, 2), done.stderr)
        self.assertEqual(path.read_bytes(), before)


class BadInput(VerifyTest):
    def refuse(self, status, *words, content=THROUGH, name="p.csv", options=("--cutter", "ball:10")):
        path = self.file(content, name)
        kept = {file.name for file in self.folder.iterdir()}
        self.assert_refused(endmill("verify", path, *options, cwd=self.folder), status, *words)
        self.assert_nothing_left(*kept)
        path.unlink()

    def test_bad_files_are_refused(self):
        self.refuse(3, 'p.csv:3: tip_y_mm is "NaN"', content=COLUMNS + "0,0,0\n1,NaN,2\n")
        self.refuse(3, "p.ngc:3: cutter compensation G41", content="G21 G90\nG1 X0 Y0 Z1 F100\nG41 X3\n", name="p.ngc")
        self.refuse(3, "p.ngc:2", "--interpreter linuxcnc", content="G21\n#1=5\n", name="p.ngc")
        self.refuse(3, "none.json", "No such file", options=("--cutter", "ball:10", "--part", "none.json"))
        self.refuse(3, "none.json", "No such file", options=("--tool", "none.json"))
        self.refuse(3, "none.stl", "No such file", options=("--cutter", "ball:10", "--stock", "none.stl"))
        self.refuse(3, "looks like JSON", options=("--cutter", "ball:10", "--stock", SURFACES / "plane.json"))
        self.refuse(3, "p.csv.vti", options=("--cutter", "ball:10", "--stock", self.file("x", "p.csv.vti")))
        self.assert_refused(endmill("verify", self.folder / "none.ngc", "--cutter", "ball:10"), 3, "No such file")

    def test_missing_or_wrong_cutter_is_refused(self):
        self.refuse(2, "names the cutter; expected --cutter or --tool", options=())
        self.refuse(2, "--cutter ball:8: the tool file has ball:10", options=("--cutter", "ball:8", "--tool", HOLDER))
        self.refuse(2, "--programmed-point centre: the cutter is not known; expected --cutter", options=("--programmed-point", "centre"),
                    content="G21 G90\nG1 X0 Y0 Z1 F100\nX2\nM2\n", name="p.ngc")
        self.refuse(2, "--programmed-point centre: ", "a tool path (CSV)",
                    options=("--cutter", "ball:10", "--programmed-point", "centre"))
        self.refuse(2, "--cutter", options=("--cutter", "ball"))

    def test_wrong_command_lines_are_refused(self):
        for option in ("--resolution", "--tolerance", "--scallop", "--arc-tolerance"):
            for number in ("0", "-1", "nan", "inf", "1,5"):
                self.refuse(2, f'{option}: found "{number}"; expected a number above 0',
                            options=("--cutter", "ball:10", option, number))
        for stock in ("1,2,3", "0,0,0,1,1,nan", "0,0,0,0,1,1", ","):
            self.refuse(2, f"--stock {stock}: expected ", "X0,Y0,Z0,X1,Y1,Z1",
                        options=("--cutter", "ball:10", "--stock", stock))
        self.refuse(2, "--max-refine", options=("--cutter", "ball:10", "--max-refine", "21"))

    def test_nick_in_the_part_is_judged_at_any_resolution(self):
        path = self.file(COLUMNS + "-3.4,-10,-0.5\n-3.4,-3.5,-0.5\n-10,-3.5,-0.5\n", "nick.csv")
        part = ("--part", self.file(plane()), "--cutter", "flat:10")
        for resolution, refine, verdict in ((5, 0, "undecided"), (5, 8, "gouged"), (1, 8, "gouged")):
            done = endmill("verify", path, *part, "--resolution", resolution, "--max-refine", refine, "-o", "out",
                           "--force", cwd=self.folder)
            self.assertEqual(done.returncode, 1, done.stderr)
            facts = json.loads((self.folder / "out/summary.json").read_text())
            self.assertEqual((facts["verdict"], facts["gouge_bound_refined"]), (verdict, verdict != "gouged"))
            self.assertFalse(facts["scallop_bound_refined"])
            self.assertEqual("gouge" in done.stdout and "bound not refined" in done.stdout, True)
        shutil.rmtree(self.folder / "out")

    def test_path_that_misses_the_part_is_refused_with_the_gap(self):
        part = ("--part", self.file(plane()), "--cutter", "ball:10", "--resolution", "1")
        for content, truth in ((COLUMNS + "-30,200,-1\n30,200,-1\n", math.hypot(170, 4) - 5),
                               (COLUMNS + "0,0,9\n60,0,9\n", 9)):
            path = self.file(content, "p.csv")
            done = endmill("verify", path, *part, cwd=self.folder)
            self.assert_refused(done, 4, "p.csv: the path cuts nothing over the part", "at least ", " mm apart")
            gap = float(done.stderr.split("at least ")[1].split(" mm")[0])
            self.assertTrue(truth - 2 <= gap <= truth, gap)

    def test_too_fine_resolution_is_refused_with_one_that_fits(self):
        part = ("--part", self.file(plane()))
        block = ("--stock", "0,0,0,100,100,10")
        path = self.file(passes(range(31)), "p.csv")
        for where in (part, block, (*part, *block)):
            options = (*where, "--cutter", "ball:10", "--max-memory", "0.004")
            done = endmill("verify", path, *options, "--resolution", "1e-4", cwd=self.folder)
            self.assert_refused(done, 6, " GiB; expected at most 0.004 GiB (--max-memory), which ")
            fitting = done.stderr.split("which ")[1].split(" of ")[1].split(" mm")[0]
            done = endmill("verify", path, *options, "--resolution", fitting, "-o", "out", "--force", cwd=self.folder)
            self.assertIn(done.returncode, (0, 1), done.stderr)

    def test_memory_limit_includes_the_written_stock(self):
        self.file(THROUGH, "p.csv")
        cut = ("p.csv", "--cutter", "ball:10", "--stock", "0,0,0,100,100,10", "--max-memory", "0.005",
               "--part", "none", "--resolution")
        whole = endmill("verify", *cut, "0.25", "-o", "plain", cwd=self.folder)
        self.assertEqual(whole.returncode, 0, whole.stderr)
        for option in ("--write-mesh", "--write-stock", "--engagement"):
            resolution = "0.25" if option == "--write-mesh" else "0.2"
            done = endmill("verify", *cut, resolution, option, "-o", "out", cwd=self.folder)
            self.assert_refused(done, 6, f"in cells of {resolution} mm would need", "(--max-memory), which cells of ")
            fitting = done.stderr.split("which cells of ")[1].split(" mm")[0]
            done = endmill("verify", *cut, fitting, option, "-o", option, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_output_errors_are_reported(self):
        path = self.file(THROUGH, "p.csv")
        self.assert_refused(endmill("verify", path, "--cutter", "ball:10", "-o", self.folder), 2, "not empty")
        self.assert_refused(endmill("verify", path, "--cutter", "ball:10", "-o", path), 2, "p.csv is a file")
        self.assert_refused(endmill("verify", path, "--cutter", "ball:10", "-o", "/proc/x"), 5, "/proc/x")

    def test_full_disk_leaves_nothing(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
        path = self.file(passes(range(31)), "p.csv")
        self.file(plane())
        done = endmill("verify", path, "--part", "surface.json", "--cutter", "ball:10", "--resolution", "1",
                       cwd=self.folder, preexec_fn=limit)
        self.assert_refused(done, 5, "p-verify/deviation.vtp: File too large")
        self.assert_nothing_left("p.csv", "surface.json")

    def test_a_ball_that_just_touches_an_edge_is_clean_at_every_resolution(self):
        """A ball of radius 5 runs along an edge of a box, in the plane at 45 degrees through the edge. It touches the
        ends of the edge too, where no plane along the move bounds its depth in the end faces."""
        corners = [(x, y, z) for x in (0, 40) for y in (0, 40) for z in (-40, 0)]
        faces = ((0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6),
                 (0, 6, 4), (1, 5, 7), (1, 7, 3))
        self.file("OFF\n8 12 0\n" + "".join(f"{x} {y} {z}\n" for x, y, z in corners) +
                  "".join(f"3 {a} {b} {c}\n" for a, b, c in faces), "box.off")
        away = 5 / math.sqrt(2)
        path = self.file(f"{COLUMNS}{40 + away!r},-10,{away - 5!r}\n{40 + away!r},50,{away - 5!r}\n", "p.csv")
        for resolution in (2, 0.5, 0.25):
            found = self.summary("verify", path, "--part", "box.off", "--cutter", "ball:10", "--tolerance", "0.005",
                                 "--scallop", "60", "--resolution", resolution, "-o", f"out-{resolution}")
            self.assertEqual(found["verdict"], "clean")
            self.assertEqual(found["max_gouge_mm"], 0)
            self.assertLess(found["gouge_bound_mm"], 0.006)

    def test_interrupt_leaves_nothing(self):
        path = self.file(passes(range(31)), "p.csv")
        self.file(plane())
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with subprocess.Popen([ENDMILL, "verify", path, "--part", "surface.json", "--cutter", "ball:10",
                                   "--resolution", "0.01", "-o", "out"], cwd=self.folder, stderr=subprocess.PIPE,
                                  stdout=subprocess.PIPE) as process:
                while not list(self.folder.glob(".endmill-*")) and process.poll() is None:
                    time.sleep(0.01)
                process.send_signal(number)
                process.communicate(timeout=600)
            self.assertEqual(process.returncode, 128 + number)
            self.assert_nothing_left("p.csv", "surface.json")

    def test_interrupt_while_a_file_is_written_leaves_nothing(self):
        rows = "".join(f"{k % 300 / 10},{k // 300 / 10},-1\n" for k in range(30000))
        path = self.file(COLUMNS + rows, "p.csv")
        with subprocess.Popen([ENDMILL, "verify", path, "--cutter", "ball:10", "--stock", "0,0,-5,30,10,0",
                               "--resolution", "0.5", "--engagement", "-o", "out"], cwd=self.folder,
                              stderr=subprocess.PIPE, stdout=subprocess.PIPE) as process:
            while process.poll() is None and not list(self.folder.glob(".endmill-*/.part-*")):
                time.sleep(0.001)
            process.send_signal(signal.SIGTERM)
            process.communicate(timeout=600)
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)
        self.assert_nothing_left("p.csv")


if __name__ == "__main__":
    unittest.main()
