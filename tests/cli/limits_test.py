# SPDX-License-Identifier: GPL-3.0-or-later
"""No command takes more memory than its limit allows, and lengths beyond the extent are refused at once."""
import json
import math
import os
import resource
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
        """Runs a command that needs more than the limit; asserts exit 6 and its resident memory. Returns its message."""
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
        return lines[0]

    def test_large_cutter_on_a_border(self):
        self.limited(0.3, "trim", VALLEY, "--planes", 5, "--grid", 20, "--cutter", "ball:900000")

    def test_large_allowance(self):
        message = self.limited(0.3, "trim", VALLEY, "--cutter", "ball:20", "--allowance", 65536)
        self.assertIn("a smaller --allowance needs less", message)

    def test_a_limit_of_the_system_is_named(self):
        for limit, word in ((resource.RLIMIT_AS, "ulimit -v"), (resource.RLIMIT_DATA, "ulimit -d")):
            with self.subTest(word):
                done = subprocess.run([ENDMILL, "trim", VALLEY, "--planes", "8000", "--cutter", "ball:20", "-o", "out"],
                                      preexec_fn=lambda limit=limit: resource.setrlimit(limit, (3 * GIB // 10,) * 2),
                                      capture_output=True, text=True, check=False, cwd=self.folder)
                error = [line for line in done.stderr.splitlines() if line.startswith("endmill: error: ")]
                self.assertEqual(done.returncode, 6, done.stderr)
                self.assertIn("out of memory; expected at most 0.3 GiB (", error[0])
                self.assertIn(word, error[0])
                self.assertNotIn("--max-memory", error[0])

    def test_fine_sampling_of_a_setup(self):
        self.limited(0.05, "setup", TEAPOT, "--chord-tolerance", 0.002, "--family", "CA")

    def test_many_directions_of_a_setup(self):
        self.limited(0.05, "setup", TEAPOT, "--sphere", "hex:60", "--family", "CA")

    def test_tetrahedron_with_a_far_vertex(self):
        part = self.file("v 0 0 0\nv 10 0 0\nv 0 1000000 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", "far.obj")
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,12\n1,0,12\n", "path.csv")
        self.limited(0.3, "verify", path, "--part", part, "--cutter", "ball:4")

    def feed(self, moves, gib):
        """Plans the feeds of a raster over a wave; the exit status, the errors and the resident memory in bytes."""
        program = [f"G1 X{i % 500 * 0.2:.4f} Y{i // 500 * 0.2:.4f} Z{5 + math.sin(i % 500 * 0.06):.4f}\n"
                   for i in range(moves)]
        path = self.file(f"G21 G90 G0 X0 Y0 Z30\nG1 Z4 F800\n{''.join(program)}M30\n", f"feed-{moves}.ngc")
        with subprocess.Popen([ENDMILL, "feed", path, "--cutter", "ball:6", "--material",
                               ROOT / "datasets/materials/steel.json", "--flutes", "2", "--stock-top", "8",
                               "--threads", "2", "--quiet", "--force", "--max-memory", str(gib), "-o",
                               self.folder / "out"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as process:
            errors = process.stderr.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        return process.returncode, errors, usage.ru_maxrss * 1024

    def test_a_move_in_feed_takes_little_memory(self):
        """The path, its text and an index remain; cuts, loads and files do not."""
        most_bytes = 450
        small, large = 50_000, 250_000
        before, after = self.feed(small, 8), self.feed(large, 8)
        self.assertEqual([before[0], after[0]], [0, 0], after[1])
        self.assertLess((after[2] - before[2]) / (large - small), most_bytes)

    def test_long_program_in_feed(self):
        for gib in (0.2, 0.1):
            with self.subTest(gib=gib):
                status, errors, memory = self.feed(250_000, gib)
                self.assertEqual(status, 0 if gib > 0.15 else 6, errors)
                self.assertIn("" if status == 0 else "(--max-memory)", errors)
                self.assertLess(memory, MOST_SHARE * gib * GIB + ROOM)

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

    def test_tolerance_below_the_resolution_of_a_mesh(self):
        """The curves would be divided down to the rounding of their coordinates."""
        done = endmill("trim", ROOT / "datasets/meshes/prism.obj", "--cutter", "ball:6", "--planes", 5, "--grid", 20,
                       "--tolerance", "1e-320", "-o", "out", cwd=self.folder)
        self.assert_refused(done, 2, "--tolerance: found 1e-320 mm", "at least 6e-11 mm")
        self.assert_nothing_left()


if __name__ == "__main__":
    unittest.main()
