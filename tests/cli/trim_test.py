# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill trim: results for surfaces, meshes and curves, and refused input."""
import csv
import json
import math
import statistics
import struct
import unittest

from program import ROOT, ProgramTest, endmill, plane

VALLEY = ROOT / "datasets/surfaces/valley.json"
MESHES = ROOT / "datasets/meshes"
# docs/methods/interference.md, section 11, T1: one symmetric loop that crosses itself at (0, 0).
LOOP = "s_mm,z_mm\n-6,6\n2,-2\n0,-1\n-2,-2\n6,6\n"

# A cube of 10 mm that faces outwards.
CUBE = """v 0 0 0
v 10 0 0
v 10 10 0
v 0 10 0
v 0 0 10
v 10 0 10
v 10 10 10
v 0 10 10
f 1 3 2
f 1 4 3
f 5 6 7
f 5 7 8
f 1 2 6
f 1 6 5
f 2 3 7
f 2 7 6
f 3 4 8
f 3 8 7
f 4 1 5
f 4 5 8
"""


def stl(count, triangles):
    """A binary STL file whose header states `count` triangles."""
    return bytes(80) + struct.pack("<I", count) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *sum(triangle, ()), 0) for triangle in triangles)


def table(path):
    with open(path, encoding="ascii", newline="") as file:
        return list(csv.DictReader(file))


def distance(point, first, last):
    """Distance of a point from a segment."""
    along = [b - a for a, b in zip(first, last)]
    squared = sum(c * c for c in along)
    share = sum((p - a) * c for p, a, c in zip(point, first, along)) / squared if squared > 0 else 0
    share = min(1, max(0, share))
    return math.dist(point, [a + share * c for a, c in zip(first, along)])


