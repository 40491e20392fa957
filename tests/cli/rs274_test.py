# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs of post, checked by LinuxCNC's interpreter. rs274 must accept them, and its canonical moves,
read by our reader, must be the path. scripts/setup.sh installs rs274; without it these tests fail."""
import csv
import math
import re
import subprocess
import unittest

from program import ROOT, SURFACES, ProgramTest, endmill

# The tool table of rs274 is always in inches.
TOOLS = "T1 P1 D0.3937 Z0.0 ;ball\nT12 P12 D0.3937 Z1.0 ;another\n"
INTERPRETER_ROUNDING = 5e-5  # it prints four decimals
ROUNDING_OF_DOUBLES = 1e-9
MOVE = re.compile(r"(STRAIGHT_TRAVERSE|STRAIGHT_FEED)\((\S+), (\S+), (\S+),")
FINE = ["--chord-tolerance", "0.05", "--scallop", "0.5"]
COARSE = ["--strategy", "iso", "--cutter", "ball:15", "--chord-tolerance", "0.5", "--scallop", "0.5"]


def path_of(table):
    """The tips of a tool path file, and whether each move to them is a rapid."""
    with open(table, newline="", encoding="ascii") as file:
        return [(tuple(float(row[f"tip_{c}_mm"]) for c in "xyz"), row["move"] == "rapid")
                for row in csv.DictReader(file)]


def path_of_apt(file):
    """The same for APT CL data."""
    points, is_rapid = [], False
    for line in file.read_text(encoding="ascii").splitlines():
        if line.startswith("GOTO/"):
            points.append((tuple(map(float, line.removeprefix("GOTO/").split(","))), is_rapid))
        is_rapid = line == "RAPID"
    return points


class Interpreter(ProgramTest):
    def interpret(self, program):
        """Runs rs274, which writes its canonical moves into canonical.txt. Returns the finished process."""
        tools = self.file(TOOLS, "tools.tbl")
        try:
            return subprocess.run(["rs274", "-g", "-t", tools, program, "canonical.txt"], cwd=self.folder,
                                  capture_output=True, text=True, check=False, timeout=600, stdin=subprocess.DEVNULL)
        except FileNotFoundError:
            self.fail("rs274 is missing: scripts/setup.sh installs it (Debian package linuxcnc-uspace)")

    def judge(self, plan_options, post_options=(), decimals=4, surface="net_rot24_7D"):
        """Plans and posts a path, runs rs274 on the program, and compares its moves with the path."""
        plan, out, back = (self.folder / name for name in ("plan", "out", "back"))
        done = endmill("plan", SURFACES / f"{surface}.json", "--mode", "paper", *plan_options, "--direction", "u", "-o", plan,
                       "--force")
        self.assertIn(done.returncode, (0, 1), done.stderr)  # the paper's path may gouge
        self.summary("post", plan / "toolpath.csv", "--feed", "812.5", "--decimals", decimals, *post_options, "-o",
                     out, "--force")
        done = self.interpret(out / "toolpath.ngc")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        canonical = self.folder / "canonical.txt"
        facts = self.summary("post", canonical, "--format", "apt", "--decimals", 6, "-o", back, "--force")
        self.assertEqual(facts["position_error_mm"], INTERPRETER_ROUNDING)
        self.assertEqual(facts["feed_mm_per_min"], 812.5)

        path, read = path_of(plan / "toolpath.csv"), path_of_apt(back / "canonical.apt")
        self.assertEqual(len(read), len(path) + 3)
        self.compare(path, read[2:-1], 0.5 * 10**-decimals + INTERPRETER_ROUNDING + ROUNDING_OF_DOUBLES)
        # Our reader must read the same lines without a remark.
        lines = [((float(x), float(y), float(z)), kind == "STRAIGHT_TRAVERSE")
                 for kind, x, y, z in MOVE.findall(canonical.read_text(encoding="utf-8"))]
        self.compare(lines, read, ROUNDING_OF_DOUBLES)
        return canonical.read_text(encoding="utf-8")

    def compare(self, expected, found, tolerance):
        self.assertEqual(len(found), len(expected))
        for (tip, is_rapid), (found_tip, found_rapid) in zip(expected, found):
            self.assertEqual(is_rapid, found_rapid, tip)
            self.assertLessEqual(max(abs(a - b) for a, b in zip(tip, found_tip)), tolerance, tip)

    def test_zigzag_over_the_default_net(self):
        said = self.judge(COARSE)
        self.assertTrue("SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, 0.250000)" in said)
        self.assertTrue("USE_LENGTH_UNITS(CANON_UNITS_MM)" in said)

    def test_one_way_over_the_default_net(self):
        self.judge([*COARSE, "--order", "one-way"], ["--line-numbers"])

    def test_decimals_bound_the_rounding(self):
        for decimals in (2, 3, 6, 9):
            self.judge(COARSE, ["--line-numbers"], decimals)

    def test_program_without_decimals_is_accepted(self):
        plan = self.file("tip_x_mm,tip_y_mm,tip_z_mm,move\n1,2,0,plunge\n3,4,-5,cut\n3,4,1,rapid\n", "p.csv")
        self.summary("post", plan, "--feed", "10", "--decimals", "0", "-o", "out")
        self.assertEqual(self.interpret(self.folder / "out/p.ngc").returncode, 0)

    def test_paths_on_other_surfaces_are_accepted(self):
        self.judge([*FINE, "--cutter", "ball:6"], surface="torus")
        self.judge([*FINE, "--cutter", "ball:6", "--order", "one-way"], ["--comments", "no"], surface="valley")

    def test_spindle_speed_and_tool_are_set(self):
        said = self.judge(COARSE, ["--spindle-rpm", "12345.5", "--tool-number", "12"])
        self.assertTrue("SET_SPINDLE_SPEED(0, 12345.5000)" in said)
        self.assertTrue("SELECT_TOOL(12)" in said)

    def test_changes_of_feed_speed_and_tool_are_kept(self):
        table = self.file("tip_x_mm,tip_y_mm,tip_z_mm,move,feed_mm_per_min,spindle_rpm,tool\n"
                          "0,0,0,plunge,100,1000,1\n10,0,0,cut,200,1000,1\n10,10,0,cut,200,2000,12\n"
                          "10,10,5,retract,300,2000,12\n0,0,5,rapid,,2000,12\n", "p.csv")
        self.summary("post", table, "-o", "out")
        done = self.interpret(self.folder / "out/p.ngc")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        said = (self.folder / "canonical.txt").read_text()
        # The tool comes back to the path at a third of the feed.
        self.assertEqual(re.findall(r"(?:SET_FEED_RATE|SET_SPINDLE_SPEED|SELECT_TOOL)\((.*)\)", said),
                         ["0.0000", "1", "0, 1000.0000", "100.0000", "200.0000", "12", "0, 2000.0000", "66.6667",
                          "200.0000", "300.0000", "0.0000"])
        self.assertEqual(re.findall(r"DWELL\((.*)\)", said), ["2.0000", "2.0000"])

    def test_tool_length_and_coolant_are_on(self):
        table = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n10,0,0\n", "p.csv")
        self.summary("post", table, "--feed", "90", "--coolant", "flood", "--tool-number", "12", "-o", "out")
        done = self.interpret(self.folder / "out/p.ngc")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        said = (self.folder / "canonical.txt").read_text()
        words = ("SELECT_TOOL(12)", "START_SPINDLE_CLOCKWISE", "DWELL(2.0000)", "FLOOD_ON", "STRAIGHT_TRAVERSE",
                 "STRAIGHT_FEED", "FLOOD_OFF", "PROGRAM_END")
        order = [said.index(word) for word in words]
        self.assertEqual(order, sorted(order))
        self.assertIn("USE_TOOL_LENGTH_OFFSET(0.0000 0.0000 25.4000", said[order[3]:order[4]])

    def test_program_in_inches_has_the_same_moves(self):
        rows = "".join(f"{0.7 * k},{k % 3},{-0.05 * k}\n" for k in range(50))
        table = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n" + rows, "p.csv")
        found = []
        for unit, scale in (("mm", 1), ("inch", 25.4)):
            self.summary("post", table, "--feed", "508", "--units", unit, "-o", "out", "--force")
            done = self.interpret(self.folder / "out/p.ngc")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            said = (self.folder / "canonical.txt").read_text()
            found.append([tuple(scale * float(number) for number in move[1:]) for move in MOVE.findall(said)])
            self.assertIn(f"SET_FEED_RATE({508 / scale:.4f})", said)
        for in_mm, in_inches in zip(*found, strict=True):
            for a, b in zip(in_mm, in_inches):
                self.assertAlmostEqual(a, b, delta=25.4 * INTERPRETER_ROUNDING + 0.0002)

    def test_arcs_are_within_their_bound(self):
        """The arcs that the interpreter prints, sampled here, against the points of the path."""
        circle = [(20 * math.cos(0.01 * k), 20 * math.sin(0.01 * k)) for k in range(400)]
        for plane, order in (("G17", (0, 1, 2)), ("G18", (1, 2, 0)), ("G19", (2, 0, 1))):
            # `order` gives the place of first axis, second axis and normal of the plane in x, y, z.
            rows = []
            for first, second in circle:
                values = (first, second, 7.0)
                rows.append(tuple(values[place] for place in order))
            table = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n" + "".join(f"{x},{y},{z}\n" for x, y, z in rows), "p.csv")
            facts = self.summary("post", table, "--feed", "508", "--arcs", "--arc-fit-tolerance", "0.002", "-o", "out",
                                 "--force")
            self.assertGreaterEqual(facts["arcs"], 2)
            self.assertLessEqual(facts["lines"], 25)
            done = self.interpret(self.folder / "out/p.ngc")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            said = (self.folder / "canonical.txt").read_text()
            arcs = [tuple(map(float, numbers)) for numbers in
                    re.findall(r"ARC_FEED\((\S+), (\S+), (\S+), (\S+), (\S+), (\S+),", said)]
            self.assertEqual(len(arcs), facts["arcs"], plane)
            bound = facts["max_arc_error_mm"] + 3 * INTERPRETER_ROUNDING
            at = 0  # the points of the path, one arc after the other
            for end_first, end_second, centre_first, centre_second, turns, normal in arcs:
                self.assertEqual(turns, 1)
                self.assertAlmostEqual(normal, 7, delta=INTERPRETER_ROUNDING)
                radius = math.hypot(end_first - centre_first, end_second - centre_second)
                last = min(range(len(circle)), key=lambda k: math.dist(circle[k], (end_first, end_second)))
                self.assertGreater(last, at)
                for k in range(at, last + 1):
                    self.assertLessEqual(abs(math.dist(circle[k], (centre_first, centre_second)) - radius), bound)
                at = last
            self.assertGreaterEqual(at, 395)

    def test_program_with_other_feeds_has_the_same_moves(self):
        material = ROOT / "datasets/materials/steel.json"
        program = self.file("%\n(groove)\nG21 G90 G17 G40 G49 G94\nT1 M6\nS1000 M3\nG0 X-30 Y0 Z30\nG1 Z0 F50\n"
                            "X30 F300\nG0 Z30\nX-20 Y4\nG1 Z0 F50\nG2 X20 Y4 R200 F300\nG91 G3 X-40 I-20 Z-0.5\n"
                            "G90 G0 Z30\nM30\n%\n", "part.ngc")
        done = endmill("feed", program, "--material", material, "--cutter", "ball:10", "--flutes", 2, "--max-force-n",
                       1200, "--stock-top", 5, "--allow-infeasible", "-o", "fed", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        said = []
        for file in (program, self.folder / "fed/part-feed.ngc"):
            done = self.interpret(file)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            said.append((self.folder / "canonical.txt").read_text())
        straight = [MOVE.findall(text) for text in said]
        self.assertEqual(straight[0], straight[1])
        self.assertIn("groove", said[1])
        ends = [re.findall(r"ARC_FEED\((\S+), (\S+), (\S+), (\S+), (\S+), (\S+),", text) for text in said]
        self.assertEqual(len(ends[0]), 2)
        self.assertGreater(len(ends[1]), 2)
        centres = {tuple(round(float(c), 2) for c in end[2:4]) for end in ends[0]}
        self.assertEqual({tuple(round(float(c), 2) for c in end[2:4]) for end in ends[1]}, centres)
        self.assertEqual(ends[1][-1][:2], ends[0][-1][:2])

    def test_names_that_look_like_commands_stay_comments(self):
        table = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n1,0,0\n", "p.csv")
        for name in ("MSG, stop", "DEBUG, #<x>", "a) G0 Z-50 (", "%", "a;b", "Fläché €", "x" * 5000):
            self.file({"name": name}, "summary.json")
            self.summary("post", table, "--feed", "10", "-o", "out", "--force")
            done = self.interpret(self.folder / "out/p.ngc")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            said = (self.folder / "canonical.txt").read_text()
            self.assertFalse("MESSAGE" in said)
            self.assertEqual(len(MOVE.findall(said)), 5)

    def test_more_blocks_than_line_numbers_are_accepted(self):
        rows = "".join(f"{k % 100},{k // 100},{k % 2}\n" for k in range(100010))
        table = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n" + rows, "p.csv")
        self.summary("post", table, "--feed", "10", "--line-numbers", "-o", "out")
        self.assertEqual(self.interpret(self.folder / "out/p.ngc").returncode, 0)
        self.assertEqual(len(MOVE.findall((self.folder / "canonical.txt").read_text())), 100013)

    def test_interpreter_refuses_wrong_programs(self):
        for text in ("%\nG1 X1\n%\n", "%\nG21 G0 X1,5\n%\n", "%\nG99999\n%\n"):
            done = self.interpret(self.file(text, "bad.ngc"))
            self.assertEqual(done.returncode, 1, text)


if __name__ == "__main__":
    unittest.main()
