# SPDX-License-Identifier: GPL-3.0-or-later
"""The generators write the committed data, byte for byte."""
from fake_tree import ROOT, FakeTree

import generate_meshes
import generate_offset_curves
import generate_paths
import generate_surfaces


def files(folder):
    """The contents of all files below `folder`, by relative path."""
    return {path.relative_to(folder).as_posix(): path.read_bytes()
            for path in folder.rglob("*") if path.is_file()}


class Generators(FakeTree):
    def assert_writes(self, script, folder, data):
        """Asserts that a generator writes all files of `folder` except the README and `data`."""
        committed = files(ROOT / folder)
        self.assertEqual(self.check(script.main, [str(self.root)])[0], 0)
        written = files(self.root)
        self.assertEqual(sorted(written), sorted(committed.keys() - {"README.md", *data}))
        for name, content in written.items():
            self.assertEqual(content, committed[name], name)

    def test_surfaces_are_reproduced(self):
        data = {path.name for path in (ROOT / "datasets/surfaces").glob("net_*.json")}
        self.assert_writes(generate_surfaces, "datasets/surfaces",
                           data | {"fitted-nets-cells.csv"})

    def test_meshes_are_reproduced(self):
        self.assert_writes(generate_meshes, "datasets/meshes", {"teapot-288.off"})

    def test_offset_curves_are_reproduced(self):
        self.assert_writes(generate_offset_curves, "datasets/offset-curves",
                           {"vectors.json", "hard-cases.json", "random-families.json"})

    def test_paths_are_reproduced(self):
        self.assert_writes(generate_paths, "datasets/paths", set())

    def test_unknown_arguments_are_refused(self):
        for script in (generate_surfaces, generate_meshes, generate_offset_curves, generate_paths):
            for arguments, code in ((["--help"], 0), (["--nonsense"], 2), (["a", "b"], 2)):
                found, printed = self.check(script.main, arguments)
                self.assertEqual(found, code)
                self.assertIn("Usage", printed)
