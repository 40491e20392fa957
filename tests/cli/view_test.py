# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill view: what a page holds, and what it refuses. tests/page looks at it in a browser."""
import base64
import json
import re
import struct
import unittest

from program import ROOT, SURFACES, ProgramTest, endmill

SADDLE = SURFACES / "saddle.json"
HAS_PAGE = "is missing" not in endmill("view", SADDLE, "-o", "/nowhere/none/page.html").stderr


def content_of(page):
    """The content of a page: the object and the block of numbers."""
    text = page.read_text(encoding="utf-8")
    content = re.search(r'id="content">(.*?)</script>', text, re.DOTALL).group(1)
    numbers = re.search(r'id="numbers">(.*?)</script>', text, re.DOTALL).group(1)
    return json.loads(content), base64.b64decode(numbers)


def array(reference, numbers):
    letter = {"float32": "f", "uint32": "I", "uint8": "B"}[reference["array"]]
    return struct.unpack_from(f"<{reference['length']}{letter}", numbers, reference["offset"])


@unittest.skipUnless(HAS_PAGE, "endmill was built without npm or esbuild")
class View(ProgramTest):
    def view(self, *sources):
        done = endmill("view", *sources, "-o", self.folder / "page.html", "--force", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return content_of(self.folder / "page.html")

    def refused(self, exit_code, words, *sources):
        done = endmill("view", *sources, "-o", self.folder / "page.html", cwd=self.folder)
        self.assertEqual(done.returncode, exit_code, done.stderr)
        self.assertRegex(done.stderr, words)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertFalse((self.folder / "page.html").exists())

    def planned(self, *options):
        folder = self.folder / "plan"
        done = endmill("plan", SADDLE, "--cutter", "ball:15", "--scallop", "1", "--strategy", "iso-u", *options,
                       "-o", folder, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return folder

    def path(self, rows):
        file = self.folder / "path.csv"
        file.write_text("pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm\n" + "".join(
            f"{k // 1000},{k % 1000},cut,{x!r},{y!r},{z!r}\n" for k, (x, y, z) in enumerate(rows)), encoding="utf-8")
        return file

    def test_points_are_those_of_the_path(self):
        rows = [(1e6 - 0.25 * k, 2.5, 1e-3 * (k % 3)) for k in range(50)]
        content, numbers = self.view(self.path(rows))
        tips = array(content["path"]["tips"], numbers)
        for k, row in enumerate(rows):
            for c in range(3):
                self.assertAlmostEqual(tips[3 * k + c] + content["origin_mm"][c], row[c], places=5)

    def test_a_million_points_are_reduced_and_the_page_says_so(self):
        rows = [(0.01 * (k % 1000), 0.1 * (k // 1000), 0.001 * ((k * k) % 7)) for k in range(200_000)]
        content, numbers = self.view(self.path(rows))
        path = content["path"]
        self.assertLessEqual(path["tips"]["length"], 3 * 50_000)
        self.assertRegex(path["note"], r"drawn with \d+ of its 200000 points; no tip is farther than")
        kept = array(path["numbers"], numbers)
        self.assertEqual(list(kept), sorted(set(kept)))

    def test_a_page_requests_nothing(self):
        self.view(self.planned())
        text = (self.folder / "page.html").read_text(encoding="utf-8")
        shell = re.sub(r"<script.*?</script>", "", text, flags=re.DOTALL)
        self.assertNotRegex(shell, r"(src|href)=|url\(|@import")
        self.assertIn("default-src 'none'", text)

    def test_html_writes_the_page_beside_the_results(self):
        folder = self.planned("--html")
        content, _ = content_of(folder / "page.html")
        self.assertEqual(content["title"], "saddle")
        self.assertIn("part", content)
        # without --html an old page would show other results
        self.planned("--force")
        self.assertFalse((folder / "page.html").exists())

    def test_coordinates_and_sizes_at_the_limits(self):
        for scale in (1e-3, 1, 1e5):
            mesh = self.folder / "one.obj"
            mesh.write_text(f"v 0 0 0\nv {scale} 0 0\nv 0 {scale} 0\nf 1 2 3\n", encoding="utf-8")
            content, numbers = self.view(mesh)
            points = array(content["part"]["points"], numbers)
            self.assertEqual(content["part"]["triangles"]["length"], 3)
            self.assertAlmostEqual((max(points) - min(points)) / scale, 1, places=6)

    def test_sources_that_do_not_exist_or_hold_nothing(self):
        self.refused(3, "cannot open", "missing.csv")
        (self.folder / "empty").mkdir()
        self.refused(3, "a folder without results", "empty")
        self.refused(2, "SOURCE")

    def test_damaged_results(self):
        folder = self.planned()
        done = endmill("verify", folder / "toolpath.csv", "--resolution", "2", "-o", "checked", cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        deviation = self.folder / "checked/deviation.vtp"
        whole = deviation.read_bytes()
        for length in (0, 100, len(whole) // 2, len(whole) - 1):
            deviation.write_bytes(whole[:length])
            self.refused(3, "deviation.vtp", folder, "checked")
        deviation.write_bytes(whole)
        (self.folder / "checked/summary.json").write_text("[1, 2", encoding="utf-8")
        self.refused(3, "summary.json: no JSON object", folder, "checked")
        (folder / "toolpath.csv").write_text("pass,point\n", encoding="utf-8")
        self.refused(3, "toolpath.csv", folder)

    def test_wrong_types_in_a_summary_do_no_harm(self):
        folder = self.planned()
        file = folder / "summary.json"
        whole = json.loads(file.read_text(encoding="utf-8"))
        for value in (None, 1, "x", [], {}, [1, "a"]):
            for key in ("name", "tolerance_mm", "scallop_limit_mm", "max_gouge_at", "tool_axis", "type", "toolpath"):
                file.write_text(json.dumps({**whole, key: value}), encoding="utf-8")
                done = endmill("view", folder, "-o", self.folder / "page.html", "--force", cwd=self.folder)
                self.assertIn(done.returncode, (0, 3), done.stderr)

    def test_the_visibility_of_another_part(self):
        teapot = ROOT / "datasets/meshes/teapot-288.off"
        done = endmill("setup", teapot, "--machine", "W/caxyBz/T", "--sphere", "hex:2", "-o", "setup", cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.refused(2, "a map of 288 facets", "setup", "--part", ROOT / "datasets/meshes/prism.off")

    def test_an_existing_page_is_kept_without_force(self):
        (self.folder / "page.html").write_text("mine", encoding="utf-8")
        done = endmill("view", SADDLE, "-o", self.folder / "page.html", cwd=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertEqual((self.folder / "page.html").read_text(encoding="utf-8"), "mine")

    def test_a_place_that_cannot_be_written(self):
        (self.folder / "file").write_text("", encoding="utf-8")
        done = endmill("view", SADDLE, "-o", self.folder / "file/page.html", cwd=self.folder)
        self.assertIn(done.returncode, (2, 5), done.stderr)


if __name__ == "__main__":
    unittest.main()
