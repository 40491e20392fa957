# SPDX-License-Identifier: GPL-3.0-or-later
"""Every example of a help text works as it is printed, in a folder from which `datasets` is seen."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))

from program import ENDMILL, ROOT, ProgramTest, endmill
from program_test import COMMANDS


class HelpExamples(ProgramTest):
    def examples(self, command):
        """The example lines of a help text, ready for a shell."""
        text = endmill(*command, "--help").stdout.split("Example:\n")[1].split("\n\n")[0]
        lines = text.splitlines()
        for line in lines:
            self.assertTrue(line.startswith("  endmill "), (command, line))
        return [line.strip() for line in lines]

    def shell(self, line, folder):
        """Runs a line in a shell with the program on its path, and returns the finished process."""
        path = f"{Path(ENDMILL).resolve().parent}{os.pathsep}{os.environ['PATH']}"
        return subprocess.run(["bash", "-c", line], cwd=folder, env={**os.environ, "PATH": path}, capture_output=True,
                              text=True, check=False, timeout=600, stdin=subprocess.DEVNULL)

    def test_examples_of_the_help_run_in_a_shell(self):
        formulas = [formula["name"] for formula in self.summary("eval")["formulas"]]
        has_cad = Path(ENDMILL).with_name("endmill-cad").exists()
        known = [name for name in COMMANDS if name != "import" or has_cad]
        for command in ([], *([name] for name in known), *(["eval", name] for name in formulas)):
            with self.subTest(command=command), tempfile.TemporaryDirectory() as folder:
                (Path(folder) / "datasets").symlink_to(ROOT / "datasets")
                for line in self.examples(command):
                    done = self.shell(line, folder)
                    self.assertIn(done.returncode, (0, 1), (line, done.stderr))
                    if command != ["setup"]:
                        self.assertEqual(done.returncode, 0, (line, done.stdout, done.stderr))

    def test_example_of_feed_saves_time(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "datasets").symlink_to(ROOT / "datasets")
            for line in self.examples(["feed"]):
                self.shell(line, folder)
            facts = json.loads((Path(folder) / "results/feed/summary.json").read_text())
        self.assertEqual(facts["infeasible"], 0)
        self.assertGreater(facts["saving_percent"], 50)
        self.assertGreater(facts["limits"]["cutting_force"], 0.1)


if __name__ == "__main__":
    unittest.main()
