# SPDX-License-Identifier: GPL-3.0-or-later
"""Reproduces experiments up to the report, with drivers that are shell scripts."""
import html
import json
import re
import unittest

from fake_tree import FakeTree
from reproduction.__main__ import reproduce, stages
from reproduction.accept import accept
from reproduction.experiments import find_experiments, long_ones, select

RESULT = "row,x\na,1\nb,2.5\n"
PAYLOAD = "</script><script>alert(1)</script><img src=x onerror=alert(1)>"


def already_built(_root, _experiments):
    """Replaces the build."""


class Reproduce(FakeTree):
    def reproduce(self, *names):
        """Runs the experiments and returns whether all are as expected, and the output."""
        experiments = find_experiments(self.root)
        chosen, unknown = select(experiments, names)
        self.assertEqual(unknown, [])
        good, printed = self.check(reproduce, self.root, experiments, chosen, already_built)
        return bool(good), printed

    def report(self):
        return (self.root / "results/report.html").read_text(encoding="utf-8")

    def test_unchanged_run_passes_and_records_its_circumstances(self):
        self.add_experiment("paper/table-1", RESULT, expected=RESULT)
        good, printed = self.reproduce()
        self.assertTrue(good, printed)
        self.assertIn("regression ok", printed)
        record = json.loads((self.root / "results/paper/table-1/run.json").read_text())
        self.assertEqual(record["exit"], 0)
        self.assertEqual(set(record["machine"]), {"cpu", "cores", "load_average", "compiler"})
        self.assertIn('Regression <span class="word good">ok</span>', self.report())

    def test_driver_is_called_from_the_root_with_its_folder(self):
        self.add_experiment("paper/table-1", RESULT, driver='echo "$1"; pwd')
        self.reproduce()
        log = (self.root / "results/paper/table-1/run.log").read_text()
        self.assertEqual(log, f"results/paper/table-1\n{self.root}\n")

    def test_driver_may_be_a_script_that_runs_the_program(self):
        self.write("experiments/paper/study/main.py",
                   "import sys\nopen(sys.argv[1] + '/result.csv', 'w').write('row,x\\na,1\\n')\n")
        self.write("experiments/paper/study/README.md", "# Study\n\n| Time | under 1 s |\n")
        study, = find_experiments(self.root)
        self.assertEqual((study.name, study.target), ("paper/study", "endmill"))
        self.reproduce()
        self.assertEqual((self.root / "results/paper/study/result.csv").read_text(), "row,x\na,1\n")

    def test_broken_cell_is_listed_and_fails(self):
        self.add_experiment("paper/table-1", RESULT, expected="row,x\na,1\nb,2.6\n")
        good, printed = self.reproduce()
        self.assertFalse(good)
        self.assertIn("row 'b', column 'x': expected '2.6', found '2.5'", printed)
        self.assertIn("broken: 1 cell", self.report())

    def test_crash_fails_and_shows_the_last_output(self):
        self.add_experiment("paper/table-1", RESULT, driver="echo out of luck >&2; exit 3")
        good, printed = self.reproduce()
        self.assertFalse(good)
        self.assertIn("exit code 3", printed)
        self.assertIn("out of luck", printed)

    def test_missing_driver_fails(self):
        self.write("experiments/paper/table-1/main.cpp")
        self.assertFalse(self.reproduce()[0])

    def test_driver_without_a_result_fails(self):
        self.add_experiment("paper/table-1", RESULT, driver='rm "$1/result.csv"')
        self.assertFalse(self.reproduce()[0])

    def test_difference_from_a_published_number_passes(self):
        published = "row,column,published,digits,verdict\na,x,7,0,reproduced\n"
        self.add_experiment("paper/table-1", RESULT, published=published)
        good, printed = self.reproduce()
        self.assertTrue(good)
        self.assertIn("marked 'reproduced', shown as 'differs'", printed)
        self.assertIn('<span class="word bad">differs</span>', self.report())

    def test_item_that_is_not_run_keeps_its_marked_result(self):
        self.add_experiment("paper/table-1", RESULT)
        self.add_experiment("paper/table-2", RESULT)
        self.add_experiment("benchmarks/planner", RESULT)
        self.reproduce("paper")
        self.assertIn("<dt>Never run here</dt><dd>benchmarks/planner</dd>", self.report())
        self.assertNotIn("Not run this time", self.report())
        self.reproduce("experiments/paper/table-2/")
        self.assertEqual(self.report().count("Not run this time"), 1)

    def test_figures_are_embedded_images(self):
        plot = {"csv": "result.csv", "x": "row", "y": ["x"]}
        figures = [{"file": "x.svg", "caption": "A caption.", "plot": plot}]
        self.add_experiment("paper/table-1", RESULT, {"figures": figures})
        self.assertTrue(self.reproduce()[0])
        self.assertIn('<img src="data:image/svg+xml;base64,', self.report())
        self.assertIn("<figcaption><p>A caption.</p></figcaption>", self.report())

    def test_texts_of_an_experiment_are_escaped(self):
        quoted = PAYLOAD.replace('"', '""')
        result = f'row,"{quoted}"\n"{quoted}",1\n'
        published = f'row,column,published,digits,verdict\n"{quoted}","{quoted}",1,0,reproduced\n'
        expected = f'row,"{quoted}"\n"{quoted}",2\n'
        self.add_experiment("paper/table-1", result, published=published, expected=expected)
        self.write("experiments/paper/table-1/README.md",
                   f"# {PAYLOAD}\n\n| | |\n|---|---|\n| Claim | {PAYLOAD} |\n\n{PAYLOAD}\n")
        self.write("experiments/paper/README.md", f"# {PAYLOAD}\n")
        self.reproduce()
        page = self.report()
        self.assertGreater(page.count(html.escape(PAYLOAD)), 5)
        self.assertNotRegex(page, r"(?i)<script|<img src=x|<[^>]+\son\w+=")
        self.assertIn("default-src 'none'; style-src 'unsafe-inline'; img-src data: 'self' file:\"", page)

    def test_every_link_of_the_page_has_a_target(self):
        self.add_experiment("paper/table-1", RESULT, expected=RESULT,
                            published="row,column,published,digits,verdict\na,x,1,0,reproduced\n")
        self.reproduce()
        page = self.report()
        links = re.findall(r'href="([^"]+)"', page)
        self.assertGreaterEqual(len(links), 5)
        for link in links:
            file, _, place = link.partition("#")
            target = self.root / "results" / (file or "report.html")
            self.assertTrue(target.exists(), link)
            if place:
                self.assertIn(f'id="{place}"', target.read_text(encoding="utf-8"))

    def test_first_table_runs_first_and_then_paper_by_paper(self):
        for name in ("a/claims", "a/table-1", "a/table-2", "b/figure-1", "b/table-3"):
            self.add_experiment(name, RESULT)
        order = []

        def build(_root, experiments):
            order.append([e.name for e in experiments])

        experiments = find_experiments(self.root)
        good, printed = self.check(reproduce, self.root, experiments, experiments, build)
        self.assertTrue(good, printed)
        self.assertEqual(order, [["a/table-1"], ["a/claims", "a/table-2"], ["b/figure-1", "b/table-3"]])
        self.assertLess(printed.index("a/table-1: regression"), printed.index("2 experiments of a"))

    def test_single_experiment_builds_only_its_own_driver(self):
        self.add_experiment("a/table-1", RESULT)
        self.add_experiment("a/figure-2", RESULT)
        chosen, _ = select(find_experiments(self.root), ["a/figure-2"])
        self.assertEqual([[e.target for e in stage] for stage in stages(chosen)], [["a-figure-2"]])

    def test_quick_leaves_out_benchmarks_and_unnamed_long_studies(self):
        self.add_experiment("a/table-1", RESULT)
        self.add_experiment("a/study", RESULT, {"long": True})
        self.add_experiment("benchmarks/post", RESULT)
        for names, left_out in (([], ["a/study", "benchmarks/post"]), (["a"], ["a/study"]),
                                (["a/study"], []), (["benchmarks"], []), (["benchmarks/post"], [])):
            chosen, _ = select(find_experiments(self.root), names)
            self.assertEqual([e.name for e in long_ones(chosen, names)], left_out, names)

    def test_accept_copies_the_result_to_the_expected_one(self):
        self.add_experiment("paper/table-1", RESULT, expected="row,x\na,9\n")
        self.assertFalse(self.reproduce()[0])
        code, printed = self.check(accept, find_experiments(self.root), print)
        self.assertEqual(code, 0, printed)
        self.assertTrue(self.reproduce()[0])

    def test_accept_refuses_a_faulty_result(self):
        self.add_experiment("paper/table-1", RESULT, driver="exit 1")
        experiments = find_experiments(self.root)
        self.assertEqual(self.check(accept, experiments, print)[0], 2)
        self.reproduce()
        self.assertEqual(self.check(accept, experiments, print)[0], 2)

    def test_experiments_are_in_natural_order(self):
        ordered = ["interference/a", "ball-end-milling/a", "paper/claims", "paper/figure-5", "paper/figure-12",
                   "verification/a", "benchmarks/a"]
        for name in ["support/x", *reversed(ordered)]:
            self.write(f"experiments/{name}/main.cpp")
        self.assertEqual([e.name for e in find_experiments(self.root)], ordered)

    def test_unknown_name_of_an_experiment_is_refused(self):
        self.add_experiment("paper/table-1", RESULT)
        names = ["paper/table-1", "paper/table-9"]
        chosen, unknown = select(find_experiments(self.root), names)
        self.assertEqual([e.name for e in chosen], ["paper/table-1"])
        self.assertEqual(unknown, ["paper/table-9"])


if __name__ == "__main__":
    unittest.main()
