# SPDX-License-Identifier: GPL-3.0-or-later
"""The data that scripts write is what is committed, byte for byte."""
from fake_tree import ROOT, FakeTree

import generate_meshes
import generate_surfaces


class Generators(FakeTree):
    def assert_writes(self, script, folder, data):
        """All files of `folder` but the README and `data`, and nothing else."""
        committed = {path.name: path.read_bytes() for path in (ROOT / folder).iterdir()}
        self.assertEqual(self.check(script.main, [str(self.root)])[0], 0)
        written = {path.name: path.read_bytes() for path in self.root.iterdir()}
        self.assertEqual(sorted(written), sorted(committed.keys() - {"README.md", *data}))
        for name, content in written.items():
            self.assertEqual(content, committed[name], name)

    def test_the_surfaces(self):
        data = {path.name for path in (ROOT / "datasets/surfaces").glob("net_*.json")}
        self.assert_writes(generate_surfaces, "datasets/surfaces",
                           data | {"fitted-nets-cells.csv"})

    def test_the_meshes(self):
        self.assert_writes(generate_meshes, "datasets/meshes", {"teapot-288.off"})

    def test_what_they_do_not_know_they_refuse(self):
        for script in (generate_surfaces, generate_meshes):
            for arguments, code in ((["--help"], 0), (["--nonsense"], 2), (["a", "b"], 2)):
                found, printed = self.check(script.main, arguments)
                self.assertEqual(found, code)
                self.assertIn("Usage", printed)
