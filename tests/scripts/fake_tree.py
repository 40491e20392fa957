# SPDX-License-Identifier: GPL-3.0-or-later
"""Small trees of files for the tests of the scripts."""
import contextlib
import io
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))


class FakeTree(unittest.TestCase):
    """A test with an empty folder `root`, which is removed afterwards."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve()

    def write(self, name, text=""):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def add_experiment(self, name, result, params=None, driver="", **files):
        """Adds an experiment whose driver is a shell script that writes `result` as result.csv.

        `driver` is run after that with $1 the output folder; `files` are named without .csv.
        """
        self.write(f"experiments/{name}/main.cpp", "// driver\n")
        self.write(f"experiments/{name}/params.json", json.dumps(params or {}))
        for stem, text in files.items():
            self.write(f"experiments/{name}/{stem}.csv", text)
        script = f"#!/bin/sh\nprintf '%s' '{result}' > \"$1/result.csv\"\n{driver}\n"
        program = self.write(f"build/release/experiments/{name.replace('/', '-')}", script)
        program.chmod(0o755)

    def check(self, function, *arguments):
        """Runs a script and returns its exit code and output."""
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            code = function(*arguments)
        return int(code), printed.getvalue()

    def git(self, *arguments):
        identity = ["-c", "user.name=A Tester", "-c", "user.email=tester@example.org"]
        command = ["git", *identity, *arguments]
        subprocess.run(command, cwd=self.root, check=True, capture_output=True)
