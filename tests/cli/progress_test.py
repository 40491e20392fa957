# SPDX-License-Identifier: GPL-3.0-or-later
"""The progress line appears on a terminal after one second; elsewhere a line appears every ten seconds."""
import signal
import subprocess
import time
import unittest

from program import ENDMILL, ROOT, SURFACES, ProgramTest, on_terminal

NET = SURFACES / "net_rot24_7D.json"
# Commands that take more than a second, and words that their progress line must show.
LONG = ((("plan", NET, "--strategy", "iso", "--chord-tolerance", "0.05"), ("planning:", "along u", "along v", "%")),
        (("trim", SURFACES / "valley.json", "--cutter", "ball:20", "--method", "all", "--grid", "400"),
         ("method ", "method winding: ")),
        (("setup", ROOT / "datasets/meshes/teapot-288.off", "--machine", "W/caxyBz/T", "--mode", "set", "--sphere",
          "hex:20"), ("nodes, bound",)))


class Progress(ProgramTest):
    def test_long_work_shows_and_removes_its_line(self):
        for number, (arguments, words) in enumerate(LONG):
            with self.subTest(command=arguments[0]):
                _, shown = on_terminal(self.folder, *arguments, "-o", f"out{number}")
                for word in words:
                    self.assertIn(word, shown)
                self.assertRegex(shown, r", \d+ s|: \d+ s")
                self.assertEqual(shown.rsplit("\r\x1b[K", 1)[1].strip(), "", shown[-200:])

    def test_time_left_is_estimated_from_the_share(self):
        _, shown = on_terminal(self.folder, "plan", NET, "--strategy", "iso", "--chord-tolerance", "0.02", "-o", "left")
        self.assertRegex(shown, r" \d+ %, \d+ s, about \d+ (s|min) left")
        self.assertNotRegex(shown, r"passes 0 %, \d+ s, about")

    def test_each_long_part_of_trim_shows_its_share(self):
        _, shown = on_terminal(self.folder, "trim", SURFACES / "valley.json", "--cutter", "ball:20", "--planes", "2000",
                               "-o", "parts")
        # on a fast machine this part ends before there is an estimate
        self.assertRegex(shown, r"measuring the sampling error: \d+ %, \d+ s")
        self.assertRegex(shown, r"measuring the clearance: \d+ %, \d+ s, about .* left")

    def stopped_for_ten_seconds(self, *options):
        """The lines on standard error of a plan that is no terminal's and lasts more than ten seconds."""
        with subprocess.Popen([ENDMILL, "plan", NET, "--strategy", "iso", "--chord-tolerance", "0.02", *options], cwd=self.folder,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
            time.sleep(0.5)
            process.send_signal(signal.SIGSTOP)
            time.sleep(10)
            process.send_signal(signal.SIGCONT)
            _, shown = process.communicate(timeout=600)
        self.assertEqual(process.returncode, 0, shown)
        return shown.splitlines()

    def test_lines_appear_without_a_terminal(self):
        lines = self.stopped_for_ten_seconds("-o", "lines")
        self.assertGreaterEqual(len(lines), 1)
        for line in lines:
            self.assertRegex(line, r"^endmill: planning: .*\d\d s(, about \d+ (s|min) left)?$")
            self.assertNotRegex(line, r"[\x00-\x1f]")
        self.assertEqual(self.stopped_for_ten_seconds("--quiet", "-o", "none"), [])

    def test_long_work_estimates_its_time_at_once_without_a_terminal(self):
        """The first line comes long before ten seconds have passed, and states the time left."""
        # a few passes, each of which takes long
        cylinder = (SURFACES / "cylinder.json", "--cutter", "ball:15", "--inner-tolerance", "1e-7")
        for work, arguments in (
                ("planning", ("plan", SURFACES / "sheared-plane.json", "--strategy", "iso", "--chord-tolerance", "1e-5")),
                ("planning", ("plan", "--strategy", "iso", *cylinder)),
                ("(slicing the offset|writing the sections)", ("trim", SURFACES / "valley.json", "--cutter", "ball:20",
                                                               "--planes", "12000")),
                ("comparing the methods", ("trim", SURFACES / "plane.json", "--cutter", "ball:6", "--planes", "3", "--grid",
                                           "9", "--method", "all", "--repeat", "65536"))):
            with self.subTest(arguments=arguments), subprocess.Popen(
                    [ENDMILL, *map(str, arguments), "-o", "early"], cwd=self.folder, stdout=subprocess.DEVNULL,
                    stderr=subprocess.PIPE, text=True) as process:
                first = process.stderr.readline()
                process.terminate()
                process.communicate(timeout=600)
                self.assertRegex(first, rf"^endmill: {work}: .*, \d+ s, about .* left$")

    def test_quiet_or_quick_work_shows_no_line(self):
        status, shown = on_terminal(self.folder, "plan", NET, "--strategy", "iso", "--chord-tolerance", "0.05", "--quiet", "-o", "quiet")
        self.assertEqual((status, shown), (0, ""))
        self.assertEqual(on_terminal(self.folder, "cite"), (0, ""))


if __name__ == "__main__":
    unittest.main()
