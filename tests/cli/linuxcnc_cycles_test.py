# SPDX-License-Identifier: GPL-3.0-or-later
"""Moves of canned cycles, compared with those of LinuxCNC's interpreter. rs274 expands each program, our reader
reads both the program and the output of rs274, and the two paths must be equal but for repeated points.
scripts/setup.sh installs rs274; without it these tests fail."""
import json
import subprocess
import unittest

from program import ProgramTest, endmill

# It prints four decimals; sums of increments are rounded in addition.
INTERPRETER_ROUNDING = 1.5e-4
START = "G21 G90 G94 G17\nG0 X0 Y0 Z10\nF100 S100 M3\n"
BLOCKS = {
    "G81, both retract levels": "G99 G81 X1 Y2 Z-3 R2\nG98 X2\nG81 X3 Z-1 R3\nG99 X4\nX5 Y1\nG80",
    "G81 from below R": "G0 Z1\nG99 G81 X1 Z-3 R2\nG98 X2\nX3 R0.5\nX4\nG80\nG0 Z20",
    "levels that rise and fall": "G98 G81 X1 Z-3 R12\nX2 R11\nG99 X3 R10.5\nX4 R11\nX5 R9\nG98 X6 R8\nX7",
    "an R that rises under G99": "G99 G81 X1 Z-3 R2\nX2 R5\nG98 X3 R7 L2\nX4",
    "increments": "G91 G99 G81 X1 Y-1 Z-3 R-2\nX2\nG98 X3 Z-4\nL3 X1 Y1\nG90 X5\nL2 X7",
    "increments and levels": "G98 G81 X1 Z-3 R2\nG91 X1 Z-4\nX1\nG90 X6\nX7 Z-3 R2",
    "another plane and back": "G99 G81 X1 Z-3 R2\nG91 X1 L2\nG80\nG90 G18\nG99 G81 X1 Y-3 R2 Z5\nG98 X3 Y-4 R1 L2\nX4 Z7",
    "G19": "G19 G98 G83 X-3 Y4 Z1 R2 Q1.5\nY8",
    "pecks": "G98 G83 X1 Z-3 R2 Q2\nX2 Q1.25\nG73 X3 Z-4.5 R1 Q1\nG99 X4",
    "a peck shorter than the clearance": "G99 G83 X1 Z1.5 R2 Q0.125\nG73 X2 Z1.5 R2 Q0.125",
    "taps and bores": "G98 G84 X1 Z-3 R2\nG85 X2 Z-4 R1\nG86 X3 Z-4 R1 P1\nG89 X4 Z-4 R1 P0.5\nG82 X5 Z-4 R1 P1\nX6",
    "taps and bores to R": "G99 G84 X1 Z-3 R2\nG85 X2 Z-4 R1\nG86 X3 Z-4 R1 P1\nG89 X4 Z-4 R1 P0.5\nG82 X5 Z-4 R1 P1\nX6",
    "a left-hand tap": "M4\nG98 G74 X1 Z-3 R2\nG99 X2",
    "inches": "G20 G99 G83 X1 Z-0.5 R0.25 Q0.125\nG91 X0.5 L3",
    "motion between cycles": "G99 G81 X1 Z-3 R2\nG0 X2 Z5\nG98 G81 X3 Z-3 R2\nG1 X4\nG2 X6 I1\nG82 X8 Z-1 R1 P0",
    "G80 beside G0": "G99 G81 X1 Z-3 R2\nG0 G80 X5\nG80 G1 X6",
}


def path_of_apt(file):
    """Tips of APT CL data, and whether each move to them is a rapid; repeated points once."""
    points, is_rapid = [], False
    for line in file.read_text(encoding="ascii").splitlines():
        if line.startswith("GOTO/"):
            tip = tuple(map(float, line.removeprefix("GOTO/").split(",")))
            if not points or max(abs(a - b) for a, b in zip(tip, points[-1][0])) > INTERPRETER_ROUNDING:
                points.append((tip, is_rapid))
        is_rapid = line == "RAPID"
    return points


