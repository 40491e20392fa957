# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as parts, and parts of several patches."""
import csv
import unittest

from program import ROOT, SURFACES, ProgramTest, endmill

MESHES = ROOT / "datasets/meshes"

# A box of 1 by 2 by 3 mm, as six quadrangles that face outwards.
BOX = """v 0 0 0
v 1 0 0
v 1 2 0
v 0 2 0
v 0 0 3
v 1 0 3
v 1 2 3
v 0 2 3
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""


class MeshPart(ProgramTest):
    def test_box_has_its_size_area_and_volume(self):
        facts = self.summary("info", self.file(BOX, "box.obj"))
        self.assertEqual(facts["size_mm"], [1, 2, 3])
        self.assertAlmostEqual(facts["area_mm2"], 22, delta=1e-12)
        self.assertAlmostEqual(facts["volume_mm3"], 6, delta=1e-12)
        self.assertEqual((facts["triangles"], facts["vertices"], facts["components"]), (12, 8, 1))
        self.assertEqual((facts["boundary_edges"], facts["non_manifold_edges"]), (0, 0))
        self.assertEqual((facts["boundary_loops"], facts["boundary_mm"]), (0, 0))
        self.assertIsNone(facts["longest_boundary_loop_mm"])
        self.assertIsNone(facts["min_curvature_per_mm"])

    def test_edge_of_three_triangles_is_named(self):
        fan = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n"
        done = endmill("info", self.file(fan, "fan.obj"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("edges of more than two triangles: 1, the first between points [0,1]", done.stderr)

    def test_units_and_up_scale_and_rotate_the_mesh(self):
        facts = self.summary("info", self.file(BOX, "box.obj"), "--units", "inch", "--up", "x")
        self.assertEqual(sorted(facts["size_mm"]), sorted([25.4, 2 * 25.4, 3 * 25.4]))
        self.assertEqual(facts["size_mm"][2], 25.4)
        self.assertAlmostEqual(facts["volume_mm3"], 6 * 25.4**3, delta=1e-9)
        self.assertEqual((facts["units"], facts["up"]), ("inch", "x"))

    def test_open_mesh_has_no_volume(self):
        facts = self.summary("info", self.file(BOX.replace("f 5 6 7 8\n", ""), "box.obj"))
        self.assertIsNone(facts["volume_mm3"])
        self.assertEqual(facts["boundary_edges"], 4)
        # The missing face is 1 mm by 2 mm.
        self.assertEqual((facts["boundary_loops"], facts["boundary_mm"]), (1, 6))
        self.assertEqual(facts["longest_boundary_loop_mm"], 6)

    def test_triangles_that_face_inwards_are_reversed_and_counted(self):
        done = endmill("info", self.file(BOX.replace("f 5 6 7 8", "f 8 7 6 5"), "box.obj"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 triangles were turned over", done.stderr)
        self.assertIn("volume        6 mm3", done.stdout)

    def test_datasets_agree_with_their_readme(self):
        for name, triangles, volume in (("pocket.stl", 28, 40000), ("v-groove.stl", 24, 43680),
                                        ("prism.obj", 8, 18000), ("prism.ply", 8, 18000),
                                        ("prism.off", 8, 18000)):
            facts = self.summary("info", MESHES / name)
            self.assertEqual(facts["triangles"], triangles, name)
            self.assertAlmostEqual(facts["volume_mm3"], volume, delta=1e-9 * volume)
        self.assertEqual(self.summary("info", MESHES / "teapot-288.off")["boundary_edges"], 44)

    def test_plan_refuses_a_mesh(self):
        done = endmill("plan", self.file(BOX, "box.obj"), "--strategy", "iso", cwd=self.folder)
        self.assert_refused(done, 2, "box.obj: found a mesh", "plan expects a surface file")
        self.assert_nothing_left("box.obj")

    def test_require_g1_is_refused_for_a_mesh(self):
        self.assert_refused(endmill("info", self.file(BOX, "box.obj"), "--require", "g1"), 2, "mesh")

    def test_units_are_refused_for_a_surface(self):
        self.assert_refused(endmill("info", SURFACES / "plane.json", "--units", "inch"), 2, "--units")

    def test_name_that_contradicts_the_content_is_refused(self):
        done = endmill("info", self.file(BOX, "box.stl"))
        self.assert_refused(done, 3, "box.stl: content looks like OBJ")

    def test_unknown_words_of_an_obj_file_are_skipped_and_counted(self):
        done = endmill("info", self.file("c exported\n" + BOX + "c end\nbox 1 2 3\n", "box.obj"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("3 lines with unknown words were skipped: c (2), box (1)", done.stderr)
        self.assertIn("12 triangles", done.stdout)
        self.assert_refused(endmill("info", self.file("once upon\na time\n", "box.obj")), 3,
                            "box.obj:1", "no line begins with a word of OBJ")

    def test_formats_of_other_programs_are_refused_by_name(self):
        for name, content, words in (
                ("part.3mf", b"PK\x03\x04more", ("3MF is not read", "exported as .stl")),
                ("part.stl.gz", b"\x1f\x8b\x08\x00more", ("compressed", "gunzip"))):
            self.assert_refused(endmill("info", self.file(content, name), cwd=self.folder), 3, name, *words)

    def test_edges_are_counted_alike_in_every_command(self):
        # An edge of three triangles, a hole, and a triangle twice.
        odd = BOX.replace("f 5 6 7 8\n", "f 5 6 7\nf 5 6 7\n") + "v 0.5 1 9\nf 1 2 9\n"
        part = self.file(odd, "odd.obj")
        facts = self.summary("info", part)
        self.assertEqual((facts["boundary_edges"], facts["non_manifold_edges"], facts["duplicates"]), (5, 1, 1))
        report = endmill("info", part, cwd=self.folder).stdout
        self.assertIn("  edges         5 boundary edges in ", report)
        self.assertIn("; 1 edge of more than two triangles, ", report)
        self.assertEqual(len(report.splitlines()), 5)
        trimmed = self.summary("trim", part, "--cutter", "ball:1", "--planes", "2", "--grid", "9", "-o", "trim")
        remarks = " ".join(trimmed["remarks"])
        self.assertIn("edges of one triangle only: 5;", remarks)
        self.assertIn("edges of more than two triangles: 1,", remarks)
        done = endmill("setup", part, "--family", "AB", "--sphere", "hex:2", "--json", "-o", "setup", cwd=self.folder)
        self.assertIn("5 edges belong to one triangle", done.stdout)
        self.assertIn("1 edge belongs to more than two triangles", done.stdout)

    def test_bad_meshes_are_refused_with_their_place(self):
        for text, words in ((BOX.replace("f 1 4 3 2", "f 1 4 3 9"), ("box.obj:9", "9")),
                            (BOX.replace("v 0 0 3", "v 0 0 nan"), ("box.obj:5", "NaN")),
                            (BOX.replace("v 0 0 3", "v 0 0 1e7"), ("box.obj:5", "--max-extent"))):
            self.assert_refused(endmill("info", self.file(text, "box.obj")), 3, *words)


def patches(*nets):
    return {"format": "endmill-surface/1", "type": "bezier-patches", "name": "two", "patches": list(nets)}


LEFT = [[[0, 0, 0], [30, 0, 0]], [[0, 20, 0], [30, 20, 0]]]
RIGHT = [[[30, 0, 0], [60, 0, 10]], [[30, 20, 0], [60, 20, 10]]]


class SeveralPatches(ProgramTest):
    def test_info_reports_totals_and_the_break_between_patches(self):
        facts = self.summary("info", self.file(patches(LEFT, RIGHT)))
        self.assertEqual(facts["patches"], 2)
        self.assertEqual(facts["size_mm"], [60, 20, 10])
        self.assertAlmostEqual(facts["area_mm2"], 600 + 20 * (900 + 100) ** 0.5, delta=1e-9)
        self.assertEqual(facts["continuity"], "G0")
        self.assertAlmostEqual(facts["worst_break_deg"], 18.434948822922, delta=1e-9)
        self.assertIn("patch", facts["worst_break_at"])

    def test_plan_covers_each_patch_and_lifts_between_them(self):
        out = self.folder / "out"
        facts = self.summary("plan", self.file(patches(LEFT, RIGHT)), "--strategy", "iso", "--cutter", "ball:6",
                             "--mode", "paper", "--direction", "u", "-o", out)
        with open(out / "toolpath.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["patch"] for row in rows], sorted(row["patch"] for row in rows))
        lifts = [row["move"] for row in rows if row["u"] == ""]
        self.assertEqual(lifts, ["retract", "rapid"])
        self.assertEqual(facts["ncl"], len(rows) - 2)
        for row in rows:
            if row["u"]:
                self.assertEqual(int(row["patch"]), 1 if float(row["contact_x_mm"]) > 30 or
                                 row["patch"] == "1" else 0)

    def test_patch_that_the_tool_cannot_reach_is_named(self):
        wall = [[[60, 0, 10], [60, 0, -30]], [[60, 20, 10], [60, 20, -30]]]
        done = endmill("plan", self.file(patches(LEFT, RIGHT, wall)), cwd=self.folder)
        self.assert_refused(done, 4, "patch 2")


if __name__ == "__main__":
    unittest.main()