class Trim(ProgramTest):
    def test_loop_of_a_curve_is_removed(self):
        facts = self.summary("trim", "--polyline", self.file(LOOP, "t1.csv"), "-o", "out", "--explain")
        self.assertEqual((facts["planes"], facts["curves"], facts["trimmed_points"], facts["loops"]), (1, 1, 3, 1))
        self.assertIsNone(facts["min_clearance_mm"])
        self.assertIsNone(facts["max_gouge_mm"])
        out = self.folder / "out"
        left = [(row["s_mm"], row["z_mm"]) for row in table(out / "trimmed.csv")]
        self.assertEqual(left, [("-6", "6"), ("0", "0"), ("6", "6")])
        [loop] = table(out / "loops.csv")
        self.assertEqual([loop[key] for key in ("plane", "curve", "s_mm", "z_mm", "first_point", "last_point", "cause")],
                         ["0", "0", "0", "0", "1", "3", "fold"])
        self.assertIn("rule", loop)
        self.assertEqual(len(table(out / "sections.csv")), 5)
        self.assertFalse((out / "toolpath.csv").exists())

    def test_all_methods_agree_on_a_plain_loop(self):
        facts = self.summary("trim", "--polyline", self.file(LOOP, "t1.csv"), "--method", "all", "-o", "out")
        names = ["1", "2", "3", "3r", "envelope", "winding"]
        self.assertEqual(list(facts["methods"])[:6], names)
        for name in names:
            last = [row["z_mm"] for row in table(self.folder / "out" / name / "trimmed.csv")]
            self.assertEqual((len(last), last[0], last[-1]), (3, "6", "6"), name)
            self.assertEqual(facts["methods"][name]["wrong_sections"], 0, name)
            self.assertLess(facts["methods"][name]["max_below_envelope_mm"], 1e-9, name)

    def test_fold_that_is_left_is_reported(self):
        # docs/methods/interference.md, section 11, T5: nested loops with two steps back in s. The guarded
        # methods keep them.
        wide = "s_mm,z_mm\n-10,10\n4,-4\n-2,-3\n0,-3.6\n2,-3.1\n-4,-4\n10,10\n"
        done = endmill("trim", "--polyline", self.file(wide, "w.csv"), "--method", "3", "--json", "-o", "out",
                       cwd=self.folder)
        facts = json.loads(done.stdout)
        self.assertEqual((done.returncode, facts["unresolved"], facts["loops"]), (1, 2, 0), done.stderr)
        done = endmill("trim", "--polyline", "w.csv", "--method", "3", cwd=self.folder)
        self.assertRegex(done.stdout, r"folds +2 left")
        self.assertIn("w.csv: the path fails: method 3 with --mode corrected leaves 2 folds; --method envelope", done.stderr)

    def test_known_gouge_exits_1_and_names_the_better_method(self):
        done = endmill("trim", VALLEY, "--cutter", "ball:20", "--grid", "60", "--planes", "12", "--mode", "paper",
                       cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        errors = [line for line in done.stderr.splitlines() if "error" in line]
        self.assertEqual(len(errors), 1, done.stderr)
        for word in ("method 3 with --mode paper gouges the part", "--tolerance 0.01 mm", "--method envelope"):
            self.assertIn(word, errors[0])

    def test_path_of_a_surface_is_accepted_by_verify(self):
        facts = self.summary("trim", VALLEY, "--cutter", "ball:20", "--grid", "60", "--planes", "12", "--tolerance",
                             "0.05", "-o", "out", "--figure", "10")
        self.assertEqual((facts["planes"], facts["unresolved"]), (12, 0))
        self.assertGreater(facts["loops"], 0)
        self.assertLess(facts["max_gouge_mm"], 0.05)
        out = self.folder / "out"
        points = [(row["move"], [float(row[f"tip_{axis}_mm"]) for axis in "xyz"]) for row in table(out / "toolpath.csv")]
        lengths = dict.fromkeys(("cut", "plunge", "link", "retract", "rapid"), 0.0)
        for (_, before), (move, behind) in zip(points, points[1:]):
            lengths[move] += math.dist(before, behind)
        self.assertAlmostEqual(facts["cut_mm"], lengths["cut"], delta=1e-6)
        self.assertAlmostEqual(facts["plunge_mm"], lengths["plunge"], delta=1e-6)
        self.assertAlmostEqual(facts["link_mm"], lengths["link"] + lengths["retract"], delta=1e-6)
        self.assertAlmostEqual(facts["rapid_mm"], lengths["rapid"], delta=1e-6)
        self.assertEqual(facts["points"], len(points))
        # Points are numbered through the path, as the messages of verify count them.
        numbers = [int(row["point"]) for row in table(out / "toolpath.csv")]
        self.assertEqual(numbers, list(range(len(points))))
        seen = self.summary("info", out / "toolpath.csv", "-o", "seen")
        for key in ("points", "cut_mm", "plunge_mm", "link_mm", "rapid_mm", "time_min", "min_mm", "max_mm"):
            self.assertEqual(facts[key], seen[key], key)
        self.assertEqual(facts["safe_height_mm"], max(tip[2] for _, tip in points))
        self.assertAlmostEqual(facts["pitch_mm"], 100 / 12, delta=1e-9)
        # The scallop between two circles of radius 10 mm at the pitch of the planes.
        self.assertAlmostEqual(facts["level_scallop_mm"], 10 - math.sqrt(100 - (50 / 12) ** 2), delta=1e-9)
        for name in ("section-10.svg", "trimmed.svg"):
            self.assertIn("<svg", (out / name).read_text(encoding="utf-8"))
        judged = endmill("verify", out / "toolpath.csv", "--part", VALLEY, "--cutter", "ball:20", "--resolution", "1",
                         "--tolerance", "0.1", "--scallop", "20", "--json", "-o", "judged", cwd=self.folder)
        self.assertEqual(judged.returncode, 0, judged.stderr + judged.stdout)

    def test_picture_of_a_section_shows_the_part(self):
        curves = self.file(LOOP, "t1.csv")
        dome = ROOT / "datasets/meshes/dome.stl"
        for words, has_part in (((VALLEY, "--cutter", "flat:8", "--tolerance", "1"), True),
                                ((dome, "--cutter", "ball:4"), True),
                                (("--polyline", curves), False)):
            self.summary("trim", *words, *([] if curves in words else ["--grid", "30", "--planes", "3"]),
                         "--figure", "0", "-o", "out", "--force")
            drawn = (self.folder / "out/section-0.svg").read_text(encoding="utf-8")
            self.assertEqual(">part<" in drawn, has_part, words)

    def test_refined_points_do_not_depend_on_the_grid(self):
        heights = []
        for grid in ("60", "90"):
            facts = self.summary("trim", VALLEY, "--cutter", "ball:20", "--grid", grid, "--planes", "3", "--refine",
                                 "--boundary", "none", "-o", grid)
            self.assertIn("unrefined", facts)
            rows = [row for row in table(self.folder / grid / "trimmed.csv") if row["plane"] == "2"]
            middle = min(rows, key=lambda row: abs(float(row["s_mm"]) - 50))
            heights.append((float(middle["s_mm"]), float(middle["z_mm"])))
        # The lowest point of a section of the valley is its crossing, which is the same on both grids.
        self.assertAlmostEqual(heights[0][0], heights[1][0], delta=1e-6)
        self.assertAlmostEqual(heights[0][1], heights[1][1], delta=1e-4)

    def test_explain_gives_the_rule_of_every_loop(self):
        known = {"below the envelope", "winding number", "valley", "E1", "E2", "E3", "P3", "P4", "P3 cut", "P4 cut",
                 "closed", "outside the range"}
        for method, own in (("envelope", "below the envelope"), ("winding", "winding number"), ("3r", "valley")):
            self.summary("trim", VALLEY, "--cutter", "ball:20", "--grid", "40", "--planes", "9", "--tolerance", "1",
                         "--method", method, "--explain", "-o", "out", "--force")
            rules = {loop["rule"] for loop in table(self.folder / "out/loops.csv")}
            self.assertLessEqual(rules, known)
            self.assertLessEqual({own, "outside the range"}, rules)

    def test_folds_outside_the_range_are_not_reported(self):
        def sheet(x, low, high):
            return [[[x, -20, low], [x + 20, -20, high]], [[x, 20, low], [x + 20, 20, high]]]
        roof = {"format": "endmill-surface/1", "type": "bezier-patches", "name": "roof",
                "patches": [sheet(-20, -10, 0), sheet(0, 0, -10)]}
        words = ("trim", self.file(roof), "--cutter", "bull:10:2", "--direction-deg", "37", "--planes", "7", "--grid",
                 "30")
        paths = []
        for method in ("3r", "envelope"):
            facts = self.summary(*words, "--method", method, "-o", method)
            self.assertEqual(facts["unresolved"], 0)
            paths.append([(row["plane"], row["s_mm"], row["z_mm"])
                          for row in table(self.folder / method / "trimmed.csv")])
        self.assertEqual(paths[0], paths[1])

    def test_removed_loops_end_at_trimmed_points(self):
        for number, words in enumerate(((), ("--refine",), ("--method", "3r", "--direction-deg", "-15"))):
            out = self.folder / str(number)
            self.summary("trim", VALLEY, "--cutter", "ball:20", "--grid", "40", "--planes", "9", "--tolerance", "1",
                         "-o", out, *words)
            left = {(row["plane"], row["s_mm"], row["z_mm"]) for row in table(out / "trimmed.csv")}
            loops = table(out / "loops.csv")
            self.assertGreaterEqual(len(loops), 18)
            for loop in loops:
                self.assertIn((loop["plane"], loop["s_mm"], loop["z_mm"]), left, words)

    def test_drop_cutter_follows_a_mesh(self):
        mesh = ROOT / "datasets/meshes"
        part = sorted(mesh.glob("*.stl"))[0]
        facts = self.summary("trim", part, "--cutter", "ball:4", "--planes", "5", "--grid", "30", "-o", "out")
        self.assertGreaterEqual(facts["min_clearance_mm"], -0.01)
        out = self.folder / "out"
        self.assertEqual((out / "sections.csv").read_text(), (out / "trimmed.csv").read_text())
        self.assertEqual((out / "loops.csv").read_text(), "plane,curve,s_mm,z_mm,first_point,last_point,cause\n")
        self.assert_refused(endmill("trim", part, "--cutter", "ball:4", "--method", "3", cwd=self.folder), 2, "needs a surface")
        facts = self.summary("trim", part, "--cutter", "ball:4", "--planes", "2", "--grid", "30", "--method", "all",
                             "-o", "all")
        self.assertEqual(list(facts["methods"]), ["envelope"])
        self.assertEqual(facts["not_run"][:5], ["1", "2", "3", "3r", "winding"])

    def test_mesh_path_is_accepted_by_verify_with_the_limits_of_its_summary(self):
        # The cutter cannot touch the inner corners of pocket and groove and the foot of the dome. The roof has none.
        for name, is_reported in (("prism.obj", False), ("v-groove.stl", True), ("pocket.stl", True)):
            facts = self.summary("trim", MESHES / name, "--cutter", "ball:6", "--scallop", "0.2", "-o", "path", "--force")
            self.assertEqual((facts["scallop_mm"], facts["inner_tolerance_mm"], facts["outer_tolerance_mm"]),
                             (0.2, 0.01, 0.01), name)
            judged = self.summary("verify", "path/toolpath.csv", "--resolution", "0.5", "-o", "judged", "--force")
            self.assertEqual(judged["verdict"], "clean", name)
            self.assertAlmostEqual(judged["scallop_limit_mm"], 0.21, delta=1e-12)
            self.assertEqual(judged["inaccessible_area_mm2"] > 0, is_reported, name)
            self.summary("post", "path/toolpath.csv", "--feed", "500", "--decimals", "6", "-o", "posted", "--force")
            judged = self.summary("verify", "posted/toolpath.ngc", "--resolution", "0.5", "-o", "judged", "--force")
            self.assertEqual(judged["verdict"], "clean", name)
        done = endmill("verify", "path/toolpath.csv", "--resolution", "0.5", "--inaccessible", "count", "--json",
                       "-o", "counted", cwd=self.folder)
        counted = json.loads(done.stdout)
        self.assertEqual((done.returncode, counted["verdict"], counted["inaccessible_area_mm2"]), (1, "uncut", 0))
        # In a corner of three faces a ball of radius R leaves R (1 - 1 / sqrt 3) along the normal of each.
        self.assertAlmostEqual(counted["max_scallop_mm"], 3 * (1 - 3 ** -0.5), delta=0.12)

    def test_report_of_inaccessible_stock_needs_a_mesh(self):
        self.summary("trim", VALLEY, "--cutter", "ball:20", "--grid", "40", "--planes", "5", "--tolerance", "1", "-o",
                     "path")
        done = endmill("verify", "path/toolpath.csv", "--inaccessible", "report", cwd=self.folder)
        self.assert_refused(done, 2, "--inaccessible report", "expected a mesh")

    def test_planes_are_added_on_slopes_across_the_feed_only(self):
        words = ("trim", MESHES / "prism.obj", "--cutter", "ball:6", "--scallop", "0.1")
        self.assertEqual(self.summary(*words, "-o", "along")["added_planes"], 0)
        self.assertGreater(self.summary(*words, "--direction-deg", "90", "-o", "across")["added_planes"], 10)

    def test_thinned_path_stays_within_its_tolerance(self):
        # Every vertex of trimmed.csv is near the chords of the path, and every vertex of the path is one of them.
        for part, words in ((MESHES / "pocket.stl", ("--cutter", "ball:6")),
                            (VALLEY, ("--cutter", "ball:20", "--grid", "60", "--tolerance", "0.05"))):
            facts = self.summary("trim", part, *words, "--planes", "9", "-o", "out", "--force")
            tolerance = facts["tolerance_mm"] / 10
            self.assertAlmostEqual(facts["thin_tolerance_mm"], tolerance, delta=1e-12)
            self.assertLessEqual(facts["thinned_within_mm"], facts["thin_tolerance_mm"])
            self.assertLessEqual(facts["max_gouge_mm"] + facts["thinned_within_mm"], facts["tolerance_mm"])
            out = self.folder / "out"
            radius = float(words[1].split(":")[1]) / 2
            curves = {}
            for row in table(out / "trimmed.csv"):
                at = tuple(float(row[key]) for key in ("x_mm", "y_mm", "z_mm"))
                curves.setdefault((int(row["plane"]), int(row["curve"])), []).append(at)
            passes = {}
            for row in table(out / "toolpath.csv"):
                if row["move"] in ("plunge", "cut"):
                    tip = [float(row[f"tip_{axis}_mm"]) for axis in "xyz"]
                    passes.setdefault(int(row["pass"]), []).append((tip[0], tip[1], tip[2] + radius))
            self.assertEqual(facts["thinned_points"], sum(map(len, curves.values())) - sum(map(len, passes.values())))
            self.assertGreater(facts["thinned_points"], 0)
            for number, key in enumerate(sorted(curves)):  # passes of a zigzag: planes in their order
                points = curves[key] if key[0] % 2 == 0 else curves[key][::-1]
                kept = passes[number]
                corners = [min(range(len(points)), key=lambda k, at=at: math.dist(points[k], at)) for at in kept]
                self.assertEqual(corners, sorted(corners))
                for (a, b), (first, last) in zip(zip(corners, corners[1:]), zip(kept, kept[1:])):
                    self.assertLess(math.dist(points[a], first), 1e-9)
                    for point in points[a + 1:b]:
                        self.assertLessEqual(distance(point, first, last), tolerance + 1e-9)
        facts = self.summary("trim", MESHES / "pocket.stl", "--cutter", "ball:6", "--planes", "3", "--thin-tolerance",
                             "0", "-o", "all")
        self.assertEqual((facts["thinned_points"], facts["thinned_within_mm"]), (0, 0))

    def test_report_has_at_most_five_lines(self):
        for words in ((MESHES / "pocket.stl", "--scallop", "0.2", "--cutter", "ball:6"),
                      (VALLEY, "--planes", "5", "--grid", "40", "--cutter", "ball:20", "--tolerance", "1")):
            done = endmill("trim", *words, "-o", "out", "--force", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertLessEqual(len(done.stdout.splitlines()), 5, done.stdout)
            self.assertRegex(done.stdout, r"; path of \d+ points, \d+ more within .* mm of a chord\n  path +cuts [\d.]+ mm, ")

    def test_path_that_fails_says_where_and_what_cures_it(self):
        words = ("trim", VALLEY, "--cutter", "ball:20", "--grid", "30", "--planes", "12", "--tolerance", "0.001")
        done = endmill(*words, "-o", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertRegex(done.stderr, r"the path fails: .* in plane \d+ \(t = \S+ mm\) at x \S+ y \S+ z \S+; "
                                      r"--refine moves the points")
        done = endmill(*words, "--refine", "-o", "refined", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_files_do_not_depend_on_the_number_of_threads(self):
        texts = []
        for threads in ("1", "2", "3"):
            self.summary("trim", VALLEY, "--cutter", "bull:20:3", "--grid", "40", "--planes", "7", "--tolerance", "1",
                         "--threads", threads, "-o", threads)
            out = self.folder / threads
            texts.append([(out / name).read_bytes() for name in ("toolpath.csv", "loops.csv", "sections.csv")])
        self.assertEqual(texts[0], texts[1])
        self.assertEqual(texts[0], texts[2])

    def test_contacts_on_the_border_prevent_gouges(self):
        # docs/methods/interference.md, section 11, A10. The grid of 100 lines has four times the chord
        # error of the 200 lines there.
        words = ("trim", VALLEY, "--cutter", "ball:20", "--grid", "100", "--direction-deg", "-15")
        for method in ("envelope", "winding"):
            facts = self.summary(*words, "--method", method, "--tolerance", "0.008", "-o", "out", "--force")
            self.assertEqual((facts["planes"], facts["unresolved"]), (100, 0))
            self.assertLess(facts["max_gouge_mm"], 0.008)
        done = endmill(*words, "--boundary", "none", "--json", "-o", "none", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertGreater(json.loads(done.stdout)["max_gouge_mm"], 1)

    def compared(self, *words, repeat=3):
        """Runs the comparison of all methods on the valley and returns its summary."""
        return self.summary("trim", VALLEY, "--cutter", "ball:20", "--grid", "60", "--planes", "12", "--tolerance",
                            "0.05", "--method", "all", "--repeat", repeat, "-o", "out", *words)["comparison"]

    def test_comparison_states_the_quartiles_of_the_measured_times(self):
        facts = self.compared(repeat=5)
        self.assertEqual(facts["repetitions"], 5)
        rows = table(self.folder / "out/times.csv")
        self.assertEqual(len(rows), 5 * 6)
        for method, stated in facts["measured"].items():
            times = [float(row["measured_ms"]) for row in rows if row["method"] == method]
            quartiles = statistics.quantiles(times, n=4, method="inclusive")
            self.assertGreater(min(times), 0)
            for key, expected in (("median_ms", statistics.median(times)), ("lower_quartile_ms", quartiles[0]),
                                  ("upper_quartile_ms", quartiles[2]), ("least_ms", min(times)),
                                  ("greatest_ms", max(times))):
                self.assertAlmostEqual(stated[key], expected, delta=1e-12, msg=method + " " + key)

    def test_comparison_is_deterministic_but_for_the_times(self):
        first = self.compared("--figure", "worst", "--mode", "paper")
        kept = {name: (self.folder / "out" / name).read_bytes() for name in
                ("differences.csv", "3/trimmed.csv", f"methods-{self.worst_plane()}.svg")}
        second = self.compared("--figure", "worst", "--mode", "paper", "--threads", "1", "--force", repeat=2)
        self.assertEqual(first["differences"], second["differences"])
        for name, content in kept.items():
            self.assertEqual((self.folder / "out" / name).read_bytes(), content, name)

    def worst_plane(self):
        """The plane with the largest distance in differences.csv; the first of several."""
        rows = table(self.folder / "out/differences.csv")
        largest = max(float(row["distance_mm"]) for row in rows)
        return min(int(row["plane"]) for row in rows if float(row["distance_mm"]) == largest)

    def test_comparison_names_the_planes_that_are_wrong(self):
        facts = self.compared("--mode", "paper", "--figure", "worst")
        rows = table(self.folder / "out/differences.csv")
        for method, stated in facts["differences"].items():
            wrong = [int(row["plane"]) for row in rows if row["method"] == method and row["right"] == "no"]
            self.assertEqual(stated["wrong_planes"], wrong, method)
            distances = [float(row["distance_mm"]) for row in rows if row["method"] == method]
            self.assertAlmostEqual(stated["distance_mm"], max(distances, default=0), delta=1e-9, msg=method)
        self.assertEqual(facts["differences"]["envelope"]["distance_mm"], 0)
        self.assertIn("envelope", facts["right_in_every_plane"])
        self.assertGreater(len(facts["differences"]["2"]["wrong_planes"]), 0)
        names = {path.name for path in (self.folder / "out").glob("*.svg")}
        self.assertEqual(names, {"comparison.svg", f"methods-{self.worst_plane()}.svg"})
        done = endmill("trim", VALLEY, "--cutter", "ball:20", "--grid", "60", "--planes", "12", "--tolerance", "0.05",
                       "--method", "all", "--mode", "paper", "--repeat", "2", "-o", "out", "--force", cwd=self.folder)
        self.assertIn("measured in 2 runs of each method", done.stdout)
        self.assertIn("right in every plane: ", done.stdout)

    def planes_file(self):
        """A loop of four sizes and a W without a loop, each in a plane of its own."""
        loop = ((-6, 6), (2, -2), (0, -1), (-2, -2), (6, 6))
        curves = [[(s * size, z * size) for s, z in loop] for size in (1, 0.1, 0.01, 0.001)] + [((-4, 2), (-2, 0), (0, 1), (2, 0), (4, 2))]
        rows = [f"{plane},{s!r},{z!r}\n" for plane, curve in enumerate(curves) for s, z in curve]
        return self.file("plane,s_mm,z_mm\n" + "".join(rows), "planes.csv")

    def test_curves_in_planes_of_their_own_are_trimmed_one_by_one(self):
        self.summary("trim", "--polyline", self.planes_file(), "-o", "out")
        rows = table(self.folder / "out/trimmed.csv")
        lowest = [min(float(row["z_mm"]) for row in rows if row["plane"] == str(plane)) for plane in range(5)]
        self.assertEqual(lowest, [0] * 5)  # each loop ends at its crossing (0, 0)
        done = endmill("trim", "--polyline", "planes.csv", "--offset", "2", cwd=self.folder)
        self.assert_refused(done, 2, "--offset: profiles in 5 planes")

    def test_wrong_planes_are_counted_by_depth_of_interference(self):
        # The tail of the loop of size 1 is 8 / sqrt 5 = 3.58 mm deep, and the other sizes in proportion. Literal detection
        # cuts the W (docs/methods/interference.md, section 11, T7).
        words = ("trim", "--polyline", self.planes_file(), "--detection", "literal", "--tolerance", "1e-6", "--repeat", "2",
                 "--m1-step", "0.5")
        facts = self.summary(*words, "--method", "all", "-o", "out")["comparison"]
        classes = facts["by_depth"]
        self.assertEqual({name: found["planes"] for name, found in classes.items()},
                         {"none": 1, "below_10_um": 1, "below_100_um": 1, "below_1_mm": 1, "from_1_mm": 1})
        for method, differences in facts["differences"].items():
            wrong = [classes[name]["wrong"][method]
                     for name in ("from_1_mm", "below_1_mm", "below_100_um", "below_10_um", "none")]
            self.assertEqual([plane for plane, count in enumerate(wrong) if count], differences["wrong_planes"], method)
        self.assertEqual([classes["none"]["wrong"][method] for method in ("1", "2", "3", "3r")], [1, 1, 1, 0])
        self.assertEqual(sum(found["wrong"]["envelope"] for found in classes.values()), 0)
        chosen = self.summary(*words, "--compare-only", "1,3r", "-o", "chosen")
        names = {path.name for path in (self.folder / "chosen").rglob("*")}
        self.assertEqual(names, {"differences.csv", "times.csv", "comparison.svg", "summary.json"})
        self.assertEqual(list(chosen["comparison"]["differences"]), ["1", "3r", "envelope"])
        for method, differences in chosen["comparison"]["differences"].items():
            self.assertEqual(differences, facts["differences"][method])

    def test_worst_plane_is_drawn_for_one_method_too(self):
        self.summary("trim", VALLEY, "--cutter", "ball:20", "--grid", "60", "--planes", "12", "--tolerance", "0.05",
                     "--figure", "worst", "-o", "out")
        plane = self.worst_plane()
        for name in (f"section-{plane}.svg", f"methods-{plane}.svg"):
            self.assertIn("<svg", (self.folder / "out" / name).read_text(encoding="utf-8"))
        self.assertFalse((self.folder / "out/times.csv").exists())

    def test_printed_range_of_method_3_finds_crossings_behind_branch_b(self):
        # docs/methods/interference.md, section 11, T5: the fourth run of dz does not reach the first, the sixth does.
        nested = self.file("s_mm,z_mm\n-10,10\n4,-4\n-2,-3\n0,-3.6\n2,-3.1\n-4,-4\n10,10\n", "t5.csv")
        paths = {}
        for name, words in (("default", ()), ("scan-to-end", ("--m3", "scan-to-end")), ("scan", ("--m3", "scan"))):
            facts = self.summary("trim", "--polyline", nested, "--mode", "paper", *words, "-o", name)
            self.assertEqual(facts["m3"], "scan-to-end" if name == "default" else name)
            paths[name] = [(row["s_mm"], row["z_mm"]) for row in table(self.folder / name / "trimmed.csv")]
        self.assertEqual(paths["default"], [("-10", "10"), ("0", "0"), ("10", "10")])
        self.assertEqual(paths["default"], paths["scan-to-end"])
        self.assertNotEqual(paths["default"], paths["scan"])

    def test_offset_of_a_valley_crosses_itself_on_the_bisector(self):
        # Both walls rise at 45 degrees: the centre of a ball of radius R touches both at the height R sqrt 2.
        valley = self.file("s_mm,z_mm\n-20,20\n0,0\n20,20\n", "valley.csv")
        for method in ("1", "2", "3", "3r", "envelope", "winding"):
            facts = self.summary("trim", "--polyline", valley, "--offset", "5", "--method", method, "--tolerance",
                                 "0.05", "-o", "out", "--force")
            self.assertEqual((facts["cutter"], facts["loops"] > 0), ("ball:10", True), method)
            self.assertLess(facts["max_gouge_mm"], 0.05 if method == "1" else 2e-4, method)
            lowest = min(float(row["z_mm"]) for row in table(self.folder / "out/trimmed.csv"))
            self.assertAlmostEqual(lowest, 5 * math.sqrt(2), delta=0.05 if method == "1" else 1e-12, msg=method)
            drawn = (self.folder / "out/section-0.svg").read_text(encoding="utf-8")
            self.assertIn(">part<", drawn)
            self.assertIn(">cutter<", drawn)

    def test_offset_follows_closed_curves_and_other_cutters(self):
        # A clockwise square has the tool outside, at the distance R.
        square = self.file("s_mm,z_mm\n0,0\n0,10\n10,10\n10,0\n0,0\n", "square.csv")
        facts = self.summary("trim", "--polyline", square, "--offset", "3", "--method", "winding", "-o", "square")
        self.assertLess(abs(facts["min_clearance_mm"]), 2e-4)
        rows = [(float(row["s_mm"]), float(row["z_mm"])) for row in table(self.folder / "square/trimmed.csv")]
        self.assertAlmostEqual(min(s for s, _ in rows), -3, delta=1e-12)
        self.assertAlmostEqual(min(z for _, z in rows), -3, delta=1e-12)
        # The flat bottom rests on both walls of a valley at the height R.
        valley = self.file("s_mm,z_mm\n-20,20\n0,0\n20,20\n", "valley.csv")
        self.summary("trim", "--polyline", valley, "--offset", "flat:8", "-o", "flat")
        lowest = min(float(row["z_mm"]) for row in table(self.folder / "flat/trimmed.csv"))
        self.assertEqual(lowest, 4)

    def test_offset_that_gouges_exits_1(self):
        # The right wall is too short for the offset to cross itself. Without contacts at its end the path gouges.
        short = self.file("s_mm,z_mm\n-20,20\n0,0\n1,1\n", "short.csv")
        facts = self.summary("trim", "--polyline", short, "--offset", "5", "-o", "contact")
        self.assertLess(facts["max_gouge_mm"], 2e-4)
        done = endmill("trim", "--polyline", short, "--offset", "5", "--boundary", "none", "-o", "none",
                       cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("--boundary contact", done.stderr)

    def test_bad_profiles_are_refused(self):
        for text, status, message in (
                ("s_mm,z_mm\n0,0\n1,x\n", 3, "p.csv:3"), ("s_mm,z_mm\n0,0\n", 3, "p.csv:2"),
                ("s_mm,z_mm\n0,0\n1,0,5\n", 3, "p.csv:3"), ("s_mm,z_mm\n0,0\n5,5\n4,9\n9,9\n", 4, "s = 5, z = 5 mm"),
                ("s_mm,z_mm\n0,0\n9,0\n9,9\n0,9\n0,0\n", 4, "counter-clockwise")):
            done = endmill("trim", "--polyline", self.file(text, "p.csv"), "--offset", "flat:4", cwd=self.folder)
            self.assert_refused(done, status, "p.csv", message)
        spikes = "s_mm,z_mm\n" + "".join(f"{i},{i % 2 * 9}\n" for i in range(4000))
        done = endmill("trim", "--polyline", self.file(spikes, "p.csv"), "--offset", "900000", "--max-memory", "0.5",
                       cwd=self.folder)
        self.assert_refused(done, 6, "p.csv", "GiB")
        self.assert_nothing_left("p.csv")

    def test_options_that_exclude_each_other_are_refused(self):
        curves = self.file(LOOP, "t1.csv")
        part = self.file(plane())
        dome = ROOT / "datasets/meshes/dome.stl"
        for words, message in (
                ((), "PART or --polyline"),
                ((part,), "--cutter is needed"),
                ((part, "--polyline", curves, "--cutter", "ball:5"), "one of them"),
                ((part, "--cutter", "ball:5", "--detection", "literal"), "--detection: has no effect with --method envelope"),
                (("--polyline", curves, "--refine"), "--refine"),
                (("--polyline", curves, "--cutter", "ball:5"), "--cutter and --polyline"),
                (("--polyline", curves, "--planes", "5"), "--polyline excludes --planes"),
                (("--polyline", curves, "--grid", "5"), "--polyline excludes --grid"),
                (("--polyline", curves, "--direction-deg", "0"), "--polyline excludes --direction-deg"),
                (("--polyline", curves, "--safe-height", "9"), "--polyline excludes --safe-height"),
                (("--polyline", curves, "--m1-step", "0", "--method", "1"), "--m1-step"),
                (("--polyline", curves, "--compare-only", "1,4"), "--compare-only"),
                (("--polyline", curves, "--compare-only", "1,"), "--compare-only"),
                (("--polyline", curves, "--compare-only", "1", "--method", "all"), "--method: has no effect"),
                ((dome, "--cutter", "ball:5", "--compare-only", "1"), "--compare-only: has no effect with a mesh"),
                ((part, "--cutter", "ball:5", "--method", "4"), "--method"),
                ((part, "--cutter", "flat:5", "--scallop", "0.1"), "flat cutter"),
                ((part, "--cutter", "ball:5", "--figure", "100"), "--figure 100"),
                ((part, "--cutter", "ball:5", "--planes", "3", "--pitch", "2"), "--planes, --pitch and --scallop"),
                ((dome, "--cutter", "ball:5", "--refine"), "--refine"),
                ((dome, "--cutter", "ball:5", "--boundary", "none"), "--boundary none"),
                ((part, "--cutter", "ball:5", "--offset", "3"), "--offset: a PART"),
                (("--polyline", curves, "--offset", "3", "--cutter", "ball:5"), "--cutter and --polyline"),
                (("--polyline", curves, "--offset", "0"), "--offset"),
                (("--polyline", curves, "--offset", "-2"), "--offset"),
                (("--polyline", curves, "--offset", "ball:x"), "--offset"),
                (("--polyline", curves, "--offset", "2e6"), "--max-extent"),
                (("--polyline", curves, "--offset", "1e-7"), "a radius of 1e-07 mm; expected one from 1e-06"),
                (("--polyline", curves, "--boundary", "none"), "--boundary: has no effect"),
                ((part, "--cutter", "ball:5", "--repeat", "5"), "--repeat: has no effect with --method envelope"),
                ((part, "--cutter", "ball:5", "--method", "all", "--repeat", "0"), "--repeat"),
                ((part, "--cutter", "ball:5", "--figure", "wrst"), "or worst"),
                ((part, "--cutter", "ball:5", "--method", "3", "--m3", "scan-to-end"), "--detection literal"),
                ((part, "--cutter", "ball:5", "--method", "3r", "--m3", "scan"), "--m3: has no effect"),
                ((dome, "--cutter", "ball:5", "--method", "all", "--repeat", "3"), "--repeat"),
                ((dome, "--cutter", "ball:5", "--figure", "worst"), "--figure worst"),
                ((part, "--cutter", "ball:5", "--thin-tolerance", "0.01"), "expected less than --tolerance, 0.01 mm"),
                ((part, "--cutter", "ball:5", "--thin-tolerance", "-1"), "--thin-tolerance"),
                (("--polyline", curves, "--thin-tolerance", "0"), "--polyline excludes --thin-tolerance"),
                ((part, "--cutter", "ball:5", "--grid", "1"), "--grid")):
            self.assert_refused(endmill("trim", *words, cwd=self.folder), 2, message)

    def test_bad_curves_are_refused_with_their_line(self):
        for text, message in (("s_mm,z_mm\n", "no row"), ("s_mm,z_mm\n1,2\n", "1 different point"),
                              ("", "file is empty"), ("s_mm,z_mm\n1,2\n1,2\n", "1 different point"),
                              ("curve,s_mm,z_mm\n0,1,2\n0,2,3\n1,2,3\n", "c.csv:4"), ("s_mm,z_mm\n0,0\n1,1e400\n", ":3"), ("s_mm,z_mm\n1,nan\n2,3\n", ":2"),
                              ("s_mm,y\n1,2\n", "unknown column")):
            self.assert_refused(endmill("trim", "--polyline", self.file(text, "c.csv"), cwd=self.folder), 3, message)
        self.assert_nothing_left("c.csv")

    def trimmed_mesh(self, text):
        """Trims a mesh and returns the summary and the bytes of the path. Standard error has the remarks."""
        done = endmill("trim", self.file(text, "cube.obj"), "--cutter", "ball:4", "--planes", "3", "--grid", "20",
                       "--json", "-o", "out", "--force", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        facts = json.loads(done.stdout)
        for remark in facts["remarks"]:
            self.assertIn(remark, done.stderr)
        return facts, (self.folder / "out/toolpath.csv").read_bytes()

    def test_defects_of_a_mesh_give_remarks_and_keep_the_path(self):
        facts, sound = self.trimmed_mesh(CUBE)
        self.assertEqual(facts["remarks"], [])
        for text, remarks in (
                (CUBE + "f 7 5 6\n", ["left out: 1 triangle that repeats another"]),
                (CUBE.replace("f 5 6 7", "f 7 6 5"), ["1 triangle was turned over, so that all face outwards"]),
                (CUBE + "v 5 0 0\nf 1 9 2\n", ["1 triangle without an area"]),
                (CUBE.replace("f 1 3 2\n", ""), ["edges of one triangle only: 3; the mesh is a sheet or has holes"]),
                (CUBE + "v 5 5 5\nf 1 2 9\n",
                 ["edges of one triangle only: 2; the mesh is a sheet or has holes",
                  "edges of more than two triangles: 1, the first between points [0,1]"])):
            facts, path = self.trimmed_mesh(text)
            for remark, expected in zip(facts["remarks"], remarks, strict=False):
                self.assertIn(expected, remark)
            self.assertGreaterEqual(len(facts["remarks"]), len(remarks), text)
            self.assertEqual(path, sound, remarks)

    def test_one_sided_mesh_gives_a_remark(self):
        # A Moebius strip of three quadrangles.
        band = ("v 0 0 0\nv 0 0 2\nv 10 0 0\nv 10 0 2\nv 5 8 0\nv 5 8 2\n"
                "f 1 3 4\nf 1 4 2\nf 3 5 6\nf 3 6 4\nf 5 2 1\nf 5 1 6\n")
        facts, _ = self.trimmed_mesh(band)
        self.assertTrue([remark for remark in facts["remarks"] if "one side only" in remark], facts["remarks"])

    def test_inconsistent_stl_files_are_refused(self):
        triangles = [((0, 0, 0), (10, 0, 0), (0, 10, 0)), ((10, 0, 0), (10, 10, 0), (0, 10, 0))]
        for content, message in ((stl(3, triangles), "header says 3 triangles"),
                                 (stl(1, triangles), "header says 1 triangle"),
                                 (stl(4_000_000_000, triangles), "header says 4000000000 triangles"),
                                 (stl(2, triangles)[:-20], "header says 2 triangles"),
                                 (stl(2, triangles)[:70], "part.stl"), (b"", "file is empty"),
                                 (stl(0, []), "no triangles"),
                                 (stl(1, [((0, 0, 0), (1, 0, 0), (2, 0, 0))]), "no area"),
                                 (stl(1, [((0, 0, 0), (float("nan"), 0, 0), (0, 1, 0))]), "NaN")):
            done = endmill("trim", self.file(content, "part.stl"), "--cutter", "ball:4", cwd=self.folder)
            self.assert_refused(done, 3, "part.stl", message)
            self.assert_nothing_left("part.stl")

    def test_places_that_no_cutter_reaches_are_named(self):
        overhang = plane(size=(60, 30))
        for row in overhang["control_points"]:
            row[1][0], row[2][0] = 70, -10
        line = plane()
        for row in line["control_points"]:
            for i, point in enumerate(row):
                point[:] = [i, i, 0]
        for surface, message in ((overhang, "u = 0.5, "), (line, "no normal at u = 0, v = 0 ")):
            done = endmill("trim", self.file(surface), "--cutter", "ball:4", cwd=self.folder)
            self.assert_refused(done, 4, "surface.json", message)
            self.assert_nothing_left("surface.json")

    def test_planes_that_miss_the_part_are_empty(self):
        def sheet(y):
            return [[[0, y, 0], [30, y, 0]], [[0, y + 10, 0], [30, y + 10, 0]]]
        apart = {"format": "endmill-surface/1", "type": "bezier-patches", "name": "apart",
                 "patches": [sheet(0), sheet(50)]}
        facts = self.summary("trim", self.file(apart), "--cutter", "ball:4", "--planes", "6", "--grid", "10",
                             "-o", "out")
        self.assertEqual((facts["planes"], facts["curves"]), (6, 2))
        told = endmill("trim", "surface.json", "--cutter", "ball:4", "--planes", "6", "--grid", "10", "-o", "out", "--force",
                       cwd=self.folder)
        self.assertIn("4 drive planes of 6 miss the part", told.stderr)
        self.assertEqual({row["plane"] for row in table(self.folder / "out/trimmed.csv")}, {"0", "5"})


    def test_planes_that_all_miss_the_part_are_refused(self):
        sheets = [[[[0, y, 0], [30, y, 0]], [[0, y + 10, 0], [30, y + 10, 0]]] for y in (0, 50)]
        apart = {"format": "endmill-surface/1", "type": "bezier-patches", "name": "apart", "patches": sheets}
        done = endmill("trim", self.file(apart), "--cutter", "ball:4", "--planes", "1", "--grid", "10", "-o", "out",
                       cwd=self.folder)
        self.assert_refused(done, 4, "surface.json", "no drive plane meets the part")
        self.assertFalse((self.folder / "out").exists())

    def test_work_beyond_the_memory_limit_is_refused_first(self):
        for words in (("--grid", "9000"), ("--planes", "300000", "--grid", "20")):
            done = endmill("trim", VALLEY, "--cutter", "ball:20", *words, "--max-memory", "0.5", "-o", "out",
                           cwd=self.folder)
            self.assert_refused(done, 6, "GiB", "--max-memory", "--grid")
            self.assertFalse((self.folder / "out").exists())

    def test_later_run_removes_pictures_of_an_earlier_one(self):
        run = ("trim", VALLEY, "--cutter", "ball:20", "--grid", "20", "--planes", "4", "--tolerance", "9", "-o", "out")
        self.summary(*run, "--figure", "1")
        self.summary(*run, "--figure", "2", "--force")
        self.assertEqual([file.name for file in (self.folder / "out").glob("section-*.svg")], ["section-2.svg"])

    def test_path_names_its_part_for_verify(self):
        self.summary("trim", VALLEY, "--cutter", "ball:20", "--grid", "40", "--planes", "4", "--tolerance", "9", "-o",
                     "out")
        judged = endmill("verify", "out/toolpath.csv", "--resolution", "4", "--json", "-o", "judged", cwd=self.folder)
        facts = json.loads(judged.stdout)
        self.assertIn("valley.json", facts["part"])
        self.assertGreater(facts["judged_area_mm2"], 1000)


if __name__ == "__main__":
    unittest.main()
