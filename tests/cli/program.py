# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the program share: running it, and surfaces to run it on."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SURFACES = ROOT / "datasets/surfaces"
ENDMILL = os.environ.get("ENDMILL", str(ROOT / "build/release/src/cli/endmill"))


def endmill(*arguments, **options):
    """The finished process of one call. Ten minutes are a hang, also under sanitizers on a busy machine."""
    command = [ENDMILL, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=600,
                          stdin=subprocess.DEVNULL, **options)


def plane(patches_u=1, patches_v=1, size=(60, 30), slope=0):
    """A surface file, as a dictionary, of a plane that rises along x, with equal steps."""
    columns, rows = 3 * patches_u, 3 * patches_v
    net = [[[size[0] * i / columns, size[1] * j / rows, slope * size[0] * i / columns] for i in range(columns + 1)]
           for j in range(rows + 1)]
    return {"format": "endmill-surface/1", "name": "plane", "source": "a test", "type": "bezier",
            "patches_u": patches_u, "patches_v": patches_v, "control_points": net}


class ProgramTest(unittest.TestCase):
    """A test in a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, content, name="surface.json"):
        """The path of a file with that content: a text, bytes, or something for JSON."""
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def summary(self, *arguments, status=0):
        """What the program prints with --json, having ended with `status`."""
        done = endmill(*arguments, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return json.loads(done.stdout)

    def assert_refused(self, done, status, *words):
        """Exit status, one line of error with those words, nothing on standard output."""
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        errors = [line for line in done.stderr.splitlines() if "warning" not in line]
        self.assertEqual(len(errors), 1, done.stderr)
        self.assertTrue(errors[0].startswith("endmill: error: "), errors[0])
        for word in words:
            self.assertIn(word, errors[0])

    def assert_nothing_left(self, *kept):
        """The folder holds those files and no others."""
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), sorted(kept))
