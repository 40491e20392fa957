# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill post: the written programs, the defaults from a path and its summary, and refused input."""
import csv
import json
import os
import re
import resource
import shutil
import subprocess
import unittest

from program import ENDMILL, ROOT, SURFACES, ProgramTest, endmill, plane

PLAN = ["--mode", "paper", "--cutter", "ball:10", "--chord-tolerance", "0.5", "--scallop", "1", "--direction", "u"]
# A control without tool length compensation and dwell.
PLAIN = {"format": "endmill-control/1", "extension": ".ngc", "start": ["G90 G94 G17 G40 G49 G80 G54"],
         "end": ["M5", "M30"], "path_control": "tolerance", "tool_change": "M6"}
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
        self.assertEqual(lines[:9], ["%", "(endmill: plane, cutter ball:10, tips)",
                                     "G21 G90 G94 G17 G40 G49 G80 G54", "G64 P0.25", "T1 M6", "M3", "G4 P2",
                                     "G0 G43 H1 Z5.0000", "X0.0000 Y0.0000"])
        self.assertEqual(lines[9:11], ["G1 Z0.0000 F250", "X60.0000 F750"])
        self.assertEqual(lines[-4:], ["G0 Z5.0000", "M5", "M30", "%"])
        self.assertEqual((facts["points"], facts["lines"], facts["units"]), (12, len(lines), "mm"))
        self.assertEqual((facts["cutter"], facts["feed_mm_per_min"]), ("ball:10", 750))
        self.assertLess(facts["max_rounding_error_mm"], 1e-13)
        self.assertEqual(facts, json.loads((self.folder / "out/summary.json").read_text()))

    def test_tape_length_of_the_plan_is_that_of_a_plain_program(self):
        plain = self.file(PLAIN, "plain.json")
        for options, feed in (([], "1000"), (["--feed", "123.5"], "123.5")):
            path = self.planned(*options, "--order", "one-way", "--force")
            facts = self.summary("post", path, "--feed", feed, "--plunge-feed-mm-per-min", feed, "--control", plain,
                                 "-o", "out", "--force")
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
                         ["G61", "T2 M6", "S1000 M3", "G4 P2", "G0 G43 H2 Z5.0", "X0.0 Y0.0", "G1 Z0.0 F100",
                          "X1.0 F200", "G0 Z5.0", "M5", "M30", "%"])
        self.assertEqual((facts["plunge_feed_mm_per_min"], facts["feed_mm_per_min"]), (100, 200))
        self.summary("post", path, "--feed", "50", "--spindle-rpm", "300", "--tool-number", "7", "--cutter",
                     "flat:8", "--safe-height", "9", "--line-numbers", "--decimals", "0", "--dwell-s", "0", "-o",
                     "told")
        self.assertEqual(blocks(self.folder / "told/path.ngc"),
                         ["%", "(endmill: path, cutter flat:8, tips)", "N1 G21 G90 G94 G17 G40 G49 G80 G54", "N2 G61",
                          "N3 T7 M6", "N4 S300 M3", "N5 G0 G43 H7 Z9", "N6 X0 Y0", "N7 G1 Z0 F17", "N8 X1 F50",
                          "N9 G0 Z9", "N10 M5", "N11 M30", "%"])

    def test_comments_may_be_left_out(self):
        self.summary("post", self.file(TIPS, "p.csv"), "--feed", "9", "--comments", "no", "-o", "out")
        self.assertNotIn("(", (self.folder / "out/p.ngc").read_text())

    def test_apt_and_gcode_are_read_back(self):
        path = self.planned("--order", "one-way")
        self.summary("post", path, "--format", "apt", "--feed", "500", "-o", "apt")
        lines = blocks(self.folder / "apt/toolpath.apt")
        self.assertEqual(lines[:7], ["PARTNO/plane", "UNITS/MM", "CUTTER/10,5", "FEDRAT/166.6667,MMPM",
                                     "GOTO/0.0000,0.0000,0.0000", "FEDRAT/500,MMPM", "GOTO/60.0000,0.0000,0.0000"])
        self.assertEqual(lines[8:10], ["RAPID", "GOTO/0.0000,6.0000,5.0000"])
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
        self.assertIn("X10.0000 F100", blocks(self.folder / "p-post/p.ngc"))

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
        self.assertIn("G0 G43 H1 Z7.0000", blocks(self.folder / "out/p.ngc"))
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
        for option in (["--safe-height", "9"], ["--tool-number", "3"], ["--line-numbers"], ["--comments", "no"],
                       ["--control", "grbl"], ["--coolant", "mist"], ["--dwell-s", "1"], ["--lead-in", "ramp"],
                       ["--arcs"], ["--units", "inch"]):
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

    def test_a_program_of_somebody_else_stays(self):
        self.file("G0 Z5\n", "p.nc")
        self.summary("post", self.file(TIPS, "p.csv"), "--feed", "100", "-o", ".", "--force")
        self.assertTrue((self.folder / "p.nc").exists())

    def test_program_does_not_depend_on_the_number_of_threads(self):
        path = self.planned()
        texts = set()
        for threads in (1, 2, 8):
            self.summary("post", path, "--feed", "1", "--threads", threads, "-o", "out", "--force")
            texts.add((self.folder / "out/toolpath.ngc").read_bytes())
        self.assertEqual(len(texts), 1)


