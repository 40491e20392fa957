# SPDX-License-Identifier: GPL-3.0-or-later
"""The evaluation of sweeps by scripts/studies."""
import csv
import json
import unittest
from math import comb
from pathlib import Path

from fake_tree import ROOT, FakeTree
from studies import directions, machinability, study, trimming
from studies.intervals import Z_95, Tally, wilson


class Wilson(unittest.TestCase):
    def test_ends_satisfy_the_equation_that_defines_them(self):
        for found, count in ((1, 10), (5, 10), (37, 500), (83, 400), (99_999, 100_000)):
            for end in wilson(found, count):
                self.assertAlmostEqual((found / count - end)**2, Z_95**2 * end * (1 - end) / count, delta=1e-15)

    def test_interval_holds_a_share_about_as_often_as_it_says(self):
        # The exact probability that the interval of a binomial count holds its share.
        for share, count in ((0.05, 400), (0.2, 200), (0.5, 100)):
            held = sum(comb(count, k) * share**k * (1 - share)**(count - k) for k in range(count + 1)
                       if wilson(k, count)[0] <= share <= wilson(k, count)[1])
            self.assertAlmostEqual(held, 0.95, delta=0.02)

    def test_extreme_counts(self):
        self.assertEqual(wilson(0, 0), (0, 1))
        low, high = wilson(0, 1000)
        self.assertEqual(low, 0)
        self.assertAlmostEqual(high, Z_95**2 / (1000 + Z_95**2), delta=1e-15)
        mirrored = wilson(1000, 1000)
        self.assertAlmostEqual(mirrored[0], 1 - high, delta=1e-15)
        self.assertEqual(mirrored[1], 1)
        self.assertRaises(ValueError, wilson, 3, 2)
        self.assertEqual(Tally().percents(), ["", "", ""])


def plan(item):
    return json.loads((ROOT / f"experiments/sweeps/{item}/plan.json").read_text(encoding="utf-8"))


class Trimming(FakeTree):
    def case(self, points, detection, planes, wrong):
        """The row of a case with the same counts in every class of depths."""
        case = {"polyline": f"inputs/wavy-{points}-000.csv", "detection": detection, "exit_code": "0", "message": ""}
        for column in plan("trimming")["columns"]:
            case[column] = {"planes": str(planes), "median_ms": "2"}.get(column.rsplit(".", 1)[-1], str(wrong))
        return case

    def test_counts_are_added_by_points_and_by_depth(self):
        results = [self.case(41, "literal", 10, 1), self.case(41, "literal", 10, 3), self.case(101, "literal", 20, 2)]
        header, rows = trimming.evaluate(results)["result.csv"]
        found = {row[0]: dict(zip(header, row)) for row in rows}
        self.assertEqual(found["wavy, literal, all"]["curves"], 5 * 40)
        self.assertEqual(found["wavy, literal, 41 points"]["curves"], 5 * 20)
        self.assertEqual(found["wavy, literal, 41 points"]["wrong_1_percent"], "20.000")
        self.assertEqual(found["wavy, literal, 101 points"]["wrong_3r_percent"], "10.000")
        self.assertEqual(found["wavy, literal, 0.1 to 1 mm"]["curves"], 40)
        self.assertEqual(found["wavy, literal, 0.1 to 1 mm"]["wrong_2_percent"], "15.000")
        self.assertEqual(found["wavy, literal, all"]["time_3_ms"], "2.000")
        self.assertEqual(found["wavy, literal, no interference"]["time_3_ms"], "")

    def test_cases_are_blocks_with_each_detection(self):
        cases = trimming.prepare(self.root, 1)
        self.assertEqual(len(cases), 2 * 4 * 2)
        for case in cases:
            text = (self.root.parent / case["polyline"]).read_text(encoding="utf-8")
            points = int(case["polyline"].split("-")[-2])
            self.assertEqual(text.count("\n"), 1 + 1000 * points)


