# SPDX-License-Identifier: GPL-3.0-or-later
"""The example programs that the Debian package linuxcnc-uspace installs. tests/data/linuxcnc-examples.csv states for
each of them whether our reader reads it, or words of the reason why not. Where both LinuxCNC's interpreter and our
reader read a program, their paths must agree. Where the package does not install its examples, the tests are skipped."""
import csv
import subprocess
import unittest
from pathlib import Path

from program import ROOT, ProgramTest, endmill

INSTALLED = Path("/usr")
TABLE = ROOT / "tests/data/linuxcnc-examples.csv"
CHORD = 0.01  # mm, tolerance of arcs
# An arc whose ends have four decimals of an inch is known to 2.5 um at its ends, and in between to a few of them.
ROUNDING = 0.01
# Programs that go to positions of the machine, and those that the interpreter refuses for the tool table of the test.
NOT_COMPARED = ("skeleton.ngc", "nc_files/examples.ngc")


def listed():
    with open(TABLE, newline="", encoding="utf-8") as file:
        return [row for row in csv.DictReader(file) if (INSTALLED / row["path"]).is_file()]


def path_of_apt(file):
    """Tips of APT CL data, repeated points once."""
    points = []
    for line in file.read_text(encoding="ascii").splitlines():
        if line.startswith("GOTO/"):
            tip = tuple(map(float, line.removeprefix("GOTO/").split(",")))
            if not points or tip != points[-1]:
                points.append(tip)
    return points


def distance(point, begin, end):
    """Distance of a point from a segment."""
    along = [b - a for a, b in zip(begin, end)]
    length = sum(c * c for c in along)
    share = sum((p - a) * c for p, a, c in zip(point, begin, along)) / length if length else 0
    share = min(1, max(0, share))
    return sum((p - a - share * c)**2 for p, a, c in zip(point, begin, along))**0.5


def farthest(points, polyline):
    """Largest distance of the points, in their order, from the polyline, which is followed forwards only."""
    largest, at = 0, 0
    for point in points:
        window = range(at, min(at + 200, len(polyline) - 1))
        near = [distance(point, polyline[i], polyline[i + 1]) for i in window]
        step = next((i for i, d in enumerate(near) if d <= CHORD + ROUNDING), near.index(min(near)))
        largest = max(largest, near[step])
        at += step
    return largest


@unittest.skipUnless(len(listed()) > 100, "the example programs of linuxcnc-uspace are not installed")
class LinuxcncExamples(ProgramTest):
    def post(self, program, name):
        return endmill("post", program, "--format", "apt", "--feed", 100, "--decimals", 6, "--arc-tolerance", CHORD, "-o",
                       self.folder / name, cwd=self.folder)

    def test_each_is_read_or_refused_as_the_table_states(self):
        for number, row in enumerate(listed()):
            with self.subTest(row["path"]):
                done = self.post(INSTALLED / row["path"], f"out-{number}")
                if row["outcome"] == "read":
                    self.assertEqual(done.returncode, 0, done.stderr)
                else:
                    self.assert_refused(done, 3, row["reason"])

    def test_all_installed_programs_are_in_the_table(self):
        paths = {row["path"] for row in listed()}
        for folder in ("share/linuxcnc/ncfiles", "share/doc/linuxcnc/examples"):
            found = {str(path.relative_to(INSTALLED)) for path in (INSTALLED / folder).rglob("*.ngc")}
            self.assertEqual(found - paths, set())

    def test_what_is_read_is_the_path_of_the_interpreter(self):
        tools = self.file("T1 P1 D0.3937 Z0.0 ;ball\nT2 P2 D0.25 Z0.0\nT3 P3 D0.25 Z0.0\n", "tools.tbl")
        compared = 0
        for row in listed():
            if row["outcome"] != "read" or row["path"].endswith(NOT_COMPARED):
                continue
            with self.subTest(row["path"]):
                done = subprocess.run(["rs274", "-g", "-t", tools, INSTALLED / row["path"], "canonical.txt"],
                                      cwd=self.folder, capture_output=True, text=True, check=False, timeout=60,
                                      stdin=subprocess.DEVNULL)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                paths = []
                for program, name in ((INSTALLED / row["path"], f"found-{compared}"),
                                      (self.folder / "canonical.txt", f"expected-{compared}")):
                    done = self.post(program, name)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    paths.append(path_of_apt(next((self.folder / name).glob("*.apt"))))
                found, expected = paths
                # The interpreter knows the position before the program gives it.
                expected = expected[expected.index(min(expected[:5], key=lambda tip: sum(
                    (a - b)**2 for a, b in zip(tip, found[0])))):]
                self.assertLessEqual(farthest(found, expected), CHORD + ROUNDING)
                self.assertLessEqual(farthest(expected, found), CHORD + ROUNDING)
                compared += 1
        self.assertGreaterEqual(compared, 4)


if __name__ == "__main__":
    unittest.main()