class Cycles(ProgramTest):
    def read(self, program, name):
        """The path of a program, as our reader reads it."""
        out = self.folder / name
        self.summary("post", program, "--format", "apt", "--decimals", 6, "-o", out)
        return path_of_apt(next(out.glob("*.apt")))

    def compare(self, blocks):
        program = self.file(START + blocks + "\nM2\n", "program.ngc")
        tools = self.file("T1 P1 D0.3937 Z0.0 ;ball\n", "tools.tbl")
        try:
            done = subprocess.run(["rs274", "-g", "-t", tools, program, "canonical.txt"], cwd=self.folder,
                                  capture_output=True, text=True, check=False, timeout=60, stdin=subprocess.DEVNULL)
        except FileNotFoundError:
            self.fail("rs274 is missing: scripts/setup.sh installs it (Debian package linuxcnc-uspace)")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        # Taps reverse the spindle, which no written program does. G89 makes the same moves without it.
        canonical = self.folder / "canonical.txt"
        canonical.write_text(canonical.read_text().replace("COUNTERCLOCKWISE", "CLOCKWISE"))
        program.write_text(program.read_text().replace("M4\n", "").replace("G74", "G89").replace("G84", "G89"))
        expected = self.read(canonical, "expected")
        found = self.read(program, "found")
        self.assertEqual(len(found), len(expected), (found, expected))
        for (tip, is_rapid), (found_tip, found_rapid) in zip(expected, found):
            self.assertEqual(is_rapid, found_rapid, tip)
            self.assertLessEqual(max(abs(a - b) for a, b in zip(tip, found_tip)), INTERPRETER_ROUNDING, tip)

    def test_cycles_are_those_of_linuxcnc(self):
        for name, blocks in BLOCKS.items():
            with self.subTest(name):
                self.folder.mkdir(exist_ok=True)
                for used in ("expected", "found"):
                    for file in (self.folder / used).glob("*"):
                        file.unlink()
                    if (self.folder / used).exists():
                        (self.folder / used).rmdir()
                self.compare(blocks)

    def test_taps_are_read_alike_and_never_written(self):
        """The reversal that a tapping cycle makes itself is no M4 of the program; M4 before a left-hand tap is one."""
        for tap, m4 in (("G98 G84 X1 Z-3 R2\nX2", False), ("G99 G84 X1 Z-3 R2 P1", False),
                        ("M49\nG99 G84 X1 Z-3 R2", False), ("M5\nM4\nG98 G74 X1 Z-3 R2\nM5\nM3", True)):
            program = self.file(START + tap + "\nG80\nG1 X9\nM2\n", "taps.ngc")
            with self.subTest(tap):
                readers = ([], ["--interpreter", "linuxcnc"])
                reports = [endmill("info", program, "--json", *reader) for reader in readers]
                found = [json.loads(report.stdout) for report in reports]
                for key in ("cut_mm", "plunge_mm", "rapid_mm", "time_min", "min_mm", "max_mm", "min_spindle_rpm"):
                    self.assertEqual(found[0][key], found[1][key])
                for reader, report in zip(readers, reports):
                    self.assertEqual("counterclockwise" in report.stderr, m4, report.stderr)
                    done = endmill("post", program, *reader, "-o", self.folder / "out")
                    self.assert_refused(done, 3, "(M4)" if m4 else "a tapping cycle (G74, G84) reverses the spindle on "
                                        "the move to point ")

    def test_programs_with_offsets_are_in_the_coordinates_of_the_first_move(self):
        """G92 and a turned G54 in the middle of a program: rs274 states the same places of the machine."""
        blocks = "G1 X10 Z0\nG92 X0\nX5\nG92.1\nG10 L2 P1 X1 Y2 R90\nG1 X5 Y0\nG2 X7 I1"
        program = self.file(START + blocks + "\nM2\n", "program.ngc")
        done = subprocess.run(["rs274", "-g", program, "canonical.txt"], cwd=self.folder, capture_output=True, text=True,
                              check=False, timeout=60, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = [tip for tip, _ in self.read(self.folder / "canonical.txt", "found")]
        # In the machine: G92 X0 at X 10 makes X5 the place 15; the point (5, 0) of the turned system is (1, 7),
        # and (7, 0) is (1, 9).
        self.assertIn((10, 0, 0), found)
        self.assertIn((15, 0, 0), found)
        for place in ((1, 7, 0), (1, 9, 0)):
            self.assertTrue(any(max(abs(a - b) for a, b in zip(place, tip)) < INTERPRETER_ROUNDING for tip in found),
                            found)


if __name__ == "__main__":
    unittest.main()
