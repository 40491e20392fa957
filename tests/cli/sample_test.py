# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill sample: compares the meshes of surfaces with endmill info and with closed forms."""
import math
import struct
import unittest

from program import SURFACES, ProgramTest, endmill, plane


class Sample(ProgramTest):
    def test_mesh_of_a_cylinder_has_its_area_within_the_bound(self):
        # The radius is 20 mm, the length 60 mm, with two arcs of 73.74 degrees: datasets/surfaces/README.md
        exact = 60 * 20 * 2 * math.acos(0.28)
        for tolerance in (0.5, 0.05, 0.005):
            facts = self.summary("sample", SURFACES / "cylinder.json", "--chord-tolerance", tolerance,
                                 "-o", self.folder / str(tolerance), "--format", "off")
            self.assertLessEqual(facts["max_chord_error_mm"], tolerance)
            mesh = self.summary("info", self.folder / str(tolerance) / "mesh.off")
            self.assertEqual(mesh["triangles"], facts["triangles"])
            self.assertEqual(mesh["vertices"], facts["vertices"])
            self.assertLess(mesh["area_mm2"], exact)
            self.assertGreater(mesh["area_mm2"], exact * (1 - tolerance / 20))

    def test_every_format_holds_the_same_mesh(self):
        areas = []
        for form, name in (("stl", "mesh.stl"), ("stl-ascii", "mesh.stl"), ("obj", "mesh.obj"),
                           ("ply", "mesh.ply"), ("off", "mesh.off")):
            folder = self.folder / form
            facts = self.summary("sample", SURFACES / "saddle.json", "--format", form, "-o", folder)
            self.assertEqual(facts["file"], name)
            self.assertEqual(sorted(path.name for path in folder.iterdir()), sorted([name, "summary.json"]))
            mesh = self.summary("info", folder / name)
            self.assertEqual(mesh["triangles"], facts["triangles"])
            areas.append(mesh["area_mm2"])
        for area in areas:
            self.assertAlmostEqual(area, areas[-1], delta=1e-6 * area)

    def test_grid_has_the_requested_points(self):
        facts = self.summary("sample", self.file(plane(2, 1)), "--grid", 5, "-o", self.folder / "out")
        self.assertEqual((facts["vertices"], facts["triangles"]), (25, 32))
        self.assertEqual(facts["max_chord_error_is"], "measured")

    def test_defaults_and_output_folder_are_reported(self):
        done = endmill("sample", self.file(plane()), cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 triangles, 4 points; chord tolerance 0.06 mm", done.stdout)
        self.assertIn("surface-sample", done.stdout)
        self.assertTrue((self.folder / "surface-sample/mesh.stl").exists())

    def test_mesh_does_not_depend_on_the_number_of_threads(self):
        texts = []
        for threads in (1, 2):
            folder = self.folder / str(threads)
            self.summary("sample", SURFACES / "net_rot24_7D.json", "--threads", threads, "-o", folder)
            texts.append((folder / "mesh.stl").read_bytes())
        self.assertEqual(texts[0], texts[1])
        count = struct.unpack("<I", texts[0][80:84])[0]
        self.assertEqual(len(texts[0]), 84 + 50 * count)

    def test_another_format_replaces_the_mesh_of_an_earlier_run(self):
        folder = self.folder / "out"
        self.summary("sample", SURFACES / "plane.json", "-o", folder)
        self.summary("sample", SURFACES / "plane.json", "-o", folder, "--format", "ply", "--force")
        self.assertEqual(sorted(path.name for path in folder.iterdir()), ["mesh.ply", "summary.json"])

    def test_invalid_options_are_refused(self):
        path = self.file(plane())
        for options, words in ((("--chord-tolerance", "0"), "above 0"), (("--grid", "1"), "2"),
                               (("--grid", "5", "--chord-tolerance", "1"), "--grid"),
                               (("--format", "step"), "stl")):
            self.assert_refused(endmill("sample", path, *options, cwd=self.folder), 2, words)
        self.assert_nothing_left("surface.json")

    def test_mesh_too_large_for_the_memory_is_refused_before_sampling(self):
        done = endmill("sample", SURFACES / "saddle.json", "--chord-tolerance", "1e-9", cwd=self.folder)
        self.assert_refused(done, 6, "triangles")
        done = endmill("sample", SURFACES / "saddle.json", "--chord-tolerance", "1e-4", "--max-memory",
                       "0.001", cwd=self.folder)
        self.assert_refused(done, 6, "triangles")
        self.assert_nothing_left()

    def test_mesh_as_input_is_refused(self):
        self.summary("sample", self.file(plane()), "-o", self.folder / "out")
        done = endmill("sample", self.folder / "out/mesh.stl", cwd=self.folder)
        self.assert_refused(done, 2, "found a mesh", "sample expects a surface file")


if __name__ == "__main__":
    unittest.main()
