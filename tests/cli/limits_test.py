# SPDX-License-Identifier: GPL-3.0-or-later
"""No command takes more memory than its limit allows, and lengths beyond the extent are refused at once."""
import json
import os
import subprocess
import unittest
from pathlib import Path

from program import ENDMILL, ROOT, SURFACES, ProgramTest, endmill

VALLEY = SURFACES / "valley.json"
SHEARED = SURFACES / "sheared-plane.json"
TEAPOT = SURFACES / "teapot.json"
GIB = 2**30
# Where allocation ends, with the stacks of two threads and some room for messages.
MOST_SHARE = 1.3
ROOM = 40 * 2**20


@unittest.skipIf(b"__asan_init" in Path(ENDMILL).read_bytes(), "sanitizers take memory of their own")
class Memory(ProgramTest):
    def limited(self, gib, *arguments):
        """Runs a command that needs more than the limit; asserts exit 6, its message and its resident memory."""
        errors = self.folder / "errors"
        with errors.open("w") as stream:
            process = subprocess.Popen([ENDMILL, *map(str, arguments), "--threads", "2", "--max-memory", str(gib), "-o",
                                        self.folder / "out"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                       stderr=stream)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        lines = [line for line in errors.read_text().splitlines() if line.startswith("endmill: error: ")]
        self.assertEqual((process.returncode, len(lines)), (6, 1), lines)
        self.assertIn("(--max-memory)", lines[0])
        self.assertRegex(lines[0], " needs? less|fewer|which a resolution")
        self.assertLess(usage.ru_maxrss * 1024, MOST_SHARE * gib * GIB + ROOM)
        self.assertFalse((self.folder / "out").exists())

    def test_large_cutter_on_a_border(self):
        self.limited(0.3, "trim", VALLEY, "--planes", 5, "--grid", 20, "--cutter", "ball:900000")

    def test_large_allowance(self):
        self.limited(0.3, "trim", VALLEY, "--cutter", "ball:20", "--allowance", 65536)

    def test_fine_sampling_of_a_setup(self):
        self.limited(0.05, "setup", TEAPOT, "--chord-tolerance", 0.002, "--family", "CA")

    def test_tetrahedron_with_a_far_vertex(self):
        part = self.file("v 0 0 0\nv 10 0 0\nv 0 1000000 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", "far.obj")
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,12\n1,0,12\n", "path.csv")
        self.limited(0.3, "verify", path, "--part", part, "--cutter", "ball:4")

    def test_message_as_json(self):
        done = endmill("trim", VALLEY, "--cutter", "ball:20", "--allowance", 65536, "--max-memory", 0.3, "--quiet",
                       "--json-errors", cwd=self.folder)
        error = json.loads(done.stderr)["error"]
        self.assertEqual((error["code"], error["exit"]), ("E_LIMIT", 6))
        self.assertIn("--max-memory", error["message"])

    def test_what_fits_is_not_refused(self):
        self.summary("trim", VALLEY, "--planes", 5, "--grid", 20, "--cutter", "ball:20", "--tolerance", 9,
                     "--max-memory", 0.1)


class Extent(ProgramTest):
    def test_cutters_and_allowances_beyond_the_extent(self):
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n1,0,0\n", "p.csv")
        for arguments, word in ((("trim", VALLEY, "--cutter", "ball:2147483648"), "--cutter"),
                                (("trim", VALLEY, "--cutter", "bull:2e6:1"), "--cutter"),
                                (("trim", VALLEY, "--cutter", "ball:20", "--allowance", "2e6"), "--allowance"),
                                (("plan", SHEARED, "--chord-tolerance", 2, "--cutter", "ball:1e308"), "--cutter"),
                                (("verify", path, "--cutter", "flat:1e9"), "--cutter"),
                                (("post", path, "--feed", 9, "--cutter", "ball:1e9"), "--cutter"),
                                (("feed", path, "--cutter", "ball:1e9", "--material",
                                  ROOT / "datasets/materials/steel.json"), "--cutter")):
            with self.subTest(arguments=arguments):
                done = endmill(*arguments, "-o", "out", cwd=self.folder)
                self.assert_refused(done, 2, f"{word}: found ", "at most 1e+06 mm (--max-extent)")
                self.assert_nothing_left("p.csv")


if __name__ == "__main__":
    unittest.main()
