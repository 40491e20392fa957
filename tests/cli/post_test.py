# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill post: the written programs, the defaults from a path and its summary, and refused input."""
import csv
import json
import os
import re
import resource
import subprocess
import unittest

from program import ENDMILL, ProgramTest, endmill, plane

PLAN = ["--mode", "paper", "--cutter", "ball:10", "--chord-tolerance", "0.5", "--scallop", "1", "--direction", "u"]
TIPS = "tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n10,0,-0.00001\n10,20.5,3\n"


def blocks(path):
    return path.read_text(encoding="ascii").splitlines()


class Post(ProgramTest):
    def planned(self, *options):
        """Plans the tool path of a plane and returns its file."""
        done = endmill("plan", self.file(plane()), *PLAN, *options, "-o", "plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / "plan/toolpath.csv"

    def test_cutter_tolerance_and_feed_come_from_the_planned_path(self):
        facts = self.summary("post", self.planned("--feed", "750"), "-o", "out")
        lines = blocks(self.folder / "out/toolpath.ngc")
        self.assertEqual(lines[:8], ["%", "(endmill: plane, cutter ball:10, tips)",
                                     "G21 G90 G94 G17 G40 G49 G80 G54", "G64 P0.25", "T1 M6", "M3",
                                     "G0 Z5.0000", "X0.0000 Y0.0000"])
        self.assertEqual(lines[8:10], ["G1 Z0.0000 F750", "X60.0000"])
        self.assertEqual(lines[-4:], ["G0 Z5.0000", "M5", "M30", "%"])
        self.assertEqual((facts["points"], facts["lines"], facts["units"]), (12, len(lines), "mm"))
        self.assertEqual((facts["cutter"], facts["feed_mm_per_min"]), ("ball:10", 750))
        self.assertLess(facts["max_rounding_error_mm"], 1e-13)
        self.assertEqual(facts, json.loads((self.folder / "out/summary.json").read_text()))

    def test_tape_length_is_that_of_the_plan(self):
        for options, feed in (([], "1000"), (["--feed", "123.5"], "123.5")):
            path = self.planned(*options, "--order", "one-way", "--force")
            facts = self.summary("post", path, "--feed", feed, "-o", "out", "--force")
            size = (self.folder / "out/toolpath.ngc").stat().st_size
            self.assertEqual(facts["bytes"], size)
            self.assertAlmostEqual(facts["tape_length_m"], 0.00254 * size, delta=1e-12)
            plan = json.loads((self.folder / "plan/summary.json").read_text())
            self.assertEqual(plan["tape_length_m"], facts["tape_length_m"])

    def test_options_override_the_path(self):
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm,feed_mm_per_min,spindle_rpm,tool\n"
                         "0,0,0,100,1000,2\n1,0,0,200,1000,2\n", "path.csv")
        facts = self.summary("post", path, "-o", "own", "--decimals", "1")
        self.assertEqual(blocks(self.folder / "own/path.ngc")[3:],
                         ["G64", "T2 M6", "S1000 M3", "G0 Z5.0", "X0.0 Y0.0", "G1 Z0.0 F100", "X1.0 F200",
                          "G0 Z5.0", "M5", "M30", "%"])
        self.assertEqual((facts["min_feed_mm_per_min"], facts["max_feed_mm_per_min"]), (100, 200))
        self.summary("post", path, "--feed", "50", "--spindle-rpm", "300", "--tool-number", "7", "--cutter",
                     "flat:8", "--safe-height", "9", "--line-numbers", "--decimals", "0", "-o", "told")
        self.assertEqual(blocks(self.folder / "told/path.ngc"),
                         ["%", "(endmill: path, cutter flat:8, tips)", "N1 G21 G90 G94 G17 G40 G49 G80 G54", "N2 G64",
                          "N3 T7 M6", "N4 S300 M3", "N5 G0 Z9", "N6 X0 Y0", "N7 G1 Z0 F50", "N8 X1", "N9 G0 Z9",
                          "N10 M5", "N11 M30", "%"])

    def test_comments_may_be_left_out(self):
        self.summary("post", self.file(TIPS, "p.csv"), "--feed", "9", "--comments", "no", "-o", "out")
        self.assertNotIn("(", (self.folder / "out/p.ngc").read_text())

    def test_apt_and_gcode_are_read_back(self):
        path = self.planned("--order", "one-way")
        self.summary("post", path, "--format", "apt", "--feed", "500", "-o", "apt")
        lines = blocks(self.folder / "apt/toolpath.apt")
        self.assertEqual(lines[:6], ["PARTNO/plane", "UNITS/MM", "CUTTER/10,5", "FEDRAT/500,MMPM",
                                     "GOTO/0.0000,0.0000,0.0000", "GOTO/60.0000,0.0000,0.0000"])
        self.assertEqual(lines[7:9], ["RAPID", "GOTO/0.0000,6.0000,5.0000"])
        self.summary("post", path, "--feed", "500", "-o", "direct")
        self.summary("post", self.folder / "apt/toolpath.apt", "-o", "again")
        direct, again = (blocks(self.folder / f"{name}/toolpath.ngc") for name in ("direct", "again"))
        self.assertEqual(direct, again)
        self.summary("post", self.folder / "direct/toolpath.ngc", "--format", "apt", "-o", "back")
        back = blocks(self.folder / "back/toolpath.apt")
        self.assertEqual([line for line in lines if line.startswith("GOTO")],
                         [line for line in back if line.startswith("GOTO")][1:-1])

    def test_path_of_tips_only_gets_reported_defaults(self):
        done = endmill("post", self.file(TIPS, "p.csv"), "--feed", "100", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("every move is assumed to be a cut", done.stderr)
        self.assertIn("assumed to be +z", done.stderr)
        self.assertIn("M3 has no S word; expected --spindle-rpm", done.stderr)
        self.assertIn("X10.0000", blocks(self.folder / "p-post/p.ngc"))

    def test_name_of_a_summary_stays_inside_its_comment(self):
        path = self.file(TIPS, "p.csv")
        self.file({"name": "a)\nG0 Z-100 (\x1b[31m"}, "summary.json")
        self.summary("post", path, "--feed", "100", "-o", "out")
        self.assertEqual(blocks(self.folder / "out/p.ngc")[1], "(endmill: aG0 Z-100 [31m, tips)")

    def test_coarse_rounding_gives_a_warning(self):
        path = self.file(TIPS, "p.csv")
        self.file({"chord_tolerance_mm": 0.01}, "summary.json")
        done = endmill("post", path, "--feed", "100", "--decimals", "0", "-o", "out", cwd=self.folder)
        self.assertIn("rounded by up to 0.5 mm, with a tolerance of 0.01 mm", done.stderr)

    def test_reading_options_apply_to_a_program(self):
        program = "G21 F9\nG0 X0 Y0 Z5\n/G1 Y7\nG2 X10 I5\nM2\n"
        path = self.file(program, "p.ngc")
        told = self.summary("post", path, "--cutter", "ball:6", "--programmed-point", "centre", "--block-delete",
                            "--arc-tolerance", "0.5", "-o", "out")
        # acos(1 - 0.5 / 5) = 0.451, so a half circle has four chords. The tip is 3 mm below the centre.
        self.assertEqual(told["points"], 5)
        self.assertIn("G1 X1.4645 Y3.5355 F9", blocks(self.folder / "out/p.ngc"))
        self.assertIn("G0 Z7.0000", blocks(self.folder / "out/p.ngc"))
        self.assertGreater(self.summary("post", path, "-o", "plain")["points"], 60)
        self.assert_refused(endmill("post", path, "--programmed-point", "centre", cwd=self.folder), 2,
                            "--programmed-point centre: the cutter is not known; expected --cutter")
        self.file({"cutter": "ball:6"}, "summary.json")
        facts = self.summary("post", path, "--programmed-point", "centre", "-o", "known")
        self.assertEqual(facts["safe_height_mm"], 7)

    def test_reading_options_without_effect_are_refused(self):
        apt = self.file("UNITS/MM\nFEDRAT/100,MMPM\nGOTO/0,0,0\nGOTO/1,0,0\nFINI\n", "p.apt")
        csv = self.file(TIPS, "p.csv")
        canonical = self.file("12 N30 USE_LENGTH_UNITS(CANON_UNITS_MM)\n", "p.canon")
        for path, kind in ((apt, "APT CL data"), (csv, "a tool path (CSV)"), (canonical, "the output of rs274 -g")):
            for option in (["--arc-tolerance", "0.5"], ["--programmed-point", "centre"], ["--block-delete"]):
                if path == canonical and option != ["--block-delete"]:
                    continue
                done = endmill("post", path, "--cutter", "ball:6", "--feed", "9", *option, cwd=self.folder)
                self.assert_refused(done, 2, f"{' '.join(option[:1])}", f"is {kind}", "expects G-code")
        self.summary("post", csv, "--feed", "9", "--programmed-point", "tip", "-o", "out")
        for option in (["--safe-height", "9"], ["--tool-number", "3"], ["--line-numbers"], ["--comments", "no"]):
            done = endmill("post", csv, "--feed", "9", "--format", "apt", *option, cwd=self.folder)
            self.assert_refused(done, 2, option[0], "expected --format gcode")

    def test_results_are_named_after_the_path_or_its_plan(self):
        for place, name in (("p.csv", "p"), ("a/p.csv", "p"), ("toolpath.csv", "toolpath"),
                            ("./toolpath.csv", "toolpath"), ("plate/toolpath.csv", "plate"), ("u/toolpath.csv", "u"),
                            ("plate/u/toolpath.csv", "plate-u"), ("plate/v/../v/toolpath.csv", "plate-v")):
            (self.folder / place).parent.mkdir(parents=True, exist_ok=True)
            self.file(TIPS, place)
            done = endmill("post", place, "--feed", "9", "--force", cwd=self.folder)
            self.assertIn(f"written to ./{name}-post\n", done.stdout)
            self.assertTrue((self.folder / f"{name}-post/summary.json").is_file())

    def test_rewritten_program_keeps_its_start_height(self):
        self.summary("post", self.planned("--order", "one-way"), "--feed", "500", "-o", "1")
        first = blocks(self.folder / "1/toolpath.ngc")
        for number in range(2, 4):
            self.summary("post", self.folder / f"{number - 1}/toolpath.ngc", "--format", "apt", "-o", f"apt{number}")
            self.summary("post", self.folder / f"apt{number}/toolpath.apt", "-o", number)
            self.assertEqual(blocks(self.folder / f"{number}/toolpath.ngc"), first)

    def test_another_format_replaces_the_earlier_program(self):
        path = self.file(TIPS, "p.csv")
        self.summary("post", path, "--feed", "100", "-o", "out")
        self.summary("post", path, "--feed", "100", "-o", "out", "--format", "apt", "--force")
        self.assertEqual(sorted(file.name for file in (self.folder / "out").iterdir()), ["p.apt", "summary.json"])

    def test_program_does_not_depend_on_the_number_of_threads(self):
        path = self.planned()
        texts = set()
        for threads in (1, 2, 8):
            self.summary("post", path, "--feed", "1", "--threads", threads, "-o", "out", "--force")
            texts.add((self.folder / "out/toolpath.ngc").read_bytes())
        self.assertEqual(len(texts), 1)


class BadInput(ProgramTest):
    def refuse(self, content, status, *words, name="p.csv", options=("--feed", "100")):
        path = self.file(content, name)
        self.assert_refused(endmill("post", path, *options, cwd=self.folder), status, *words)
        self.assert_nothing_left(name)
        path.unlink()

    def test_bad_tables_are_refused(self):
        self.refuse("tip_x,tip_y_mm,tip_z_mm\n0,0,0\n", 3, 'p.csv:1: column "tip_x" without its unit')
        self.refuse("tip_x_mm,tip_y_mm\n0,0\n", 3, 'p.csv:1: no column "tip_z_mm"')
        self.refuse(TIPS + "1,2\n", 3, "p.csv:5: row has 2 cells; expected 3")
        self.refuse(TIPS + "1,,2\n", 3, "p.csv:5: tip_y_mm is empty; expected a number")
        self.refuse(TIPS + "1,NaN,2\n", 3, 'p.csv:5: tip_y_mm is "NaN"; expected a number')
        self.refuse(TIPS + "1,2,1e7\n", 3, "p.csv:5: tip_z_mm is 1e+07; expected at most")
        self.refuse("move," + TIPS.replace("\n", "\ndrill,").removesuffix("drill,").replace("drill,tip", "tip"), 3,
                    'p.csv:2: move is "drill"; expected cut')
        self.refuse("feed_mm_per_min,tip_x_mm,tip_y_mm,tip_z_mm\n-1,0,0,0\n", 3, 'p.csv:2: feed_mm_per_min is "-1"')
        self.refuse("tip_x_mm,tip_y_mm,tip_z_mm\n", 3, "p.csv:1: no row")

    def test_bad_programs_are_refused(self):
        for text, name, *words in (("G21\nG1 X1 Y1 Z1\n", "p.ngc", "p.ngc:2"),
                                   ("G21\n#1=5\nG0 X#1\n", "p.ngc", "p.ngc:2", "rs274 -g"),
                                   ("UNITS/MM\nGODLTA/1,2,3\n", "p.apt", "p.apt:2: statement"),
                                   ("G21\n(" + "x" * 2**20 + ")\n", "p.ngc", "p.ngc:2: line is longer than 1 MiB")):
            self.refuse(text, 3, *words, name=name)

    def test_other_files_are_refused(self):
        self.refuse("solid x\nfacet normal 0 0 1\n", 3, "content looks like STL; expected a tool path", name="p.stl")
        self.refuse(plane(), 3, "content looks like JSON", name="p.json")
        self.refuse(b"\x1f\x8b\x08\x00", 3, "compressed", name="p.csv.gz")
        self.refuse(b"G1\x00\x01\x02", 3, "content is binary", name="p.bin")
        self.refuse("", 3, "file is empty")
        self.refuse(" \n", 3, "file is empty")
        self.refuse("hello\n", 3, "content is not recognised", name="p.txt")
        self.assert_refused(endmill("post", self.folder, "--feed", "1"), 3, "is a directory")
        self.assert_refused(endmill("post", self.folder / "none.csv", "--feed", "1"), 3, "No such file")

    def test_bad_summary_beside_the_path_is_refused(self):
        path = self.file(TIPS, "p.csv")
        self.file({"cutter": "bal:10"}, "summary.json")
        done = endmill("post", path, "--feed", "1", cwd=self.folder)
        self.assert_refused(done, 3, 'summary.json:/cutter: "bal:10"; expected ball:DIAMETER')

    def test_missing_or_bad_feed_is_refused(self):
        self.refuse(TIPS, 2, "point 0 of the path has no feed", "--feed", options=())
        self.refuse(TIPS, 2, "feed of 0.4 mm/min, which rounds to 0", options=("--feed", "0.4", "--decimals", "0"))
        for feed in ("0", "-1", "nan", "inf", "fast", "1e999"):
            self.refuse(TIPS, 2, "--feed", options=("--feed", feed))

    def test_wrong_command_lines_are_refused(self):
        for options in (("--decimals", "10"), ("--decimals", "-1"), ("--format", "iso"), ("--comments", "maybe"),
                        ("--tool-number", "1.5"), ("--spindle-rpm", "-1"), ("--cutter", "ball"), ("--unknown",)):
            self.refuse(TIPS, 2, options[0], options=("--feed", "1", *options))
        self.refuse(TIPS, 2, "safe height 2.9 mm lies below the path, which reaches 3 mm",
                    options=("--feed", "1", "--safe-height", "2.9"))

    def test_cutter_out_of_range_is_refused_with_the_range(self):
        self.refuse(TIPS, 2, 'found "ball:0"; expected a diameter above 0 mm', options=("--cutter", "ball:0"))
        self.refuse(TIPS, 2, 'found "bull:10:6"; expected a corner radius from 0 to 5 mm',
                    options=("--cutter", "bull:10:6"))

    def test_tilted_axis_is_refused(self):
        header = "axis_x,axis_y,axis_z," + TIPS.splitlines()[0]
        self.refuse(f"{header}\n0,0,1,0,0,0\n0,0.6,0.8,1,0,0\n", 4,
                    "p.csv: the axis at point 1 of the path is 0, 0.6, 0.8, and a 3-axis machine cannot")
        path = self.file(f"{header}\n0,0.6,0.8,1,0,0\n", "p.csv")
        self.summary("post", path, "--feed", "1", "--format", "apt", "-o", "out")
        self.assertIn("GOTO/1.0000,0.0000,0.0000,0,0.6,0.8", blocks(self.folder / "out/p.apt"))

    def test_output_errors_are_reported(self):
        path = self.file(TIPS, "p.csv")
        self.assert_refused(endmill("post", path, "--feed", "1", "-o", self.folder), 2, "not empty")
        self.assert_refused(endmill("post", path, "--feed", "1", "-o", path), 2, "p.csv")
        self.summary("post", path, "--feed", "1", "-o", "out")
        posted = self.folder / "out/p.ngc"
        self.assert_refused(endmill("post", posted, "-o", self.folder / "out", "--force"), 2, "p.ngc")
        self.assert_refused(endmill("post", path, "--feed", "1", "-o", "/proc/x"), 5, "/proc/x")

    def test_full_disk_leaves_nothing(self):
        rows = "".join(f"{k},{k % 7}.125,0\n" for k in range(20000))
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n" + rows, "p.csv")
        done = subprocess.run([ENDMILL, "post", str(path), "--feed", "1"], capture_output=True, text=True, check=False,
                              cwd=self.folder,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (50000, 50000)))
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assert_nothing_left("p.csv")

    def test_program_too_large_for_the_memory_is_refused(self):
        rows = "0,0,0\n" * 100000
        self.refuse("tip_x_mm,tip_y_mm,tip_z_mm\n" + rows, 6, "memory",
                    options=("--feed", "1", "--max-memory", "0.001"))


if __name__ == "__main__":
    unittest.main()
