# SPDX-License-Identifier: GPL-3.0-or-later
"""The report opens with each paper in short, stays small, and keeps what only developers need out of the way."""
import re
import unittest
from html import unescape

from fake_tree import ROOT, FakeTree

from reproduction import prose
from reproduction.experiments import PAPERS, find_experiments
from reproduction.figures import figures_of
from reproduction.markup import addresses
from reproduction.outcome import gather
from reproduction.report import render
from reproduction.sections import embedded
from reproduction.summary import IN_SHORT

RESULT = "row,x\na,1\nb,2.5\n"
HEAD = "row,column,published,digits,verdict"
MACHINE = {"cpu": "a processor", "cores": 2, "load_average": [0.1], "compiler": "a compiler"}
MOST_LINES = 8


class Report(FakeTree):
    def add_result(self, name, result=RESULT, figures=None, **files):
        """Adds an experiment that has run. `figures` maps file names to texts."""
        listed = [{"file": file, "caption": f"{file}."} for file in figures or {}]
        self.add_experiment(name, result, {"figures": listed}, **files)
        self.write(f"results/{name}/result.csv", result)
        for file, text in (figures or {}).items():
            self.write(f"results/{name}/{file}", text)
        self.write(f"results/{name}/run.json", '{"exit": 0, "seconds": 1, "started": "now", "revision": "r"}')

    def pages(self):
        outcomes = [gather(e, True) for e in find_experiments(self.root)]
        return render(self.root, outcomes, [], "r", MACHINE, "today")

    def report(self):
        return self.pages()["report.html"]

    def test_each_paper_is_shown_in_short_before_all_else(self):
        self.add_result("paper/table-1")
        self.write("experiments/paper/README.md",
                   "# A paper\n\n## In short\n\n- The print has [one table](table-1).\n"
                   "- See [the method](../../docs/method.md) and [no file](none.md).\n")
        self.write("docs/method.md", "text")
        page = self.report()
        self.assertIn('<li>The print has <a href="#paper-table-1">one table</a>.</li>', page)
        self.assertIn('<li>See <a href="../docs/method.md">the method</a> and no file.</li>', page)
        self.assertLess(page.index("The print has"), page.index("Verdicts</h2>"))

    def test_papers_are_in_the_order_of_the_readme(self):
        for name in sorted(PAPERS):
            self.add_result(f"{name}/table-1")
        page = self.report()
        places = [page.index(f'<h2 id="{name}">') for name in PAPERS]
        self.assertEqual(places, sorted(places))
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        linked = re.findall(r"\(experiments/([\w-]+)/README\.md\)", readme)
        self.assertEqual([name for name in linked if name in PAPERS], PAPERS)

    def test_arithmetic_on_printed_numbers_is_counted_apart(self):
        self.add_result("paper/table-1", published=f"{HEAD}\na,x,1,0,print agrees\nb,x,2.5,1,reproduced\n")
        self.add_result("verification/study", published=f"{HEAD}\na,x,1,0,reproduced\n")
        text = re.sub("<[^>]+>", "", self.report())
        self.assertNotIn("None of its verdicts", text)
        self.assertIn("Of its 2 verdicts, 1 print agrees: arithmetic on printed numbers alone", text)
        self.add_result("paper/table-1", published=f"{HEAD}\na,x,1,0,reproduced\n")
        self.assertIn("None of its verdicts (1) rests on printed numbers alone.", self.report())

    def test_count_links_to_the_rows_with_that_verdict(self):
        self.add_result("paper/table-1", published=f"{HEAD}\na,x,1,0,print agrees\nb,x,2.5,1,reproduced\n")
        pages = self.pages()
        link = '<a href="verdicts.html#verdict-paper-print-agrees">1</a>'
        self.assertIn(link, pages["report.html"])
        section = pages["verdicts.html"].split('id="verdict-paper-print-agrees"')[1]
        place = re.search(r'<td>a: x</td><td>1</td><td>1</td><td><a href="report.html#([\w-]+)">', section)[1]
        self.assertIn(f'<tr id="{place}"><td>a</td>', pages["report.html"])

    def test_column_without_any_text_is_left_out(self):
        self.add_result("paper/table-1", result="row,word\na,yes\n", published=f"{HEAD}\na,word,yes,,reproduced\n")
        head = re.search(r"<thead><tr>(<th>row</th>.*?)</tr>", self.report())[1]
        self.assertEqual(re.sub("<[^>]+>", " ", head).split(), ["row", "column", "published", "computed", "verdict"])

    def test_figure_shows_the_caption_of_the_paper(self):
        self.add_result("paper/figure-1", figures={"x.svg": "<svg/>"})
        params = '{"figures": [{"file": "x.svg", "caption": "Ours.", "published_caption": "Fig. 1 \\"A & B\\""}]}'
        self.write("experiments/paper/figure-1/params.json", params)
        self.assertIn("<figcaption><p>In the paper: Fig. 1 &quot;A &amp; B&quot;</p><p>Here: Ours.</p></figcaption>",
                      self.report())

    def test_a_drawing_opens_its_page_in_3d_and_a_plot_does_not(self):
        self.add_result("paper/figure-1", figures={"x.svg": "<svg/>", "y.svg": "<svg/>"})
        params = '{"figures": [{"file": "x.svg", "caption": "X."}, {"file": "y.svg", "caption": "Y.", "plot": {}}]}'
        self.write("experiments/paper/figure-1/params.json", params)
        self.assertNotIn("view/page.html", self.report())
        self.write("results/paper/figure-1/view/page.html", "a page")
        opened = re.findall(r'<a href="paper/figure-1/view/page.html"><img [^>]*alt="(.*?)"', self.report())
        self.assertEqual(opened, ["X."])

    def test_large_figures_are_files_beside_a_small_page(self):
        heavy = "<svg>" + "x" * 150_000 + "</svg>"
        self.add_result("paper/figure-1", figures={f"{i}.svg": heavy for i in range(30)} | {"small.svg": "<svg/>"})
        page = self.report()
        self.assertLess(len(page.encode()), 4_000_000)
        self.assertGreater(len(page.encode()), 3_500_000)
        self.assertEqual(page.count("<img"), 31)
        linked = re.findall(r'<img loading="lazy" src="(paper/figure-1/\d+\.svg)"', page)
        self.assertGreater(len(linked), 5)
        for file in linked:
            self.assertTrue((self.root / "results" / file).exists())
            self.assertIn(f'<a href="{file}">', page)
        self.assertNotIn("small.svg</a>", page)

    def test_figures_are_embedded_from_the_smallest(self):
        self.add_result("paper/figure-1", figures={"a.svg": "x" * 30, "b.svg": "x" * 3, "c.svg": "x" * 60})
        outcomes = [gather(e, True) for e in find_experiments(self.root)]
        self.assertEqual({file.name for file in embedded(outcomes, 4 + 40)}, {"a.svg", "b.svg"})
        self.assertEqual({file.name for file in embedded(outcomes, 4 + 39)}, {"b.svg"})

    def test_regression_is_only_in_a_closed_part_and_at_the_end(self):
        self.add_result("paper/table-1", expected=RESULT)
        self.write("experiments/paper/table-1/README.md",
                   "# Table\n\n| | |\n| --- | --- |\n| Compared | relative 1e-6 |\n")
        page = self.report()
        seen = re.sub(r"<details>.*?</details>", "", page[:page.index('<h2 id="about">')], flags=re.DOTALL)
        for mark in ("regression", "relative 1e-6", "revision"):
            self.assertNotIn(mark, seen.lower())
            self.assertIn(mark, page.lower())

    def test_departure_from_an_earlier_result_is_shown(self):
        self.add_result("paper/table-1", expected="row,x\na,1\nb,3\n")
        page = self.report()
        self.assertIn("<details open>", page)
        self.assertIn('1 <span class="word bad">broken</span>: <a href="#paper-table-1">', page)

    def test_claims_page_lists_each_claim_with_its_row(self):
        self.add_result("paper/table-1", published=f"{HEAD}\na,x,1,0,reproduced\nb,x,7,0,reproduced\n")
        self.write("experiments/claims.csv", "id,paper,place,kind,claim,experiment,row,column,verdict\n"
                   "A-1,paper,Table 1,cell,It is <1>.,paper/table-1,a,x,reproduced\n"
                   "A-2,paper,Table 1,cell,It is 7.,paper/table-1,b,x,reproduced\n"
                   "A-3,paper,Section 1,definition,It is named.,,,,definition\n")
        pages = self.pages()
        claims, report = pages["claims.html"], pages["report.html"]
        self.assertIn('<a href="claims.html">all 3 claims', report)
        self.assertIn("It is &lt;1&gt;.", claims)
        for place in re.findall(r'href="report.html#([\w-]+)"', claims):
            self.assertIn(f'id="{place}"', report)
        # The second row is marked reproduced, and the computed number contradicts it.
        self.assertRegex(claims, r'It is 7\.</td><td><span class="word bad">differs</span>')
        self.assertIn("3 claims: 1 reproduced, 1 differs, 1 definition.", claims)

    def test_malformed_claims_are_named(self):
        self.add_result("paper/table-1")
        self.write("experiments/claims.csv", "id\nA-1\n")
        pages = self.pages()
        self.assertNotIn("claims.html", pages)
        self.assertIn("claims.csv:1: the header must be", pages["report.html"])


class Papers(unittest.TestCase):
    """The files of the repository."""

    def test_papers_are_in_short_in_at_most_eight_lines_with_links_that_lead_somewhere(self):
        names = {experiment.name for experiment in find_experiments(ROOT)}
        for paper in PAPERS:
            folder = ROOT / "experiments" / paper
            text = (folder / "README.md").read_text(encoding="utf-8")
            items = prose.listed(text, IN_SHORT, addresses(ROOT, folder, names))
            self.assertLessEqual(len(items), MOST_LINES, paper)
            for item in items:
                self.assertNotIn("](", item)
                self.assertIn("<a href=", item, f"{paper}: {unescape(item)}")

    def test_figures_are_described(self):
        for experiment in find_experiments(ROOT):
            figures_of(experiment.params())


if __name__ == "__main__":
    unittest.main()
