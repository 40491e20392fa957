# SPDX-License-Identifier: GPL-3.0-or-later
"""--interpreter linuxcnc: programs that LinuxCNC's rs274 turns into moves, and the limits of this child process.

scripts/setup.sh installs rs274 (Debian package linuxcnc-uspace). Without it only the test of its absence runs.
"""
import json
import math
import os
import re
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from program import ENDMILL, ProgramTest, endmill, on_terminal, plane

HEAD = "G21 G90 G94 G17 F100\n"
LOOP = "#1=0\no100 while [#1 lt 3]\nG0 X[#1*10] Y0 Z5\nG1 Z-1\nX[#1*10+5]\nG0 Z5\n#1=[#1+1]\no100 endwhile\nM2\n"


class Absent(ProgramTest):
    def test_missing_interpreter_is_named(self):
        program = self.file(HEAD + LOOP, "p.ngc")
        done = subprocess.run([ENDMILL, "info", program, "--interpreter", "linuxcnc"], cwd=self.folder,
                              env={**os.environ, "PATH": str(self.folder)}, capture_output=True, text=True,
                              check=False, timeout=600, stdin=subprocess.DEVNULL)
        self.assert_refused(done, 2, "rs274 is not installed", "linuxcnc-uspace")

    def test_option_is_for_gcode(self):
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n1,0,0\n", "p.csv")
        self.assert_refused(endmill("info", path, "--interpreter", "linuxcnc"), 2, "--interpreter linuxcnc",
                            "expects G-code")
        self.assert_refused(endmill("info", path, "--interpreter", "fanuc"), 2, "--interpreter")
        self.assert_refused(endmill("info", path, "--interpreter-seconds", "5"), 2, "--interpreter-seconds: has no")


