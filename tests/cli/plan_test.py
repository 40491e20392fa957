# SPDX-License-Identifier: GPL-3.0-or-later
"""endmill plan: plans of planes in closed form, and the contents of the files."""
import csv
import json
import math
import os
import re
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from program import ENDMILL, SURFACES, ProgramTest, endmill, plane

# On a plane a ball of radius 5 leaves a scallop of 1 mm between passes 6 mm apart.
PAPER = ["--mode", "paper"]
TOLERANCES = ["--cutter", "ball:10", "--chord-tolerance", "0.5", "--scallop", "1"]
BALL = [*TOLERANCES, *PAPER]
COARSE = ["--cutter", "ball:20", "--chord-tolerance", "0.3", "--strategy", "iso"]  # quick
NET = SURFACES / "net_rot24_7D.json"


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class PlanOnAPlane(ProgramTest):
    def test_passes_points_and_lengths_have_their_closed_form(self):
        facts = self.summary("plan", self.file(plane(size=(60, 30))), *BALL, "--direction", "u", "-o", "out")
        self.assertEqual((facts["passes"], facts["ncl"]), (6, 12))
        self.assertAlmostEqual(facts["tcd_mm"], 6 * 60 + 30, delta=1e-9)
        self.assertAlmostEqual(facts["link_mm"], 30, delta=1e-9)
        self.assertAlmostEqual(facts["max_chord_error_mm"], 0, delta=1e-12)
        points = rows(self.folder / "out/toolpath.csv")
        self.assertEqual(len(points), 12)
        self.assertEqual([p["move"] for p in points], ["plunge", "cut"] + ["link", "cut"] * 5)
        for number, point in enumerate(points[::2]):
            self.assertAlmostEqual(float(point["tip_y_mm"]), 6 * number, delta=1e-12)

    def test_one_way_passes_return_above_the_part(self):
        facts = self.summary("plan", self.file(plane(size=(60, 30))), *BALL, "--direction", "u",
                             "--order", "one-way", "--safe-height", "7", "-o", "out")
        self.assertEqual(facts["ncl"], 12)
        self.assertAlmostEqual(facts["tcd_mm"], 360, delta=1e-9)
        points = rows(self.folder / "out/toolpath.csv")
        self.assertEqual([p["move"] for p in points[:6]], ["plunge", "cut", "retract", "rapid", "plunge", "cut"])
        self.assertEqual([float(p["tip_z_mm"]) for p in points[:5]], [0, 0, 7, 7, 0])
        self.assertEqual(points[2]["contact_x_mm"], "")

    def test_time_is_travel_divided_by_feed(self):
        path = self.file(plane(size=(60, 30)))
        facts = self.summary("plan", path, *BALL, "--direction", "u", "--feed", "100", "-o", "out")
        self.assertAlmostEqual(facts["time_min"], 3.9, delta=1e-9)
        facts = self.summary("plan", path, *BALL, "--direction", "u", "--feed", "100",
                             "--count-links", "no", "-o", "out2")
        self.assertAlmostEqual(facts["time_min"], 3.6, delta=1e-9)

    def test_both_directions_are_compared(self):
        facts = self.summary("plan", self.file(plane(size=(60, 30))), *BALL, "-o", "out")
        self.assertEqual(facts["recommended"], "u")
        u, v = facts["u"], facts["v"]
        self.assertAlmostEqual(facts["reduction_tcd"], 1 - min(u["tcd_mm"], v["tcd_mm"]) /
                               max(u["tcd_mm"], v["tcd_mm"]), delta=1e-12)
        self.assertAlmostEqual(facts["reduction_ncl"], 1 - 12 / 22, delta=1e-12)
        for direction in "uv":
            for name in ("toolpath.csv", "toolpath.vtp", "toolpath.svg", "summary.json"):
                self.assertTrue((self.folder / "out" / direction / name).is_file())

    def files(self):
        return {str(path.relative_to(self.folder / "out")) for path in (self.folder / "out").rglob("*.*")}

    def test_forced_run_replaces_only_files_of_endmill(self):
        path = self.file(plane(size=(60, 30)))
        one = {"toolpath.csv", "toolpath.vtp", "toolpath.svg", "summary.json"}
        both = {f"{direction}/{name}" for direction in "uv" for name in one} | {"summary.json"}
        self.summary("plan", path, *BALL, "-o", "out")
        self.assertEqual(self.files(), both)
        (self.folder / "out/v/notes.txt").write_text("mine")
        (self.folder / "out/toolpath.csv.bak").write_text("mine")
        for direction, written in (("u", one), ("both", both), ("v", one)):
            self.summary("plan", path, *BALL, "--direction", direction, "--force", "-o", "out")
            self.assertEqual(self.files(), written | {"v/notes.txt", "toolpath.csv.bak"})
        self.assertFalse((self.folder / "out/u").exists())

    def test_failed_forced_run_keeps_the_earlier_files(self):
        path = self.file(plane(size=(60, 30)))
        self.summary("plan", path, *BALL, "-o", "out")
        before = self.files()
        done = endmill("plan", path, *BALL, "--direction", "u", "--force", "-o", "out", "--max-memory", "1e-6",
                       cwd=self.folder)
        self.assert_refused(done, 6, "surface.json", "GiB", "--max-memory")
        self.assertEqual(self.files(), before)

    def test_input_in_the_output_folder_is_kept(self):
        (self.folder / "out/u").mkdir(parents=True)
        path = self.file(plane(size=(60, 30)), "out/u/summary.json")
        self.summary("plan", path, *BALL, "--direction", "v", "--force", "-o", "out")
        self.assertIn("u/summary.json", self.files())

    def test_tool_axis_changes_the_tips_only(self):
        path = self.file(plane(size=(60, 30)))
        self.summary("plan", path, *BALL, "--direction", "u", "-o", "up")
        self.summary("plan", path, *BALL, "--direction", "u", "--axis", "1,0,1", "-o", "tilted")
        shift = 5 * (1 - math.sqrt(0.5))
        for upright, tilted in zip(rows(self.folder / "up/toolpath.csv"), rows(self.folder / "tilted/toolpath.csv")):
            self.assertEqual(upright["contact_x_mm"], tilted["contact_x_mm"])
            self.assertAlmostEqual(float(tilted["tip_z_mm"]), shift, delta=1e-12)

    def test_measured_scallop_is_the_planned_scallop(self):
        for axis in ("0,0,1", "1,0,2"):
            facts = self.summary("plan", self.file(plane()), *BALL, "--direction", "v", "--axis", axis, "--force")
            self.assertEqual(facts["max_gouge_mm"], 0)
            self.assertLessEqual(facts["max_scallop_mm"], facts["scallop_mm"] + 1e-9)
            self.assertGreaterEqual(facts["max_scallop_mm"] + facts["scallop_bound_mm"], facts["scallop_mm"] - 1e-9)
            self.assertGreater(facts["scallop_pitch_mm"], 0)