class Directions(FakeTree):
    def case(self, name, setting, u, v, code="0"):
        """The row of a case; u and v are points, travel of contacts and travel of tips."""
        cutter, tolerance = setting
        values = {f"{direction}.{column}": str(value) for direction, triple in (("u", u), ("v", v))
                  for column, value in zip(("ncl", "tcd_mm", "tcd_cl_mm"), triple)}
        return {"input": f"inputs/{name}.json", "cutter": cutter, "scallop": str(tolerance), "exit_code": code,
                "message": "", "recommended": "u", **values}

    def test_shares_count_the_cases_whose_cutter_fits(self):
        first, second, _ = directions.SETTINGS
        results = [self.case("bezier-000", first, (100, 50, 50), (200, 60, 60)),  # u is better by all
                   self.case("bezier-000", second, (100, 50, 50), (90, 60, 40)),  # criteria disagree
                   self.case("grid-000", first, (100, 50, 50), (100, 50, 50), code="1"),  # no difference
                   self.case("grid-001", first, ("", "", ""), ("", "", ""), code="4")]
        header, rows = directions.evaluate(results)["result.csv"]
        found = {row[0]: dict(zip(header, row)) for row in rows}
        self.assertEqual((found["all"]["cases"], found["all"]["cutter_fits"]), (4, 3))
        self.assertEqual(found["all"]["ncl_and_tcd_agree_percent"], "66.667")
        self.assertEqual(found["all"]["contacts_and_tips_agree_percent"], "66.667")
        self.assertEqual(found["bezier"]["both_save_percent"], "50.000")
        self.assertEqual(found["bezier"]["one_direction_percent"], "100.000")  # by travel u in both settings
        self.assertEqual(found["grid"]["tcd_median_reduction_percent"], "0.000")
        self.assertEqual(found["nurbs"]["ncl_saves_22_percent"], "")
        self.assertEqual(found["all"]["a_path_gouges_percent"], "33.333")

    def test_a_case_that_failed_otherwise_ends_the_evaluation(self):
        bad = self.case("grid-000", directions.SETTINGS[0], (1, 1, 1), (1, 1, 1), code="7")
        self.assertRaises(SystemExit, directions.evaluate, [bad])

    def test_surfaces_are_written_for_every_setting(self):
        cases = directions.prepare(self.root, 1)
        self.assertEqual(len(cases), 5 * len(directions.SETTINGS))
        for case in cases:
            content = json.loads((self.root.parent / case["input"]).read_text(encoding="utf-8"))
            self.assertEqual(content["format"], "endmill-surface/1")


class Machinability(FakeTree):
    def test_parts_are_counted_by_machine_and_kind(self):
        one, other = list(machinability.MACHINES)[:2]
        results = [{"input": f"inputs/{kind}-000.off", "machine": machine, "exit_code": code, "message": "",
                    "floored_area_deg2": area, "missed_area_share": missed, "proved": proved}
                   for machine, kind, code, area, missed, proved in (
                       (one, "convex", "0", "40", "", "true"), (one, "wheel", "1", "", "0.25", "true"),
                       (other, "convex", "1", "90", "", "false"), (other, "wheel", "1", "", "0.5", "true"))]
        header, rows = machinability.evaluate(results)["result.csv"]
        found = {row[0]: dict(zip(header, row)) for row in rows}
        self.assertEqual((found[one]["parts"], found[one]["machinable_percent"]), (2, "50.000"))
        self.assertEqual((found[one]["machinable_convex"], found[one]["machinable_wheel"]), (1, 0))
        self.assertEqual(found[one]["median_floored_area_deg2"], "40.00")
        self.assertEqual(found[one]["median_missed_area_percent"], "25.0000")
        self.assertEqual(found["any machine"]["machinable_percent"], "50.000")
        self.assertEqual([found[machine]["undecided"] for machine in (one, other)], [0, 1])

    def test_the_bottom_is_left_out(self):
        cases = machinability.prepare(self.root, 1)
        self.assertEqual(len(cases), 5 * len(machinability.MACHINES))
        for case in cases:
            _, counts, *rows = (self.root.parent / case["input"]).read_text(encoding="utf-8").splitlines()
            vertices = int(counts.split()[0])
            heights = [float(row.split()[2]) for row in rows[:vertices]]
            listed = (self.root.parent / case["skip_facets"]).read_text(encoding="utf-8").splitlines()[1:]
            for number in map(int, listed):
                self.assertEqual({heights[int(k)] for k in rows[vertices + number].split()[1:]}, {0})
            self.assertGreater(len(listed), 0)


class Driver(FakeTree):
    def run_study(self, *options):
        item = self.root / "item"
        self.write("item/params.json", '{"parameters": {"size": 2}}')
        self.write("item/plan.json", "{}")
        made = study.Study(item, lambda folder, size: [{"input": f"{folder.name}/{k}"} for k in range(size)],
                           lambda results: {"result.csv": (["row", "n"], [["all", len(results)]])})
        study.main(made, [str(self.root / "out"), *options])

    def test_prepares_and_evaluates_in_two_runs(self):
        self.run_study("3", "--prepare")
        with open(self.root / "out/cases.csv", encoding="utf-8") as file:
            self.assertEqual([row["input"] for row in csv.DictReader(file)], [f"inputs/{k}" for k in range(3)])
        self.assertTrue((self.root / "out/plan.json").is_file())
        self.write("out/sweep/results.csv", "case,exit_code\n0,0\n1,0\n")
        self.assertRaises(SystemExit, self.run_study, "--evaluate")  # a case is missing
        self.write("out/sweep/results.csv", "case,exit_code\n0,0\n1,0\n2,0\n")
        self.run_study("--evaluate")
        self.assertEqual((self.root / "out/result.csv").read_text(encoding="utf-8"), "row,n\nall,3\n")

    def test_refuses_unknown_words(self):
        for words in (["--nonsense"], ["1", "2"], ["--prepare", "--evaluate"]):
            self.assertRaises(SystemExit, self.run_study, *words)

    def test_plans_have_the_columns_of_their_evaluations(self):
        for item in ("trimming", "directions", "machinability"):
            self.assertEqual(plan(item)["format"], "endmill-sweep/1")
            self.assertEqual(plan(item)["list"], study.CASES)
            self.assertTrue(Path(ROOT / f"experiments/sweeps/{item}/main.py").is_file())


if __name__ == "__main__":
    unittest.main()