def moves_of(lines):
    """The straight moves of a program in mm, with modal words, by regular expressions: motion, tip, feed, speed."""
    place, motion, feed, speed, unit, moves = {}, None, None, None, 1, []
    for line in lines:
        words = re.findall(r"([A-Z])(-?\d+\.?\d*)", re.sub(r"\(.*\)", "", line))
        codes = {letter + number for letter, number in words}
        unit = 25.4 if "G20" in codes else unit
        motion = next((code for code in ("G0", "G1") if code in codes), motion)
        axes = [(letter, float(number) * unit) for letter, number in words if letter in "XYZ"]
        place.update(axes)
        feed = next((float(number) * unit for letter, number in words if letter == "F"), feed)
        speed = next((float(number) for letter, number in words if letter == "S"), speed)
        if axes:
            moves.append((motion, tuple(place.get(axis) for axis in "XYZ"), feed, speed))
    return moves


class Controls(ProgramTest):
    """Programs of each control, compared with the path by the parser above and by the reader of the program."""

    def setUp(self):
        super().setUp()
        rows = ["0,0,5,rapid,,6000", "0,0,-1,plunge,150.25,6000"]
        rows += [f"{0.7 * k:.4f},{k % 3},{-1 - 0.01 * k:.3f},cut,{800 + k},{6000 + k // 20}" for k in range(1, 60)]
        rows += ["41.3,2,5,rapid,,6002", "0,8,5,rapid,,6002", "0,8,-2,plunge,120,6002", "9,8,-2,cut,850,6002"]
        self.path = self.file("tip_x_mm,tip_y_mm,tip_z_mm,move,feed_mm_per_min,spindle_rpm\n" + "\n".join(rows) + "\n",
                              "p.csv")
        self.points = [row.split(",") for row in rows]

    def posted(self, control, name, *options):
        """The lines of the program, after a comparison of its moves with the path."""
        facts = self.summary("post", self.path, "--control", control, *options, "-o", "out", "--force")
        lines = blocks(self.folder / "out" / name)
        self.assertEqual(facts["file"], name)
        moves = moves_of(lines)[2:-1]
        self.assertEqual(len(moves), len(self.points) - 1)  # the first rapid repeats the way over it
        for (motion, tip, feed, speed), row in zip(moves, self.points[1:]):
            self.assertEqual(motion, "G0" if row[3] == "rapid" else "G1")
            for found, expected in zip(tip, row[:3]):
                self.assertAlmostEqual(found, float(expected), delta=facts["max_rounding_error_mm"] + 1e-9)
            if row[4]:
                self.assertAlmostEqual(feed, float(row[4]), delta=0.002)
            self.assertAlmostEqual(speed, float(row[5]), delta=0.5)
        self.assertLessEqual(facts["max_rounding_error_mm"], 0.0014)
        return lines

    def test_linuxcnc(self):
        lines = self.posted("linuxcnc", "p.ngc", "--coolant", "mist")
        self.assertEqual(lines[2:9], ["G21 G90 G94 G17 G40 G49 G80 G54", "G61", "T1 M6", "S6000 M3", "G4 P2", "M7",
                                      "G0 G43 H1 Z5.0000"])
        self.assertEqual(lines[-5:], ["G0 Z5.0000", "M9", "M5", "M30", "%"])

    def test_fanuc(self):
        lines = self.posted("fanuc", "p.nc", "--coolant", "flood")
        self.assertEqual(lines[:10],
                         ["%", "O0001 (ENDMILL: P, TIPS)", "G21 G90 G94 G17 G40 G49 G80 G54", "T1 M6", "S6000 M3",
                          "G4 P2000", "M8", "G0 X0.000 Y0.000", "G43 H1 Z5.000", "G1 Z-1.000 F150.25"])
        self.assertEqual(lines[-5:], ["G0 Z5.000", "M9", "M5", "M30", "%"])
        for line in lines[7:-4]:  # every length and feed has a point
            self.assertIsNone(re.search(r"[XYZF]-?\d+(?![\d.])", line), line)
        self.posted("fanuc", "p.nc", "--units", "inch")

    def test_grbl(self):
        lines = self.posted("grbl", "p.nc", "--line-numbers")
        self.assertEqual(lines[:6], ["(endmill: p, tips)", "N1 G21 G90 G94 G17 G40 G49 G80 G54", "N2 S6000 M3",
                                     "N3 G4 P2", "N4 G0 Z5.000", "N5 X0.000 Y0.000"])
        self.assertEqual([line.split()[1] for line in lines[-2:]], ["M5", "M30"])
        self.assertLess(max(map(len, lines)), 80)
        self.assertFalse(re.search(r"T\d|M6|G43|H\d|O\d|%", "\n".join(lines)))

    def test_control_of_a_file(self):
        file = self.file({**PLAIN, "name": "router", "extension": ".tap", "comments": "none", "line_end": "crlf"},
                         "router.json")
        facts = self.summary("post", self.path, "--control", file, "-o", "out")
        self.assertEqual((facts["control"], facts["file"]), ("router", "p.tap"))
        text = (self.folder / "out/p.tap").read_bytes()
        self.assertTrue(text.startswith(b"%\r\nG21 G90 G94 G17 G40 G49 G80 G54\r\nG61\r\nT1 M6\r\n"))

    def test_inches(self):
        lines = self.posted("linuxcnc", "p.ngc", "--units", "inch")
        self.assertTrue(lines[2].startswith("G20 G90"))
        self.assertIn("G1 Z-0.03937 F5.91535", lines)

    def test_programs_are_read_back(self):
        for control, name in (("linuxcnc", "p.ngc"), ("fanuc", "p.nc"), ("grbl", "p.nc")):
            for unit in ("mm", "inch"):
                self.summary("post", self.path, "--control", control, "--units", unit, "-o", "once", "--force")
                # The number of a program is not read by every version of the reader.
                text = (self.folder / "once" / name).read_text()
                self.file(text, "again.nc")
                self.assertEqual(endmill("info", "again.nc", cwd=self.folder).stderr, "")  # no warning
                facts = self.summary("post", "again.nc", "--control", control, "--units", unit, "--comments", "no",
                                     "-o", "twice", "--force")
                moves = [moves_of(blocks(self.folder / file)) for file in (f"once/{name}", f"twice/{facts['file']}")]
                self.assertEqual(moves[0], moves[1])

    def test_programs_have_the_verdict_of_the_path(self):
        part = self.file(plane(size=(30, 20), slope=0.3))
        done = endmill("plan", part, "--cutter", "ball:10", "--chord-tolerance", "0.05", "--scallop", "0.3",
                       "--direction", "u", "-o", "plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)

        def verdict(program):
            facts = self.summary("verify", program, "--part", part, "--cutter", "ball:10", "--tolerance", "0.05",
                                 "--scallop", "0.35", "-o", "seen", "--force")
            return facts["verdict"], facts["max_gouge_mm"], facts["max_scallop_mm"]

        expected = verdict("plan/toolpath.csv")
        self.assertEqual(expected[0], "clean")
        for control, name in (("linuxcnc", "toolpath.ngc"), ("fanuc", "toolpath.nc"), ("grbl", "toolpath.nc")):
            for unit in ("mm", "inch"):
                facts = self.summary("post", "plan/toolpath.csv", "--feed", "500", "--control", control, "--units",
                                     unit, "--arcs", "-o", "out", "--force")
                text = (self.folder / "out" / name).read_text()
                self.file(text, "program.nc")
                found = verdict("program.nc")
                self.assertEqual(found[0], expected[0])
                for number, number_of_path in zip(found[1:], expected[1:]):
                    self.assertAlmostEqual(number, number_of_path, delta=2 * facts["max_rounding_error_mm"] + 1e-9)

    def test_several_tools_need_a_tool_change(self):
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm,tool\n0,0,0,1\n9,0,0,1\n9,9,0,2\n", "tools.csv")
        self.summary("post", path, "--feed", "90", "--coolant", "flood", "-o", "out")
        lines = blocks(self.folder / "out/tools.ngc")
        at = lines.index("T2 M6")
        self.assertEqual(lines[at - 2:at + 6], ["G0 Z5.0000", "M9", "T2 M6", "M3", "G4 P2", "M8", "G0 G43 H2 Z5.0000",
                                                "X9.0000 Y0.0000"])
        self.assertEqual(lines[at + 6:at + 8], ["G1 Z0.0000 F30", "Y9.0000 F90"])
        done = endmill("post", path, "--feed", "90", "--control", "grbl", cwd=self.folder)
        self.assert_refused(done, 2, "from tool 1 to tool 2 at point 2", "grbl has no tool change")
        # Points of slopes and of rapid descents do not count.
        done = endmill("post", path, "--feed", "90", "--control", "grbl", "--lead-in", "ramp", "--approach-distance",
                       "1", cwd=self.folder)
        self.assert_refused(done, 2, "from tool 1 to tool 2 at point 2")

    def test_tools_of_a_table_are_named(self):
        apt = self.file("UNITS/MM\nFEDRAT/100,MMPM\nSPINDL/900,CLW\nLOADTL/1\nCUTTER/10\nRAPID\nGOTO/0,0,5\nGOTO/0,0,-1\n"
                        "GOTO/9,0,-1\nRAPID\nGOTO/9,0,5\nLOADTL/2\nCUTTER/6,3\nRAPID\nGOTO/0,0,6\nGOTO/0,0,-2\nFINI\n",
                        "p.apt")
        table = self.file("T3 D4\nT2 D6 ;ball\nT1 D10\n", "t.tbl")
        tools = ("--tools", table, "--tools-units", "mm")
        cutters = [{"tool": 1, "cutter": "flat:10"}, {"tool": 2, "cutter": "ball:6"}]
        for format_options in ([], ["--format", "apt"]):
            facts = self.summary("post", apt, *tools, *format_options, "-o", "out", "--force")
            self.assertEqual((facts["cutter"], facts["cutters"], facts["tools"]), (None, cutters, [1, 2]))
        facts = self.summary("info", apt, *tools)
        self.assertEqual((facts["cutter"], facts["cutters"]), (None, cutters))
        self.assertIn("tools 1 flat:10, 2 ball:6\n", endmill("info", apt, *tools).stdout)
        same = self.file("T2 D10\nT1 D10\n", "same.tbl")
        self.assertEqual(self.summary("info", apt, "--tools", same, "--tools-units", "mm")["cutter"], "flat:10")
        self.assertIsNone(self.summary("post", self.path, "-o", "plain")["cutters"])
        one = self.file("T1 D10\n", "one.tbl")
        for command in ("post", "info"):
            for status, words, options in ((3, "--tools FILE", ()), (2, "--tools-units", ("--tools", table)),
                                           (3, "no row with a cutter for tool 2", ("--tools", one, *tools[2:])),
                                           (2, "--cutter: has no effect with --tools", (*tools, "--cutter", "ball:6"))):
                self.assert_refused(endmill(command, apt, *options, cwd=self.folder), status, words)
        self.assert_refused(endmill("info", SURFACES / "saddle.json", *tools), 2, "--tools: has no effect with a part")

    def test_wrong_controls_are_refused(self):
        def refuse(status, *words, options):
            self.assert_refused(endmill("post", self.path, *options, cwd=self.folder), status, *words)

        refuse(2, '--control: found "fanux", which is no file', 'did you mean "fanuc"?', options=("--control", "fanux"))
        refuse(2, "--coolant mist: the control grbl has no mist coolant",
               options=("--control", "grbl", "--coolant", "mist"))
        tight = self.file({**PLAIN, "longest_line": 40}, "tight.json")
        refuse(2, "expected at most 40 for this control", options=("--control", tight, "--decimals", "9"))
        bad = self.file({**PLAIN, "tool_chnage": "M6"}, "bad.json")
        refuse(3, "bad.json", "tool_chnage", "tool_change", options=("--control", bad))
        bad = self.file({**PLAIN, "end": ["M30; rm -rf /"]}, "bad.json")
        refuse(3, "bad.json:/end/0", options=("--control", bad))
        none = self.file(PLAIN, "none.json")
        bad = self.file({**PLAIN, "start": ["G21 G90"]}, "bad.json")
        refuse(3, "bad.json:/start/0: G21", "--units writes G20 or G21", options=("--control", bad))
        for end in ([], ["M5"]):
            bad = self.file({**PLAIN, "end": end}, "bad.json")
            refuse(3, "bad.json:/end", "no block with M2 or M30", options=("--control", bad))
        refuse(2, "--tool-number: has no effect with the control grbl",
               options=("--control", "grbl", "--tool-number", "2"))
        refuse(2, "--tool-number: found", options=("--tool-number", "0"))
        refuse(2, "--approach-distance: found", options=("--approach-distance", "0"))
        refuse(2, "--approach-distance: has no effect", options=("--approach-distance", "1", "--format", "apt"))
        refuse(2, "--safe-height: found 1, and the path reaches 5 mm", options=("--safe-height", "1"))
        refuse(2, "none has no dwell", options=("--control", none, "--dwell-s", "1"))
        refuse(2, "none has no arcs", options=("--control", none, "--arcs"))
        for option in (("--coolant", "air"), ("--dwell-s", "-1"), ("--dwell-s", "601"), ("--units", "cm"),
                       ("--lead-in", "helix"), ("--ramp-angle-deg", "0"), ("--multax", "maybe")):
            refuse(2, option[0], options=option)
        refuse(2, "--ramp-angle-deg: has no effect", options=("--ramp-angle-deg", "5"))
        refuse(2, "--arc-fit-tolerance: has no effect", options=("--arc-fit-tolerance", "0.1"))
        refuse(2, "--multax: has no effect", options=("--multax", "yes"))
        refuse(2, "plunge feed 860 mm/min is above the cutting feed; expected at most 859",
               options=("--plunge-feed-mm-per-min", "860"))


class Motion(ProgramTest):
    """Feeds, slopes and arcs."""

    def test_feeds_of_the_path_pass_through(self):
        groove = self.file("tip_x_mm,tip_y_mm,tip_z_mm,move\n0,0,0,plunge\n10,0,0,cut\n20,0,-0.5,cut\n30,0,-1,cut\n",
                           "p.csv")
        done = endmill("feed", groove, "--material", ROOT / "datasets/materials/steel.json", "--cutter", "ball:10",
                       "--flutes", 2, "--max-force-n", 900, "--stock-top", 3,
                       "--allow-infeasible", "-o", "fed", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with (self.folder / "fed/toolpath.csv").open(encoding="utf-8") as file:
            expected = [row["feed_mm_per_min"] for row in csv.DictReader(file)]
        self.summary("post", self.folder / "fed/toolpath.csv", "-o", "out")
        moves = moves_of(blocks(self.folder / "out/toolpath.ngc"))[2:-1]
        self.assertEqual(len(moves), len(expected))
        for (_, _, feed, _), own in zip(moves, expected):
            self.assertAlmostEqual(feed, float(own), delta=5.1e-5)
        self.assertGreater(len({feed for _, _, feed, _ in moves}), 1)

    def test_descents_have_a_third_of_the_feed_or_the_given_one(self):
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm,move\n0,0,0,plunge\n9,0,0,cut\n9,0,5,rapid\n0,1,5,rapid\n"
                         "0,1,0,plunge\n9,1,0,cut\n", "p.csv")
        for options, plunge in (([], 300), (["--plunge-feed-mm-per-min", "120"], 120)):
            facts = self.summary("post", path, "--feed", "900", *options, "-o", "out", "--force")
            feeds = [feed for motion, _, feed, _ in moves_of(blocks(self.folder / "out/p.ngc")) if motion == "G1"]
            self.assertEqual(feeds, [plunge, 900, plunge, 900])
            self.assertEqual((facts["feed_mm_per_min"], facts["plunge_feed_mm_per_min"]), (900, plunge))
        self.summary("post", path, "--feed", "900", "--format", "apt", "-o", "apt")
        lines = blocks(self.folder / "apt/p.apt")
        self.assertEqual([line for line in lines if "FEDRAT" in line],
                         ["FEDRAT/300,MMPM", "FEDRAT/900,MMPM"] * 2)

    def test_slopes_leave_the_same_material(self):
        part = self.file(plane(size=(60, 30), slope=0.2))
        done = endmill("plan", part, "--cutter", "ball:10", "--chord-tolerance", "0.05", "--scallop", "0.3",
                       "--direction", "u", "--order", "one-way", "-o", "plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        verdicts = []
        for lead_in in ("straight", "ramp"):
            facts = self.summary("post", "plan/toolpath.csv", "--feed", "900", "--lead-in", lead_in, "-o", lead_in)
            verdict = self.summary("verify", f"{lead_in}/toolpath.ngc", "--part", part, "-o", f"{lead_in}-verified")
            verdicts.append(tuple(verdict[key] for key in ("verdict", "max_gouge_mm", "max_scallop_mm", "removed_mm3")))
        self.assertEqual(verdicts[0][0], "clean")
        self.assertEqual(verdicts[0][:3], verdicts[1][:3])
        self.assertAlmostEqual(verdicts[0][3], verdicts[1][3], delta=1e-6 * verdicts[0][3])
        self.assertGreater(facts["ramps"], 5)
        self.assertEqual(facts["straight_descents"], 0)
        # No descent is vertical any more.
        moves = moves_of(blocks(self.folder / "ramp/toolpath.ngc"))
        for before, after in zip(moves[2:], moves[3:]):
            if after[0] == "G1" and after[1][2] < before[1][2]:
                self.assertNotEqual(after[1][:2], before[1][:2])

    def test_rapid_approach_leaves_the_same_material_of_a_stock_near_the_part(self):
        part = self.file(plane(size=(60, 30), slope=0.2))
        done = endmill("plan", part, "--cutter", "ball:10", "--chord-tolerance", "0.05", "--scallop", "0.3",
                       "--direction", "u", "--order", "one-way", "-o", "plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        # The stock that the same path leaves 0.8 mm higher: nothing of it is higher above the path.
        with (self.folder / "plan/toolpath.csv").open(encoding="utf-8") as file:
            rows = [(row["tip_x_mm"], row["tip_y_mm"], float(row["tip_z_mm"]) + 0.8, row["move"])
                    for row in csv.DictReader(file)]
        self.file("tip_x_mm,tip_y_mm,tip_z_mm,move\n" + "".join("%s,%s,%.17g,%s\n" % row for row in rows), "rough.csv")
        self.summary("verify", "rough.csv", "--cutter", "ball:10", "--part", "none", "--stock", "-6,-6,-2,66,36,13",
                     "--resolution", "0.3", "--write-stock", "-o", "rough")
        found = []
        for name, options in (("slow", []), ("fast", ["--approach-distance", "1"]),
                              ("ramp", ["--approach-distance", "1", "--lead-in", "ramp"])):
            facts = self.summary("post", "plan/toolpath.csv", "--feed", "900", *options, "-o", name)
            verdict = self.summary("verify", f"{name}/toolpath.ngc", "--part", part, "--stock", "rough/stock.vti", "-o",
                                   f"{name}-verified")
            found.append((facts, verdict))
            self.assertEqual((verdict["verdict"], verdict["rapid_cuts"], facts["slanted_rapids"]), ("clean", 0, 0))
            for key in ("max_gouge_mm", "max_scallop_mm"):
                self.assertEqual(verdict[key], found[0][1][key])
            self.assertAlmostEqual(verdict["removed_mm3"], found[0][1]["removed_mm3"], delta=1e-6)
        descents = round(found[1][0]["plunge_mm"])  # 1 mm each
        self.assertGreater(descents, 5)
        self.assertAlmostEqual(found[1][0]["plunge_mm"], descents, delta=1e-6)
        self.assertGreater(found[0][0]["plunge_mm"], 5 * descents)
        self.assertEqual(found[2][0]["ramps"], descents)
        # In a block the same descents are rapids into material.
        verdict = self.summary("verify", "fast/toolpath.ngc", "--part", part, "--stock", "-6,-6,-2,66,36,13", "-o",
                               "block", status=1)
        self.assertGreater(verdict["rapid_cuts"], 0)

    def test_summary_has_the_totals_of_the_written_program(self):
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm,move,tool\n0,0,0,plunge,1\n40,0,0,cut,1\n40,30,0,cut,2\n"
                         "40,30,9,retract,2\n0,30,9,rapid,2\n0,30,-1,plunge,2\n0,60,-1,cut,2\n", "p.csv")
        keys = ("cut_mm", "plunge_mm", "link_mm", "rapid_mm", "time_min", "tools", "min_mm", "max_mm")
        for options in ([], ["--approach-distance", "2"], ["--control", "fanuc"],
                        ["--units", "inch", "--decimals", "6"]):
            posted = self.summary("post", path, "--feed", "300", "--safe-height", "12", *options, "-o", "out",
                                  "--force")
            read = self.summary("info", self.folder / "out" / posted["file"])
            for key in keys:
                for value, expected in zip(*(found[key] if isinstance(found[key], list) else [found[key]]
                                             for found in (posted, read))):
                    self.assertAlmostEqual(value, expected, delta=1e-4)
        ramped = self.summary("post", path, "--feed", "300", "--lead-in", "ramp", "-o", "ramped")
        read = self.summary("info", "ramped/p.ngc")
        for total in (("cut_mm", "plunge_mm", "link_mm"), ("rapid_mm",), ("time_min",)):
            self.assertAlmostEqual(sum(ramped[key] for key in total), sum(read[key] for key in total), delta=1e-3)

    def test_arcs_have_the_verdict_of_the_path(self):
        part = SURFACES / "cylinder.json"
        done = endmill("plan", part, "--cutter", "ball:10", "--chord-tolerance", "0.02", "--scallop", "0.05",
                       "--direction", "v", "-o", "plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        verdicts, lines = [], []
        for options in ([], ["--arcs"]):
            facts = self.summary("post", "plan/toolpath.csv", "--feed", "900", *options, "-o", "out", "--force")
            verdicts.append(self.summary("verify", "out/toolpath.ngc", "--part", part, "-o", "seen",
                                         "--force")["verdict"])
            lines.append(facts["lines"])
        self.assertEqual(verdicts, ["clean", "clean"])
        self.assertGreater(facts["arcs"], 20)
        self.assertLess(lines[1], lines[0] / 5)
        self.assertLessEqual(facts["max_arc_error_mm"], 0.021)

    def test_arcs_of_a_program_come_back(self):
        # A quarter circle, a half one (two arcs: below half a turn) and three quarters (two arcs), the last in G18.
        program = self.file("%\nG21 G90 G17 G94\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX40 F400\n"
                            "G2 X60 Y-20 I0 J-20\nG1 Y-40\nG3 X100 I20\nG18 G2 X120 Z-21 I0 K-20\nG0 Z5\nM30\n%\n",
                            "p.ngc")
        for options in ([], ["--arc-tolerance", "0.01"]):
            facts = self.summary("post", program, "--arcs", *options, "-o", "out", "--force")
            self.assertEqual(facts["arcs"], 5)
            self.assertLessEqual(facts["lines"], 22)
            words = "\n".join(blocks(self.folder / "out/p.ngc"))
            self.assertRegex(words, r"\nG17 G2 X60\.0000 Y-20\.0000 I-?0\.000\d J-(20\.000|19\.999)\d\n")
            self.assertEqual(len(re.findall(r"^G1[789] ", words, re.MULTILINE)), 2)

    def test_one_sided_path_needs_a_tolerance_of_arcs(self):
        path = self.file(TIPS, "p.csv")
        self.file({"inner_tolerance_mm": 0, "outer_tolerance_mm": 0.1}, "summary.json")
        done = endmill("post", path, "--feed", "9", "--arcs", cwd=self.folder)
        self.assert_refused(done, 2, "--arcs: the path may deviate to one side only", "--arc-fit-tolerance")
        self.summary("post", path, "--feed", "9", "--arcs", "--arc-fit-tolerance", "0.01", "-o", "out")

    def test_multax_is_written_with_every_axis(self):
        path = self.file(TIPS, "p.csv")
        self.summary("post", path, "--feed", "9", "--format", "apt", "--multax", "yes", "-o", "out")
        lines = blocks(self.folder / "out/p.apt")
        self.assertEqual(lines[:5], ["PARTNO/p", "UNITS/MM", "MULTAX", "FEDRAT/3,MMPM",
                                     "GOTO/0.0000,0.0000,0.0000,0,0,1"])

    def test_report_has_at_most_five_lines(self):
        path = self.file(TIPS, "p.csv")
        done = endmill("post", path, "--feed", "90", "--spindle-rpm", "6000", "-o", "out", cwd=self.folder)
        lines = done.stdout.splitlines()
        self.assertLessEqual(len(lines), 5)
        self.assertEqual(lines[0], "p: p.ngc, G-code for LinuxCNC, 16 lines, within 0.00001 mm of the path")
        self.assertRegex(lines[1], r"^  path        cuts 3\d\.\d+ mm, plunges 8 mm, links 0 mm, rapids 5 mm; 0\.\d")
        self.assertIn("  feed        cut 90, plunge 30 mm/min; 6000 rpm", lines)

    def test_long_descents_name_the_option_that_shortens_them(self):
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm,move\n0,0,0,plunge\n0,9,0,cut\n", "p.csv")
        run = ("post", path, "--feed", "90", "--force", "-o", "out")
        # 20 mm down at 30 mm/min, 9 mm at 90 mm/min.
        lines = endmill(*run, "--safe-height", "20", cwd=self.folder).stdout.splitlines()
        self.assertEqual(len(lines), 5)
        self.assertIn("  descents    0.667 of 0.767 min; --approach-distance MM makes them rapid down to MM above "
                      "the cut", lines)
        for options in (["--safe-height", "20", "--approach-distance", "19"], ["--safe-height", "2"],
                        ["--format", "apt"]):
            done = endmill(*run, *options, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("descents", done.stdout)


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
                                   ("G21\n#1=5\nG0 X#1\n", "p.ngc", "p.ngc:2", "--interpreter linuxcnc"),
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
        self.refuse(TIPS, 2, "p.csv: point 0 of the path has no feed", "--feed", options=())
        self.refuse(TIPS, 2, "feed of 0.4 mm/min, which rounds to 0",
                    options=("--feed", "0.4", "--plunge-feed-mm-per-min", "0.4", "--decimals", "0"))
        for feed in ("0", "-1", "nan", "inf", "fast", "1e999"):
            self.refuse(TIPS, 2, "--feed", options=("--feed", feed))

    def test_wrong_command_lines_are_refused(self):
        for options in (("--decimals", "10"), ("--decimals", "-1"), ("--format", "iso"), ("--comments", "maybe"),
                        ("--tool-number", "1.5"), ("--spindle-rpm", "-1"), ("--cutter", "ball"), ("--unknown",)):
            self.refuse(TIPS, 2, options[0], options=("--feed", "1", *options))
        self.refuse(TIPS, 2, "--safe-height: found 2.9, and the path reaches 3 mm; expected no less",
                    options=("--feed", "1", "--safe-height", "2.9"))

    def test_cutter_out_of_range_is_refused_with_the_range(self):
        self.refuse(TIPS, 2, 'found "ball:0"; expected a diameter above 0 mm', options=("--cutter", "ball:0"))
        self.refuse(TIPS, 2, 'found "bull:10:6"; expected a corner radius from 0 to 5 mm',
                    options=("--cutter", "bull:10:6"))

    def test_program_with_the_spindle_reversed_is_refused(self):
        head = "G21 G90 G94\nS900 M4\nG0 X0 Y0 Z5\n"
        for options in ([], ["--format", "apt"]):
            self.refuse(head + "G1 Z0 F60\nM2\n", 3, "p.ngc: the spindle turns counterclockwise (M4) on the move to "
                        "point 1", "M3", name="p.ngc", options=options)
        self.file(head + "M3\nG1 Z0 F60\nM2\n", "q.ngc")
        self.summary("post", "q.ngc", "-o", "out")

    def test_tool_zero_is_refused(self):
        self.refuse("tip_x_mm,tip_y_mm,tip_z_mm,tool\n0,0,0,0\n9,0,0,0\n", 2, "point 0 of the path has tool 0",
                    "--tool-number")

    def test_rapids_after_the_last_tool_is_put_away(self):
        program = self.file("G21 G90\nT0 M6\nG0 X0 Y0 Z9\nT3 M6\nS100 M3\nG0 Z5\nG1 Z-1 F100\nX5\nG0 Z5\n"
                            "T0 M6\nG0 Z9\nM2\n", "p.ngc")
        facts = self.summary("post", program, "-o", "out")
        self.assertEqual(facts["tools"], [3])
        shutil.rmtree(self.folder / "out")
        self.refuse("G21 G90\nT0 M6\nG0 X0 Y0 Z9\nG1 Z1 F9\nM2\n", 2, "point 0 of the path has tool 0",
                    name="p.ngc")

    def test_lines_that_end_with_a_carriage_return_are_refused(self):
        text = "G21 G90\rG0 X0 Y0 Z5 ; start\rG1 Z-1 F100\rM2\r"
        for options in ([], ["--interpreter", "linuxcnc"]):
            self.refuse(text, 3, "p.ngc:1: a carriage return without a line feed", name="p.ngc", options=options)

    def test_tilted_axis_is_refused(self):
        header = "axis_x,axis_y,axis_z," + TIPS.splitlines()[0]
        self.refuse(f"{header}\n0,0,1,0,0,0\n0,0.6,0.8,1,0,0\n", 2,
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