class VerifiedPlan(ProgramTest):
    def test_verified_plan_keeps_one_sided_tolerances(self):
        facts = self.summary("plan", SURFACES / "wavy.json", "--cutter", "ball:6", "--mode", "verified",
                             "--chord-tolerance", "0.1", "--inner-tolerance", "0.03",
                             "--scallop", "0.1", "--direction", "v", "-o", "out")
        self.assertEqual((facts["mode"], facts["inner_tolerance_mm"], facts["outer_tolerance_mm"]),
                         ("verified", 0.03, 0.1))
        bound = facts["motion_error_bound_mm"]
        self.assertLess(bound, 1e-5)
        self.assertLessEqual(facts["max_motion_gouge_mm"], 0.03 + bound)
        self.assertLessEqual(facts["max_motion_left_mm"], 0.1 + bound)
        self.assertEqual(facts["max_motion_error_mm"],
                         max(facts["max_motion_gouge_mm"], facts["max_motion_left_mm"]))
        self.assertEqual(facts["uncovered_places"], 0)
        lifts = [p for p in rows(self.folder / "out/toolpath.csv") if p["move"] == "rapid"]
        self.assertEqual(len(lifts), facts["lifted_links"])

    def test_verified_plan_stays_within_its_stated_bound(self):
        # The plan states the bound itself. A finer measurement must stay within it.
        plan = self.summary("plan", self.file(plane(size=(60, 30))), *TOLERANCES, "--direction", "u", "-o", "out")
        most = plan["scallop_mm"] + plan["outer_tolerance_mm"]
        self.assertLessEqual(plan["max_scallop_mm"] + plan["scallop_bound_mm"], most + 1e-9)
        seen = self.summary("verify", "out/toolpath.csv", "--resolution", "0.25", "-o", "seen")
        self.assertLessEqual(seen["max_scallop_mm"], plan["max_scallop_mm"] + plan["scallop_bound_mm"] + 1e-9)

    def test_default_tolerances_are_a_hundredth(self):
        facts = self.summary("plan", self.file(plane(size=(20, 10))), "--direction", "u")
        self.assertEqual((facts["mode"], facts["cutter"], facts["chord_tolerance_mm"], facts["scallop_mm"]),
                         ("verified", "ball:20", 0.01, 0.01))
        facts = self.summary("plan", self.file(plane(size=(20, 10))), *PAPER, "--direction", "u", "--force")
        self.assertEqual((facts["chord_tolerance_mm"], facts["scallop_mm"]), (20 / 30, 20 / 30))

    def test_verified_plan_of_a_plane_has_the_passes_of_the_closed_form(self):
        facts = self.summary("plan", self.file(plane(size=(60, 30))), *TOLERANCES, "--direction", "u")
        self.assertEqual((facts["passes"], facts["ncl"]), (7, 14))  # 30 mm / 5.998 mm, rounded up, and the last border

    def test_crease_that_no_ball_reaches_exits_1(self):
        crease = plane(patches_u=2)
        for row in crease["control_points"]:
            for point in row:
                point[2] = abs(point[0] - 30)
        done = endmill("plan", self.file(crease), "--cutter", "ball:3", "--mode", "verified",
                       "--chord-tolerance", "0.05", "--direction", "v", "-o", "out", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertGreater(json.loads(done.stdout)["uncovered_places"], 0)
        self.assertIn("the remaining stock may exceed scallop height", done.stderr)


def distance_to_segment(point, start, end):
    along = [e - s for s, e in zip(start, end)]
    square = sum(x * x for x in along)
    share = sum((p - s) * x for p, s, x in zip(point, start, along)) / square if square else 0
    share = min(max(share, 0), 1)
    return math.dist(point, [s + share * x for s, x in zip(start, along)])


class OneSidedTolerance(ProgramTest):
    """The ball enters the part nowhere, or leaves nothing along its passes. The deviation of each step is measured
    again here, by samples of the formula of the surface, z = (x^2 - y^2) / 64."""

    def planned(self, inner, outer, *more):
        return self.summary("plan", SURFACES / "saddle.json", "--cutter", "ball:15", "--inner-tolerance", inner,
                            "--outer-tolerance", outer, "--scallop", "0.2", "--direction", "u", *more)

    def test_path_deviates_to_the_allowed_side_only(self):
        for inner, outer, forbidden, allowed in ((0, 0.05, "max_motion_gouge_mm", "max_motion_left_mm"),
                                                 (0.05, 0, "max_motion_left_mm", "max_motion_gouge_mm")):
            facts = self.planned(inner, outer, "-o", "out", "--force")
            self.assertEqual((facts["inner_tolerance_mm"], facts["outer_tolerance_mm"]), (inner, outer))
            self.assertLess(facts[forbidden], 1e-9)
            self.assertLessEqual(facts[allowed], 0.05 + facts["motion_error_bound_mm"])
            self.assertGreater(facts[allowed], 0.045)
            self.assertLessEqual(facts["max_gouge_mm"], inner + 0.001)
            self.assertEqual(facts["uncovered_places"], 0)
        self.assertLess(facts["max_scallop_mm"], 0.2 + 0.001)

    def test_each_step_deviates_to_the_allowed_side(self):
        radius = 7.5
        for inner, outer in ((0, 0.05), (0.05, 0)):
            self.planned(inner, outer, "-o", "out", "--force")
            points = rows(self.folder / "out/toolpath.csv")
            least, greatest = math.inf, -math.inf
            for start, end in zip(points, points[1:]):
                if end["move"] != "cut":
                    continue
                centres = [[float(at[f"tip_{axis}_mm"]) + (radius if axis == "z" else 0) for axis in "xyz"]
                           for at in (start, end)]
                u, v = ([float(at[name]) for at in (start, end)] for name in "uv")
                self.assertEqual(v[0], v[1])
                for k in range(41):
                    x, y = (30 * (a + (b - a) * k / 40) - 45 for a, b in (u, v))
                    deviation = distance_to_segment((x, y, (x * x - y * y) / 64), *centres) - radius
                    least, greatest = min(least, deviation), max(greatest, deviation)
            self.assertGreaterEqual(least, -inner - 1e-9)
            self.assertLessEqual(greatest, outer + 1e-9)
            self.assertGreater(greatest - least, 0.045)

    def test_other_commands_take_the_path(self):
        self.planned(0, 0.05, "-o", "out")
        done = endmill("post", "out/toolpath.csv", "--feed", "800", "--spindle-rpm", "5000", "-o", "program",
                       cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("\nG61\n", next((self.folder / "program").glob("*.ngc")).read_text())
        seen = self.summary("verify", "out/toolpath.csv", "-o", "seen")
        self.assertEqual(seen["verdict"], "clean")

    def test_mode_paper_names_the_curvature_across_the_feed(self):
        for options, words in (((), "exact curvature across the feed"),
                               (("--cross-curvature", "chord", "--cross-step", "0.25"),
                                "curvature across the feed by eq. (8) of the paper with chord 0.25 mm")):
            done = endmill("plan", self.file(plane()), *BALL, "--direction", "u", *options, "-o", "out", "--force",
                           cwd=self.folder)
            self.assertIn(words, done.stdout)
            facts = json.loads((self.folder / "out/summary.json").read_text())
            self.assertEqual(facts["cross_curvature"], "chord" if options else "exact")
        done = endmill("plan", self.file(plane()), *TOLERANCES, "--direction", "u", "-o", "verified", cwd=self.folder)
        self.assertNotIn("curvature", done.stdout)


class KnownGouge(ProgramTest):
    def test_gouge_of_mode_paper_exits_1_and_names_mode_verified(self):
        done = endmill("plan", NET, *BALL, "--direction", "u", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        errors = done.stderr.splitlines()
        self.assertEqual(len(errors), 1, done.stderr)
        for word in ("along u gouges the part", "--mode paper", "inner tolerance of 0.5 mm", "--mode verified keeps"):
            self.assertIn(word, errors[0])
        facts = json.loads((self.folder / "net_rot24_7D-plan/summary.json").read_text())
        self.assertGreater(facts["max_motion_gouge_mm"], facts["inner_tolerance_mm"])

    def test_gouge_is_reported_with_quiet_and_as_json(self):
        done = endmill("plan", NET, *BALL, "--direction", "u", "--quiet", "--json-errors", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        error = json.loads(done.stderr)["error"]
        self.assertEqual((error["code"], error["exit"]), ("E_GOUGE", 1))

    def test_gouges_of_both_directions_give_one_line(self):
        done = endmill("plan", NET, *BALL, cwd=self.folder)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)


class BetterMode(ProgramTest):
    def line(self, surface, *options):
        done = endmill("plan", surface, "--cutter", "ball:20", "--force", *options, cwd=self.folder)
        lines = [line for line in done.stdout.splitlines() if line.startswith("  better mode")]
        self.assertLessEqual(len(lines), 1)
        return lines[0] if lines else ""

    def test_paper_run_names_the_limits_that_it_misses_and_mode_verified(self):
        line = self.line(SURFACES / "saddle.json", *PAPER, "--direction", "u", "-o", "out")
        facts = json.loads((self.folder / "out/summary.json").read_text())
        self.assertGreater(facts["max_chord_error_mm"], facts["chord_tolerance_mm"])
        self.assertGreater(facts["max_scallop_mm"], facts["scallop_mm"] + facts["outer_tolerance_mm"] + 0.001)
        self.assertLess(max(facts["max_gouge_mm"], facts["max_motion_gouge_mm"]), facts["inner_tolerance_mm"])
        self.assertIn("--mode verified", line)
        self.assertTrue(line.endswith("limits missed along u: chord error, remaining stock"), line)

    def test_both_directions_have_one_line(self):
        line = self.line(NET, *PAPER)
        self.assertIn("along u: ", line)
        self.assertIn("along v: ", line)
        self.assertEqual(line.count("gouge"), 2)

    def test_paper_run_that_keeps_its_limits_names_the_mode_only(self):
        line = self.line(self.file(plane(size=(60, 30))), *PAPER)
        self.assertIn("--mode verified", line)
        self.assertNotIn("missed", line)

    def test_verified_run_has_no_better_mode(self):
        self.assertEqual(self.line(self.file(plane(size=(60, 30))), "--strategy", "iso"), "")


class IdleOptions(ProgramTest):
    def refused(self, *arguments):
        done = endmill("plan", self.file(plane()), *arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 2, arguments)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["surface.json"])
        return done.stderr

    def test_mode_verified_refuses_policies_of_mode_paper(self):
        for option, value in (("--governing", "min"), ("--last-path", "none"), ("--end-point", "free"),
                              ("--step-curvature", "curve"), ("--march", "forward"), ("--cross-curvature", "chord"),
                              ("--cross-step", "1")):
            for mode in ([], ["--mode", "verified"]):
                error = self.refused(option, value, *mode)
                self.assertIn(f"{option}: has no effect with --mode verified; expected --mode paper", error)

    def test_chord_tolerance_without_effect_is_refused(self):
        self.assertIn("--chord-tolerance", self.refused("--chord-tolerance", "1", "--inner-tolerance", "1",
                                                        "--outer-tolerance", "1", "--scallop", "1"))

    def test_cross_step_without_chord_curvature_is_refused(self):
        self.assertIn("--cross-curvature chord", self.refused(*PAPER, "--cross-step", "1"))

    def test_distance_without_effect_is_refused(self):
        self.assertIn("--direction both", self.refused("--direction", "u", "--distance", "cl"))


class PlanOnTheExample(ProgramTest):
    def test_defaults_are_sensible_and_reported(self):
        done = endmill("plan", NET, "--strategy", "iso", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("radius below 10.009 mm", "ball:20", "mode verified", "scallop height 0.01 mm", "along u",
                     "recommended", "net_rot24_7D-plan"):
            self.assertIn(word, done.stdout)
        self.assertNotIn("chord error", done.stdout)
        self.assertEqual(len(done.stdout.splitlines()), 5, "part, u, v, comparison and folder")
        self.assert_nothing_left("net_rot24_7D-plan")
        facts = json.loads((self.folder / "net_rot24_7D-plan/summary.json").read_text())
        for direction in "uv":
            self.assertLessEqual(facts[direction]["max_motion_error_mm"], 0.01 * (1 + 1e-9))
            self.assertLessEqual(facts[direction]["max_gouge_mm"], 0.011)

    def test_text_is_rounded_and_files_are_not(self):
        done = endmill("plan", NET, *COARSE, "--direction", "v", cwd=self.folder)
        for number in re.findall(r"-?\d+\.\d+", done.stdout):
            self.assertLessEqual(len(number.replace(".", "").lstrip("-0")), 6, number)
        self.assertRegex(done.stdout, r"  along v       \d+ passes, \d+ points, contact travel \S+ mm; "
                         r"cuts \S+ mm, links \S+ mm; gouge \S+ mm \(limit \S+\), remaining \S+ mm \(limit \S+\)\n")
        self.assertLessEqual(len(done.stdout.splitlines()), 5)
        self.assertRegex((self.folder / "net_rot24_7D-plan/summary.json").read_text(), r"\d\.\d{12}")

    def test_second_run_needs_force(self):
        path = self.file(plane())
        self.summary("plan", path, *BALL)
        self.assert_refused(endmill("plan", path, *BALL, cwd=self.folder), 2, "not empty", "--force")
        self.summary("plan", path, *BALL, "--force")

    def test_files_do_not_depend_on_the_number_of_threads(self):
        for mode, options, status in (("paper", PAPER, 1), ("verified", COARSE, 0)):
            for threads in (1, 4):
                self.summary("plan", NET, *options, "--threads", threads, "-o", f"{mode}{threads}", status=status)
            for path in (self.folder / f"{mode}1").rglob("*.*"):
                twin = self.folder / f"{mode}4" / path.relative_to(self.folder / f"{mode}1")
                self.assertEqual(path.read_bytes(), twin.read_bytes(), path)

    def test_files_do_not_depend_on_the_memory_limit(self):
        self.summary("plan", NET, *COARSE, "-o", "together")
        self.summary("plan", NET, *COARSE, "-o", "one-by-one", "--max-memory", "0.008", "--threads", 1)
        for path in (self.folder / "together").rglob("*.csv"):
            twin = self.folder / "one-by-one" / path.relative_to(self.folder / "together")
            self.assertEqual(path.read_bytes(), twin.read_bytes(), path)

    def test_files_are_well_formed_and_finite(self):
        self.summary("plan", NET, *COARSE, "--direction", "v", "-o", "out")
        ElementTree.parse(self.folder / "out/toolpath.svg")
        for row in rows(self.folder / "out/toolpath.csv"):
            for key, value in row.items():
                if key != "move":
                    self.assertTrue(math.isfinite(float(value)), row)
        header = (self.folder / "out/toolpath.csv").read_text().splitlines()[0]
        self.assertTrue(header.startswith("pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z"))

    def test_printed_summary_is_the_written_one_and_has_every_policy(self):
        facts = self.summary("plan", NET, *PAPER, "--direction", "u", "-o", "out", status=1)
        self.assertEqual(facts, json.loads((self.folder / "out/summary.json").read_text()))
        for key in ("governing", "last_path", "end_point", "stop_at_borders", "step_curvature", "march",
                    "cross_curvature", "cross_step_mm", "count_links", "distance", "order",
                    "safe_height_mm", "axis", "scallop_mm", "chord_tolerance_mm", "mode"):
            self.assertIn(key, facts)
        self.assertAlmostEqual(facts["safe_height_mm"], 225, delta=1e-3)

    def test_path_lengths_are_those_of_the_written_points(self):
        facts = self.summary("plan", NET, "--cutter", "ball:15", "--chord-tolerance", "0.5", *PAPER,
                             "--direction", "v", "-o", "out", status=1)
        points = rows(self.folder / "out/toolpath.csv")
        self.assertEqual(len(points), facts["ncl"])
        for kind, key in (("contact", "tcd_mm"), ("tip", "tcd_cl_mm")):
            places = [tuple(float(p[f"{kind}_{axis}_mm"]) for axis in "xyz") for p in points]
            travel = sum(math.dist(a, b) for a, b in zip(places, places[1:]))
            self.assertAlmostEqual(travel, facts[key], delta=1e-6)
        # The last travel is that of the tips.
        self.assertAlmostEqual(sum(facts["path"][f"{kind}_mm"] for kind in ("cut", "plunge", "link", "rapid")), travel,
                               delta=1e-6)
        self.assertEqual(facts["path"]["points"], len(points))
        self.assertEqual([int(row["point"]) for row in points], list(range(len(points))))


BYTES_PER_POINT = 1000  # stated in src/endmill/planning/planned_path.h


class PlanMemory(ProgramTest):
    def plan(self, *arguments):
        """The summary, and the peak of resident memory in bytes."""
        command = [ENDMILL, "plan", NET, "--cutter", "ball:15", *PAPER, "--direction", "u", "--json"]
        with subprocess.Popen([*command, *arguments], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL) as process:
            summary = json.load(process.stdout)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.assertIn(process.returncode, (0, 1))  # the paper's path gouges
        return summary, 1024 * usage.ru_maxrss

    @unittest.skipIf(b"__asan_init" in Path(ENDMILL).read_bytes(), "sanitizers take memory of their own")
    def test_memory_per_point_stays_within_the_stated_amount(self):
        few, peak_of_few = self.plan("--chord-tolerance", "1", "-o", "few")
        many, peak = self.plan("--chord-tolerance", "0.005", "-o", "many")
        self.assertGreater(many["ncl"], 100 * few["ncl"])
        self.assertLess(peak - peak_of_few, BYTES_PER_POINT * (many["ncl"] - few["ncl"]))


if __name__ == "__main__":
    unittest.main()
