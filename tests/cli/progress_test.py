# SPDX-License-Identifier: GPL-3.0-or-later
"""The progress line appears on a terminal after one second, and nowhere else."""
import os
import pty
import subprocess
import unittest

from program import ENDMILL, ROOT, SURFACES, ProgramTest

NET = SURFACES / "net_rot24_7D.json"
# Commands that take more than a second, and words that their progress line must show.
LONG = ((("plan", NET, "--chord-tolerance", "0.05"), ("planning:", "along u", "along v", "%")),
        (("trim", SURFACES / "valley.json", "--cutter", "ball:20", "--method", "all", "--grid", "400"),
         ("method ", "method winding: ")),
        (("setup", ROOT / "datasets/meshes/teapot-288.off", "--machine", "W/caxyBz/T", "--mode", "set", "--sphere",
          "hex:20"), ("nodes, bound",)))


class Progress(ProgramTest):
    def on_terminal(self, *arguments):
        """The exit status, and the output on a terminal that is standard error."""
        parent, child = pty.openpty()
        with subprocess.Popen([ENDMILL, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=child) as process:
            os.close(child)
            shown = b""
            while True:
                try:
                    piece = os.read(parent, 4096)
                except OSError:  # the program has closed its end
                    break
                if not piece:
                    break
                shown += piece
            status = process.wait(timeout=600)
        os.close(parent)
        return status, shown.decode()

    def test_long_work_shows_and_removes_its_line(self):
        for number, (arguments, words) in enumerate(LONG):
            with self.subTest(command=arguments[0]):
                _, shown = self.on_terminal(*arguments, "-o", f"out{number}")
                for word in words:
                    self.assertIn(word, shown)
                self.assertRegex(shown, r", \d+ s|: \d+ s")
                self.assertEqual(shown.rsplit("\r\x1b[K", 1)[1].strip(), "", shown[-200:])

    def test_quiet_or_quick_work_shows_no_line(self):
        status, shown = self.on_terminal("plan", NET, "--chord-tolerance", "0.05", "--quiet", "-o", "quiet")
        self.assertEqual((status, shown), (0, ""))
        self.assertEqual(self.on_terminal("cite"), (0, ""))


if __name__ == "__main__":
    unittest.main()