@unittest.skipUnless(shutil.which("rs274"), "rs274 is not installed")
class LinuxCnc(ProgramTest):
    def info(self, text, *options, **named):
        return self.summary("info", self.file(text, "p.ngc"), "--interpreter", "linuxcnc", *options, **named)

    def refuse(self, text, status, *words, options=()):
        done = endmill("info", self.file(text, "p.ngc"), "--interpreter", "linuxcnc", *options, cwd=self.folder)
        self.assert_refused(done, status, *words)
        self.assert_nothing_left("p.ngc")

    def test_parameters_and_loops_are_expanded(self):
        self.assert_refused(endmill("info", self.file(HEAD + LOOP, "p.ngc")), 3, "p.ngc:2")
        facts = self.info(HEAD + LOOP)
        self.assertEqual((facts["min_mm"], facts["max_mm"]), ([0, 0, -1], [25, 0, 5]))
        self.assertAlmostEqual(facts["cut_mm"], 3 * 5, delta=1e-9)
        self.assertAlmostEqual(facts["plunge_mm"], 3 * 6, delta=1e-9)
        self.assertAlmostEqual(facts["time_min"], 3 * 11 / 100, delta=1e-9)
        self.assertEqual(facts["interpreter"], "linuxcnc")
        self.assert_nothing_left("p.ngc")

    def test_expressions_subprograms_and_cycles(self):
        facts = self.info(HEAD + "o<arc> sub\nG2 X#1 Y0 R#1\no<arc> endsub\nG0 X0 Y0 Z0\no<arc> call [10]\n"
                          "G0 Z9\nG81 X20 Y0 Z-3 R1\nG80\nM2\n", "--arc-tolerance", "0.0001")
        # A chord of 10 on a radius of 10 spans 60 degrees; the cycle drills 4 mm deep.
        self.assertAlmostEqual(facts["cut_mm"], 10 * math.pi / 3, delta=1e-3)
        self.assertAlmostEqual(facts["plunge_mm"], 4, delta=1e-9)

    def test_every_command_that_reads_paths_has_the_option(self):
        self.file(HEAD + LOOP, "p.ngc")
        run = ("p.ngc", "--interpreter", "linuxcnc")
        facts = self.summary("verify", *run, "--part", "none", "--cutter", "flat:4", "--stock", "-9,-9,-5,40,9,0",
                             "--resolution", "0.1", "-o", "v")
        slot = 5 * 4 * 1 + math.pi * 4  # 4 mm wide, with round ends
        self.assertAlmostEqual(facts["removed_mm3"], 3 * slot, delta=0.3)
        self.summary("post", *run, "-o", "posted")
        posted = self.summary("info", "posted/p.ngc")
        self.assertAlmostEqual(posted["cut_mm"] + posted["plunge_mm"], 33, delta=6)

    def test_same_program_gives_the_same_bytes(self):
        self.file(HEAD + LOOP, "p.ngc")
        texts = set()
        for threads in (1, 3):
            self.summary("post", "p.ngc", "--interpreter", "linuxcnc", "--threads", threads, "-o", "out", "--force")
            texts.add((self.folder / "out/p.ngc").read_bytes())
        self.assertEqual(len(texts), 1)

    def test_tools_of_the_table_are_known_to_the_interpreter(self):
        text = HEAD + "T7 M6 G43 H7\nG0 X0 Y0 Z5\nG1 X[#5410*100]\nM2\n"
        table = self.file("T7 D10 ;flat:10\nT8 D4\n", "t.tbl")
        facts = self.summary("verify", self.file(text, "p.ngc"), "--interpreter", "linuxcnc", "--tools", table,
                             "--tools-units", "mm", "--part", "none", "--stock", "-9,-9,-9,9,9,0", "--resolution", "1")
        self.assertEqual((facts["cutter"], facts["tools"]), ("flat:10", [7]))
        # The interpreter keeps diameters in inches; parameter 5410 is that of the current tool.
        self.assertAlmostEqual(facts["max_mm"][0], 10 / 25.4 * 100, delta=1e-3)
        self.assertEqual(self.info(HEAD + "T12345 M6\nG0 X1 Y0 Z5\nG1 X2\nM2\n")["tools"], [12345])

    def test_closed_standard_input_and_stricter_limits_are_accepted(self):
        program = self.file(HEAD + LOOP, "p.ngc")
        for before in ("exec <&-", "ulimit -t 30", "ulimit -n 40", "ulimit -c 0", "ulimit -v 1500000"):
            done = subprocess.run(["bash", "-c", before + '; exec "$@"', "-", ENDMILL, "info", program,
                                   "--interpreter", "linuxcnc", "--json"], cwd=self.folder, capture_output=True,
                                  text=True, check=False, timeout=600)
            self.assertEqual(done.returncode, 0, before + ": " + done.stderr)
            self.assertEqual(json.loads(done.stdout)["max_mm"], [25, 0, 5])

    def fake(self, content):
        """Runs info with another program in the place of rs274."""
        (self.folder / "bin").mkdir(exist_ok=True)
        self.file(content, "bin/rs274").chmod(0o755)
        return subprocess.run([ENDMILL, "info", self.file(HEAD + LOOP, "p.ngc"), "--interpreter", "linuxcnc",
                               "--interpreter-seconds", "1"], cwd=self.folder, capture_output=True, text=True,
                              check=False, timeout=600, stdin=subprocess.DEVNULL,
                              env={**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}"})

    def test_interpreter_that_cannot_be_started_is_named(self):
        self.assert_refused(self.fake("#!/nowhere/at/all\n"), 5, "p.ngc: cannot start rs274")
        self.assert_nothing_left("p.ngc", "bin")

    def test_folder_named_as_the_interpreter_is_passed_over(self):
        (self.folder / "bin/rs274").mkdir(parents=True)
        done = subprocess.run([ENDMILL, "info", self.file(HEAD + LOOP, "p.ngc"), "--interpreter", "linuxcnc"],
                              cwd=self.folder, capture_output=True, text=True, check=False, timeout=600,
                              env={**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}"})
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_limit_of_processor_time_is_named(self):
        program = self.file(HEAD + "o1 while [1]\no1 endwhile\nM2\n", "p.ngc")
        done = subprocess.run(["bash", "-c", 'ulimit -t 3; exec "$@"', "-", ENDMILL, "info", program,
                               "--interpreter", "linuxcnc"], cwd=self.folder, capture_output=True, text=True,
                              check=False, timeout=600)
        self.assert_refused(done, 6, "--interpreter-seconds")

    def test_endless_loop_is_ended(self):
        start = time.monotonic()
        self.refuse(HEAD + "o1 while [1]\no1 endwhile\nM2\n", 6, "ended after 1 s (--interpreter-seconds)",
                    options=("--interpreter-seconds", "1"))
        self.assertLess(time.monotonic() - start, 10)

    def test_progress_states_the_time_and_its_limit(self):
        path = self.file(HEAD + "o1 while [1]\no1 endwhile\nM2\n", "p.ngc")
        status, shown = on_terminal(self.folder, "info", path, "--interpreter", "linuxcnc", "--interpreter-seconds", "2")
        self.assertEqual(status, 6)
        self.assertRegex(shown, r"running \S*p.ngc in LinuxCNC's rs274, at most 2 s: 1 s")

    def test_rounded_positions_are_a_remark_where_the_tolerance_makes_them_matter(self):
        part = self.file(plane(size=(30, 20)))
        for unit, tolerance, words in (("G21", 0.01, None), ("G21", 0.0004, "known to 0.00005 mm"),
                                       ("G20", 0.01, "known to 0.00127 mm; the tolerance is 0.01 mm"),
                                       ("G20", 0.1, None)):
            path = self.file(f"{unit} G90 F100\nG0 X0 Y0 Z2\n#1=1\nG1 Z0\nX[#1]\nM2\n", "p.ngc")
            with self.subTest(unit, tolerance=tolerance):
                done = endmill("verify", path, "--interpreter", "linuxcnc", "--cutter", "ball:6", "--part", part,
                               "--tolerance", tolerance, "-o", "seen", "--force", cwd=self.folder)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                self.assertEqual("rs274 has four decimals" in done.stderr, words is not None, done.stderr)
                self.assertIn(words or "", done.stderr)

    def test_huge_output_is_ended(self):
        self.refuse(HEAD + "o1 while [1]\nG0 X1\nG0 X2\no1 endwhile\nM2\n", 6, "GiB; expected a program without",
                    options=("--max-memory", "0.004"))

    def test_refused_program_names_file_line_and_reason(self):
        self.refuse("G21\nG90 (mm)\nG1 X1\nM2\n", 3, "p.ngc:3: LinuxCNC's rs274 refuses the program: ",
                    "zero feed rate")
        self.refuse(HEAD + "G0 X1\n", 3, "p.ngc:2: LinuxCNC's rs274 refuses the program: ")
        self.refuse(HEAD + "G0 X1 (no end\nM2\n", 3, "p.ngc:2: ", "nclosed comment")
        self.refuse(HEAD + "G0 X[1/0]\nM2\n", 3, "p.ngc:2: ")

    def test_comments_run_nothing(self):
        made = self.folder / "made"
        text = HEAD + (f';py,open("{made}","w")\n(py,1)\n(LOGOPEN,{made})\n(LOG,x)\n(LOGCLOSE)\n'
                       "G0 X1 Y0 Z5 (py, 1)\n")
        facts = self.info(text + "G1 X2 (a) (b) ; c\nM2\n")
        self.assertEqual(facts["max_mm"][0], 2)
        self.assert_nothing_left("p.ngc")

    def test_subprograms_in_other_folders_are_refused(self):
        other = self.file("o<other> sub\n;py,1\no<other> endsub\n", "other.ngc")
        done = endmill("info", self.file(HEAD + "O<../other> call\nM2\n", "p.ngc"), "--interpreter", "linuxcnc",
                       cwd=self.folder)
        self.assert_refused(done, 3, "p.ngc:2: a subprogram in another folder")
        other.unlink()
        self.refuse(HEAD + "o<other> call\nM2\n", 3, "seeking o-word: o<other> from line: 2")

    def test_data_that_the_interpreter_lacks_are_not_taken_as_zero(self):
        # rs274 would go around the contour by a diameter of 0.
        self.refuse("#1=5\nG21 G90 F100\nG0 X0 Y0 Z#1\nG41 D1\nG1 X9\nM2\n", 3, "p.ngc:4", "cutter compensation")
        self.refuse("#1=5\nG21 G90 F100\nG0 X0 Y0 Z#1\nG53 G0 Z[#1]\nM2\n", 3, "p.ngc:4: a position of the machine")
        self.refuse("#1=5\nG21 G90 F100\nG0 X#1 Y0\nG1 X9\nM2\n", 3, "p.ngc: no absolute Z in 5 lines")
        self.refuse("#1=5\nG21 G90 F100\nM2\n", 3, "p.ngc: no motion in 3 lines", "G0, G1, G2 or G3")

    def moves(self, text, *options):
        """Number, move, tip of each point, as `post` writes them without an interpreter."""
        done = endmill("post", self.file(text, "m.ngc"), "--format", "apt", "-o", "out", "--force", *options,
                       cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line for line in (self.folder / "out/m.apt").read_text().splitlines() if line.startswith("GOTO")]

    def test_positions_of_the_machine_are_lifted_as_by_the_own_reader(self):
        for unit in ("G21", "G20"):
            for leave in ("G91 G28 Z0\nG90", "G28 Z4", "G91 G30 Z0\nG28 X0 Y0\nG90", "G53 G0 Z-2", "G0 Z3\nG28",
                          "G0 Z3\nG53 G0 X0 Y0 Z0"):
                text = (f"{unit} G91 G28 Z0\nG28 X0 Y0\nG90 G17 G94 F100\nG0 X1 Y2\nZ2\nG1 Z-1\nX5\n{leave}\n"
                        "G0 X3 Y4\nZ2\nG1 Z-1\nX9\nG0 Z2\nG28\nM2\n")
                with self.subTest(leave, unit=unit):
                    self.assertEqual(self.moves(text, "--interpreter", "linuxcnc"), self.moves(text))

    def test_positions_of_the_machine_in_a_loop(self):
        text = HEAD + ("#1=0\no1 while [#1 lt 3]\nG0 X[#1*10] Y0\nZ2\nG1 Z-1\nX[#1*10+5]\nG91 G28 Z0\nG90\n#1=[#1+1]\n"
                       "o1 endwhile\nM2\n")
        written_out = HEAD + "".join(f"G0 X{x} Y0\nZ2\nG1 Z-1\nX{x + 5}\nG91 G28 Z0\nG90\n" for x in (0, 10, 20)) + "M2\n"
        # The interpreter begins at 0, 0, 0, so the first move of the loop states a height of 0 for it.
        found, expected = self.moves(text, "--interpreter", "linuxcnc"), self.moves(written_out)
        self.assertEqual(found[-len(expected):], expected)
        done = endmill("info", self.file(text, "p.ngc"), "--interpreter", "linuxcnc", cwd=self.folder)
        self.assertIn("moves to positions of the machine (G28, G30, G53): 3", done.stderr + done.stdout)

    def test_remarks_say_whose_lines_they_count(self):
        program = self.file("#1=5\n" + HEAD + "G0 X0 Y0 Z5\nG1 Z-1\nX#1\nG28\nM2\n", "p.ngc")
        done = endmill("info", program, "--interpreter", "linuxcnc", cwd=self.folder)
        self.assertRegex(done.stderr, r"a move of all axes at once .* \(output of rs274, line \d+\)")

    def test_cuts_from_positions_of_the_machine_are_refused(self):
        start = HEAD + "G0 X0 Y0 Z5\nG1 Z-1\nX#1\n"
        for leave, found in (("G91 G28 Z0\nG90 G1 Z-1", "a cut from or to a position of the machine"),
                             ("G28\nG0 X0 Y0 Z5\nG1 Z-1", "a move of all axes at once"),
                             ("G53 G1 Z0", "a cut from or to a position of the machine"),
                             ("G91 G28 X0", "a sideways move to a position of the machine")):
            with self.subTest(leave):
                self.refuse("#1=5\n" + start + leave + "\nM2\n", 3, found)

    def test_interrupt_ends_the_interpreter_and_leaves_nothing(self):
        program = self.file(HEAD + "o1 while [1]\no1 endwhile\nM2\n", "p.ngc")
        for number in (signal.SIGINT, signal.SIGTERM):
            with subprocess.Popen([ENDMILL, "info", program, "--interpreter", "linuxcnc"], cwd=self.folder,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
                child = None
                while child is None and process.poll() is None:
                    time.sleep(0.05)
                    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
                    child = children[0] if children else None
                time.sleep(0.2)
                process.send_signal(number)
                process.communicate(timeout=60)
            self.assertEqual(process.returncode, 128 + number)
            self.assertFalse(os.path.exists(f"/proc/{child}"), child)
            self.assert_nothing_left("p.ngc")

    def test_feed_of_an_interpreted_program_is_planned(self):
        self.file(HEAD + LOOP, "p.ngc")
        done = endmill("feed", "p.ngc", "--interpreter", "linuxcnc", "--material",
                       os.path.join(os.path.dirname(__file__), "../../datasets/materials/steel.json"), "--cutter",
                       "ball:10", "--flutes", 2, "--max-force-n", 1200, "--stock-top", 5, "--allow-infeasible", "-o",
                       "fed", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        program = (self.folder / "fed/p-feed.ngc").read_text()
        self.assertIsNone(re.search(r"[#\[]", program))


if __name__ == "__main__":
    unittest.main()
