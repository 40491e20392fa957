# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command that writes runs on 2 and on 8 threads and writes the same bytes. Built by the preset tsan, the program
ends with exit code 66 at the first race of two threads."""
import subprocess
import sys
import unittest
from pathlib import Path

from program import ENDMILL, ProgramTest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "faults"))
from faults import COMMANDS, PLAN, PLANE, contents, difference  # noqa: E402


class Threads(ProgramTest):
    def test_commands_on_two_and_on_eight_threads(self):
        path = self.folder / "path"
        subprocess.run([ENDMILL, "plan", PLANE, "--strategy", "iso", *PLAN, "--quiet", "-o", path], check=True)
        for name, words in COMMANDS.items():
            written = []
            for threads in (2, 8):
                out = self.folder / f"{threads} {name}" / "results"
                places = {"PATH": path / "u/toolpath.csv", "FOLDER": out}
                out.parent.mkdir()
                with self.subTest(name, threads=threads):
                    done = subprocess.run([ENDMILL, *(str(places.get(word, word)) for word in words), "--quiet", "--threads",
                                           str(threads)], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                          check=False, cwd=out.parent)
                    self.assertIn(done.returncode, (0, 1), done.stderr)
                    written.append(contents(out))
            self.assertEqual("", difference(*written), name)


if __name__ == "__main__":
    unittest.main()
