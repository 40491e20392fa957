# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill view: what a page holds, and what it refuses. tests/page looks at it in a browser."""
import base64
import csv
import hashlib
import json
import math
import os
import re
import shutil
import struct
import subprocess
import unittest

from program import ENDMILL, ROOT, SURFACES, ProgramTest, endmill
from program import plane as plane_file

SADDLE = SURFACES / "saddle.json"
HAS_PAGE = "is missing" not in endmill("view", SADDLE, "-o", "/nowhere/none/page.html").stderr


def content_of(page):
    """The content of a page: the object and the block of numbers."""
    text = page.read_text(encoding="utf-8")
    content = re.search(r'id="content">(.*?)</script>', text, re.DOTALL).group(1)
    numbers = re.search(r'id="numbers">(.*?)</script>', text, re.DOTALL).group(1)
    return json.loads(content), base64.b64decode(numbers)


def array(reference, numbers):
    letter = {"float64": "d", "float32": "f", "uint32": "I", "uint8": "B"}[reference["array"]]
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
        errors = [line for line in done.stderr.splitlines() if not line.startswith("endmill: warning: ")]
        self.assertEqual(len(errors), 1, done.stderr)
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
        self.assertEqual([tips[3 * k:3 * k + 3] for k in range(len(rows))], rows)

    def test_a_million_points_are_reduced_and_the_page_says_so(self):
        rows = [(0.01 * (k % 1000), 0.1 * (k // 1000), 0.001 * ((k * k) % 7)) for k in range(200_000)]
        content, numbers = self.view(self.path(rows))
        path = content["path"]
        self.assertLessEqual(path["tips"]["length"], 3 * 50_000)
        self.assertRegex(path["note"], r"drawn with \d+ of its 200000 points; no tip is farther than")
        kept = array(path["numbers"], numbers)
        self.assertEqual(list(kept), sorted(set(kept)))

    def test_a_path_of_many_short_moves_is_reduced_too(self):
        file = self.folder / "path.csv"
        lines = [f"{k},0,{('cut', 'link')[k % 2]},{0.01 * (k % 1000)!r},{0.1 * (k // 1000)!r},0" for k in range(120_000)]
        file.write_text("pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm\n" + "\n".join(lines) + "\n", encoding="utf-8")
        content, _ = self.view(file)
        self.assertLessEqual(content["path"]["tips"]["length"], 3 * 50_000)
        self.assertRegex(content["path"]["note"], "of its 120000 points.*moves of several kinds are joined")

    def test_plots_keep_the_extremes_of_every_quantity(self):
        folder = self.folder / "fed"
        folder.mkdir()
        count = 30_000
        columns = ["cutting_force_n", "thrust_n", "torque_n_m", "power_w"]
        (folder / "toolpath.csv").write_text(
            "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,feed_mm_per_min\n" +
            "".join(f"0,{k},cut,{k},0,0,{100 + k % 7}\n" for k in range(count)), encoding="utf-8")
        loads = [[1.0] * count for _ in columns]
        for number, load in enumerate(loads):  # one peak and one hole each, at places of no other quantity
            load[1234 + 5000 * number] = 50.0 + number
            load[2341 + 5000 * number] = 0.5
        (folder / "engagement.csv").write_text(
            "pass,point,limit," + ",".join(columns) + "\n" +
            "".join(f"0,{k},,{','.join(str(load[k]) for load in loads)}\n" for k in range(count)), encoding="utf-8")
        content, numbers = self.view(folder)
        for series, load in zip(content["plots"]["series"][1:], loads):
            values = array(series["values"], numbers)
            self.assertEqual((min(values), max(values)), (min(load), max(load)), series["name"])
        self.assertRegex(content["plots"]["note"], r"have \d+ of 30000 points")

    def test_a_row_of_an_engagement_without_a_whole_number(self):
        folder = self.folder / "fed"
        folder.mkdir()
        for value in ("1e300", "0.5", "-7"):
            (folder / "toolpath.csv").write_text("pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm\n0,0,cut,0,0,0\n"
                                                 "0,1,cut,1,0,0\n", encoding="utf-8")
            (folder / "engagement.csv").write_text(f"pass,point,limit\n{value},1,\n", encoding="utf-8")
            self.refused(3, f"engagement.csv:2: pass {value}; expected a whole number", folder)

    def test_the_engagement_of_a_simulation_is_no_plot(self):
        folder = self.planned()
        done = endmill("verify", folder / "toolpath.csv", "--resolution", "2", "--engagement", "-o", "checked",
                       cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        content, _ = self.view("checked")
        self.assertIn("path", content)
        self.assertNotIn("plots", content)

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

    def test_a_file_that_needs_its_folder(self):
        folder = self.planned()
        self.refused(3, "summary.json: a single file of results; expected its folder, .*plan", folder / "summary.json")

    def test_a_page_may_be_called_htm(self):
        done = endmill("view", SADDLE, "-o", self.folder / "p.htm", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, "MB, part\nwritten to")
        self.assertTrue((self.folder / "p.htm").is_file())

    def test_a_link_to_the_folder_itself_is_not_followed(self):
        folder = self.planned()
        (folder / "01-a").symlink_to(".")
        (folder / "02-plan").mkdir()
        (folder / "02-plan/summary.json").write_text('{"name": "step"}', encoding="utf-8")
        content, _ = self.view(folder)
        self.assertEqual(len(content["summaries"]), 2)
        self.assertEqual(content["title"], "step")

    def test_a_deep_summary_is_refused(self):
        folder = self.planned()
        def nested(depth):
            return '{"name": "d", "a": ' + "[" * depth + "]" * depth + "}"
        for depth in (64, 100_000):
            (folder / "summary.json").write_text(nested(depth), encoding="utf-8")
            self.refused(3, "summary.json: .*nested more than 64 deep", folder)
        (folder / "summary.json").write_text(nested(63), encoding="utf-8")
        self.view(folder)

    def test_the_part_is_that_of_the_path(self):
        folder = self.planned()
        other = self.folder / "other"
        done = endmill("plan", SURFACES / "plane.json", "--cutter", "ball:10", "--scallop", "1", "--strategy", "iso-u",
                       "-o", other, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for first, second, part in ((other, folder, "saddle"), (folder, other, "plane")):
            done = endmill("view", first, second, "-o", self.folder / "page.html", "--force", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, rf"warning: {first}/summary.json: names the part .*; the page shows .*{part}.json")
            content, _ = content_of(self.folder / "page.html")
            self.assertRegex(dict(content["provenance"])["part"], f"{part}.json")

    def test_tolerances_are_those_of_the_remaining_stock_that_is_shown(self):
        folder = self.planned()
        for name, tolerance in (("coarse", "0.2"), ("fine", "0.02")):
            done = endmill("verify", folder / "toolpath.csv", "--resolution", "2", "--tolerance", tolerance, "-o", name,
                           cwd=self.folder)
            self.assertIn(done.returncode, (0, 1), done.stderr)
        for sources, tolerance in ((("coarse", "fine"), 0.02), (("fine", "coarse"), 0.2)):
            content, _ = self.view(folder, *sources)
            self.assertEqual(content["deviation"]["tolerance_mm"], tolerance)
            self.assertLessEqual(len(content["deviation"]["worst"]), 2)

    def test_a_named_path_is_sought_beside_the_summary_first(self):
        folder = self.planned()
        content, numbers = self.view(folder)
        tips = array(content["path"]["tips"], numbers)
        checked = self.folder / "job/checked"
        (self.folder / "job").mkdir()
        folder.rename(self.folder / "job/plan")
        done = endmill("verify", "plan/toolpath.csv", "--part", "none", "-o", "checked", cwd=self.folder / "job")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        # another path of the same name in the working folder
        (self.folder / "plan").mkdir()
        self.path([(0, 0, 0), (1, 0, 0)]).rename(self.folder / "plan/toolpath.csv")
        content, numbers = self.view("job/checked")
        self.assertEqual(array(content["path"]["tips"], numbers), tips)
        summary = checked / "summary.json"
        summary.write_text(json.dumps({**json.loads(summary.read_text(encoding="utf-8")), "toolpath_sha256": "0" * 64}),
                           encoding="utf-8")
        done = endmill("view", "job/checked", "-o", self.folder / "page.html", "--force", cwd=self.folder)
        self.assertRegex(done.stderr, "toolpath.csv: not the path of job/checked/summary.json")
        self.assertNotIn("path", content_of(self.folder / "page.html")[0])

    def judged_program(self):
        """A five-axis program alone in a folder, judged in another; and the tips of the path from which it was made."""
        machine = ["--machine", ROOT / "datasets/machines/ca-table-table.json", "--clamp", "5,6,7"]
        part = SURFACES / "gaussian-bump.json"
        for words in (["plan", part, "--axis-mode", "lead", "--cutter", "ball:10", "--direction", "u", "--scallop", "1",
                       "--inner-tolerance", "0.2", "-o", "bump"],
                      ["post", "bump/toolpath.csv", *machine, "--feed", "800", "--spindle-rpm", "6000", "-o", "post"]):
            done = endmill(*words, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
        (self.folder / "alone").mkdir()
        shutil.copy(self.folder / "post/toolpath.ngc", self.folder / "alone/p.ngc")
        done = endmill("verify", "alone/p.ngc", *machine, "--frame", "joint", "--cutter", "ball:10", "--part", part,
                       "--resolution", "2", "-o", "judged", "--html", cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        with open(self.folder / "bump/toolpath.csv", encoding="utf-8") as file:
            return [[float(row[f"tip_{axis}_mm"]) for axis in "xyz"] for row in csv.DictReader(file)]

    def test_a_program_judged_with_machine_is_shown_with_it(self):
        planned = self.judged_program()
        content, numbers = content_of(self.folder / "judged/page.html")
        self.assertEqual(content["machine"]["word"], "W/caxyBz/T")
        tips = array(content["path"]["tips"], numbers)
        tips = [tips[k:k + 3] for k in range(0, len(tips), 3)]
        for tip in planned:  # the program passes them, within its digits and the path's drawing
            self.assertLess(min(math.dist(tip, at) for at in tips), 1e-3)
        for sources in (["judged"], ["alone/p.ngc", "judged"]):
            self.assertEqual(self.view(*sources)[0]["machine"], content["machine"])
        # the options of view name the machine too
        (self.folder / "page.html").unlink()
        self.refused(3, r"expected A0, or the machine of the program \(--machine", "alone/p.ngc")
        options = ["--machine", ROOT / "datasets/machines/ca-table-table.json", "--clamp", "5,6,7", "--frame", "joint"]
        self.assertEqual(self.view("alone/p.ngc", *options)[0]["machine"]["rotary"], content["machine"]["rotary"])

    def test_a_machine_without_a_path_has_no_effect(self):
        self.refused(2, "--machine: has no effect with no path", SADDLE, "--machine", "W/caxyBz/T")

    def test_wrapped_words_are_read_as_verify_read_them(self):
        lines = [f"G1 X{k} C{10 * k % 360}" for k in range(80)]
        (self.folder / "p.ngc").write_text("G21 G90\nS1000 M3\nG0 X0 Y0 Z5 A0 C0\nF100\n" + "\n".join(lines) + "\nM2\n",
                                           encoding="utf-8")
        turns = {}
        for name, options in (("full", []), ("wrapped", ["--wrapped", "c:shortest"])):
            done = endmill("verify", "p.ngc", "--machine", "W/caxyBz/T", "--frame", "joint", "--cutter", "ball:10", "--part",
                           "none", "--resolution", "5", *options, "-o", name, "--html", cwd=self.folder)
            self.assertIn(done.returncode, (0, 1), done.stderr)
            content, numbers = content_of(self.folder / f"{name}/page.html")
            positions = array(content["path"]["positions"], numbers)
            turns[name] = max(abs(b - a) for axis in (3, 4) for a, b in
                              zip(positions[axis::5], positions[axis + 5::5]))
        self.assertAlmostEqual(turns["full"], 350, places=6)
        self.assertAlmostEqual(turns["wrapped"], 10, places=6)

    def test_a_program_of_the_centre_is_shown_by_its_tips(self):
        (self.folder / "p.ngc").write_text("G21 G90\nS1000 M3\nG0 X0 Y0 Z9\nF100\nG1 X1 Z6\nG1 X9\nM2\n", encoding="utf-8")
        done = endmill("verify", "p.ngc", "--cutter", "ball:10", "--programmed-point", "centre", "--part", "none", "-o",
                       "judged", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        content, numbers = self.view("judged")
        self.assertEqual(array(content["path"]["tips"], numbers)[-3:], (9, 0, 1))
        # a summary starts no other program
        summary = self.folder / "judged/summary.json"
        summary.write_text(summary.read_text(encoding="utf-8").replace('"interpreter": "endmill"', '"interpreter": "linuxcnc"'),
                           encoding="utf-8")
        done = endmill("view", "judged", "-o", "read.html", cwd=self.folder, env={**os.environ, "PATH": "/nowhere"})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the page shows it as endmill reads it", done.stderr)

    def test_verify_states_the_path_that_it_judged_and_another_one_is_named(self):
        folder = self.planned()
        path = folder / "toolpath.csv"
        done = endmill("verify", path, "--resolution", "2", "-o", "checked", cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        found = json.loads((self.folder / "checked/summary.json").read_text(encoding="utf-8"))
        self.assertEqual(found["toolpath_sha256"], hashlib.sha256(path.read_bytes()).hexdigest())

        def warned(*sources):
            done = endmill("view", *sources, "-o", self.folder / "page.html", "--force", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            note = content_of(self.folder / "page.html")[0]["deviation"].get("note", "")
            self.assertEqual("is that of another path" in done.stderr, "is that of another path" in note)
            return bool(note)

        self.assertFalse(warned(folder, "checked"))
        done = endmill("post", path, "--feed", "100", "--spindle-rpm", "1000", "-o", "post", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse(warned(folder, "post", "checked"))  # the program of this path
        self.path([(0, 0, 0), (9, 9, 0)])
        self.assertTrue(warned("path.csv", "checked"))
        path.write_text(path.read_text(encoding="utf-8").replace("cut", "link", 1), encoding="utf-8")
        self.assertTrue(warned(folder, "checked"))

    def test_results_of_a_tilted_axis_lie_on_the_part(self):
        plane = self.file({**plane_file(), "name": "flat"})
        done = endmill("plan", plane, "--cutter", "ball:10", "--scallop", "1", "--axis", "0.3,0.2,1", "--strategy", "iso-u",
                       "-o", "plan", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = endmill("verify", "plan/toolpath.csv", "--resolution", "2", "-o", "checked", cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        content, numbers = self.view("plan", "checked")
        heights = array(content["deviation"]["points"], numbers)[2::3]
        for z in heights:  # of a plane z = 0, relative to the origin of the page
            self.assertAlmostEqual(z + content["origin_mm"][2], 0, places=4)
        for place in content["deviation"]["worst"]:
            self.assertAlmostEqual(place["point_mm"][2] + content["origin_mm"][2], 0, places=4)

    def test_units_and_up_of_a_source(self):
        mesh = self.folder / "one.stl"
        mesh.write_text("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 0\nendloop\n"
                        "endfacet\nendsolid a\n", encoding="utf-8")
        def sizes(*options):
            content, numbers = self.view(mesh, *options)
            points = array(content["part"]["points"], numbers)
            return [max(points[c::3]) - min(points[c::3]) for c in range(3)]
        self.assertEqual([round(size, 4) for size in sizes("--units", "inch")], [50.8, 25.4, 0])
        self.assertEqual([round(size, 4) for size in sizes("--up", "y")], [2, 0, 1])

    def test_sections_have_the_planes_that_occur_with_their_positions(self):
        for degrees in (0, 30):
            folder = self.folder / f"trimmed{degrees}"
            done = endmill("trim", SURFACES / "valley.json", "--cutter", "ball:20", "--planes", "4", "--direction-deg",
                           degrees, "-o", folder, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            planes = self.view(folder)[0]["sections"]["planes"]
            self.assertEqual([plane["number"] for plane in planes], [0, 1, 2, 3])
            steps = [b["position_mm"] - a["position_mm"] for a, b in zip(planes, planes[1:])]
            # planes of one distance, apart from each other by the pitch of the summary
            pitch = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["pitch_mm"]
            for step in steps:
                self.assertAlmostEqual(abs(step), pitch, places=6)
        file = folder / "sections.csv"
        lines = file.read_text(encoding="utf-8").splitlines()
        moved = [re.sub("^2,", "9999999,", line) for line in lines]
        file.write_text("\n".join(moved) + "\n", encoding="utf-8")
        planes = self.view(folder)[0]["sections"]["planes"]
        self.assertEqual([plane["number"] for plane in planes], [0, 1, 2, 3, 9999999])
        self.assertEqual((planes[2]["before"], planes[4]["after"]), ([], [[]]))
        for value in ("1e300", "-1", "0.5"):
            file.write_text("\n".join([lines[0], re.sub("^0,", f"{value},", lines[1])]) + "\n", encoding="utf-8")
            done = endmill("view", folder, "-o", self.folder / "page.html", "--force", cwd=self.folder)
            self.assertEqual(done.returncode, 3)
            self.assertRegex(done.stderr, f"sections.csv:2: plane {value}; expected a whole number")

    def test_sections_of_all_methods_with_the_path_of_the_exact_one(self):
        for options in ([], ["--figure", "worst"]):
            folder = self.folder / f"methods{len(options)}"
            done = endmill("trim", SURFACES / "valley.json", "--cutter", "ball:20", "--planes", "3", "--method", "all", *options,
                           "-o", folder, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            content, numbers = self.view(folder)
            self.assertEqual(content["sections"]["methods"], ["1", "2", "3", "3r", "envelope", "winding"])
            with open(folder / "envelope/toolpath.csv", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            last = array(content["path"]["tips"], numbers)[-3:]
            self.assertEqual(list(last), [float(rows[-1][f"tip_{axis}_mm"]) for axis in "xyz"])
            self.assertTrue(all(plane["position_mm"] > 0 for plane in content["sections"]["planes"]))
        (folder / "1/trimmed.csv").write_text("x\n", encoding="utf-8")
        (self.folder / "page.html").unlink()
        self.refused(3, "1/trimmed.csv:1: no column plane; expected plane,curve", folder)
        for method in content["sections"]["methods"]:
            shutil.rmtree(folder / method)
        (folder / "sections.csv").unlink()
        done = endmill("view", folder, "-o", self.folder / "page.html", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, "warning: the sources hold nothing that can be drawn")

    def test_a_build_without_the_page_refuses_html_before_the_work(self):
        program = self.folder / "alone/endmill"
        program.parent.mkdir()
        shutil.copy(ENDMILL, program)
        done = subprocess.run([program, "plan", SADDLE, "--cutter", "ball:15", "--html", "-o", "plan"], cwd=self.folder,
                              capture_output=True, text=True, check=False, timeout=600)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, "the script of the page is missing")
        self.assertFalse((self.folder / "plan").exists())

    def test_a_long_value_is_cut(self):
        folder = self.planned()
        file = folder / "summary.json"
        file.write_text(json.dumps({**json.loads(file.read_text(encoding="utf-8")), "long": "x" * 1000}), encoding="utf-8")
        rows = dict(self.view(folder)[0]["summaries"][0]["rows"])
        self.assertRegex(rows["long"], "^x{300}…$")

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
