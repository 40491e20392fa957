# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared code of the tests of the program: runs it, and makes surfaces for it."""
import json
import os
import pty
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SURFACES = ROOT / "datasets/surfaces"
ENDMILL = os.environ.get("ENDMILL", str(ROOT / "build/release/src/cli/endmill"))

def endmill(*arguments, **options):
    """Runs the program and returns the finished process. The limit of ten minutes allows for sanitizers."""
    command = [ENDMILL, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=600,
                          stdin=subprocess.DEVNULL, **options)


def on_terminal(folder, *arguments):
    """Runs the program in a folder. Returns the exit status, and the output on a terminal that is standard error."""
    parent, child = pty.openpty()
    with subprocess.Popen([ENDMILL, *map(str, arguments)], cwd=folder, stdin=subprocess.DEVNULL,
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


def plane(patches_u=1, patches_v=1, size=(60, 30), slope=0):
    """A surface file, as a dictionary, of a plane that rises along x. Its control points have equal steps."""
    columns, rows = 3 * patches_u, 3 * patches_v
    net = [[[size[0] * i / columns, size[1] * j / rows, slope * size[0] * i / columns] for i in range(columns + 1)]
           for j in range(rows + 1)]
    return {"format": "endmill-surface/1", "name": "plane", "source": "a test", "type": "bezier",
            "patches_u": patches_u, "patches_v": patches_v, "control_points": net}


class ProgramTest(unittest.TestCase):
    """A test with its own temporary folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, content, name="surface.json"):
        """Writes a file and returns its path. The content is a text, bytes, or an object for JSON."""
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def summary(self, *arguments, status=0):
        """The summary that the program prints with --json. Asserts the exit status."""
        done = endmill(*arguments, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout)

    def assert_refused(self, done, status, *words):
        """Asserts the exit status, one line of error with these words, and no standard output.
        Progress lines, which long work prints under sanitizers, and warnings do not count."""
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        errors = [line for line in done.stderr.splitlines()
                  if "warning" not in line and not re.fullmatch(r"endmill: .*\d s(, about .* left)?", line)]
        self.assertEqual(len(errors), 1, done.stderr)
        self.assertTrue(errors[0].startswith("endmill: error: "), errors[0])
        for word in words:
            self.assertIn(word, errors[0])

    def assert_nothing_left(self, *kept):
        """Asserts that the folder has exactly these files."""
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), sorted(kept))
