# SPDX-License-Identifier: GPL-3.0-or-later
"""The data that scripts write is what is committed, byte for byte."""
from fake_tree import ROOT, FakeTree

import generate_meshes
import generate_offset_curves
import generate_surfaces


def files(folder):
    """The content of all files in `folder` and below, by path there."""
    return {path.relative_to(folder).as_posix(): path.read_bytes()
            for path in folder.rglob("*") if path.is_file()}


class Generators(FakeTree):
    def assert_writes(self, script, folder, data):
        """All files of `folder` but the README and `data`, and nothing else."""
        committed = files(ROOT / folder)
        self.assertEqual(self.check(script.main, [str(self.root)])[0], 0)
        written = files(self.root)
        self.assertEqual(sorted(written), sorted(committed.keys() - {"README.md", *data}))
        for name, content in written.items():
            self.assertEqual(content, committed[name], name)

    def test_the_surfaces(self):
        data = {path.name for path in (ROOT / "datasets/surfaces").glob("net_*.json")}
        self.assert_writes(generate_surfaces, "datasets/surfaces",
                           data | {"fitted-nets-cells.csv"})

    def test_the_meshes(self):
        self.assert_writes(generate_meshes, "datasets/meshes", {"teapot-288.off"})

    def test_the_offset_curves(self):
        self.assert_writes(generate_offset_curves, "datasets/offset-curves",
                           {"vectors.json", "hard-cases.json", "random-families.json"})

    def test_what_they_do_not_know_they_refuse(self):
        for script in (generate_surfaces, generate_meshes, generate_offset_curves):
            for arguments, code in ((["--help"], 0), (["--nonsense"], 2), (["a", "b"], 2)):
                found, printed = self.check(script.main, arguments)
                self.assertEqual(found, code)
                self.assertIn("Usage", printed)
