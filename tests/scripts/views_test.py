# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of experiments: a command of endmill whose page the report links."""
import json
import unittest

from fake_tree import ROOT, FakeTree

from reproduction.experiments import Experiment, find_experiments
from reproduction.fault import Fault
from reproduction.views import PAGE, PROGRAM, commands_of, link, make_view

# A program that writes its words to the page of the folder that follows -o.
WRITES_PAGE = """all="$@"
while [ "$1" != -o ]; do shift; done
mkdir -p "$2" && echo "$all" > "$2/page.html"
"""

# Drawings of which nothing could be turned, and why.
WITHOUT_VIEW = {
    "ball-end-milling/figure-2": "a sketch of the engaged part of one ball, without part and path",
    "ball-end-milling/figure-a-1": "a sketch of the frame of the engagement, without part and path",
    "five-axis-setup/figure-7-10": "sets of a few directions, which belong to no part",
    "interference/figure-2": "curves in one plane that are not trimmed",
}


class Views(FakeTree):
    def experiment(self, view, script):
        """An experiment with a view, and a shell script in place of the program."""
        self.write("experiments/paper/item/params.json", json.dumps({"view": view}))
        self.write(PROGRAM, "#!/bin/sh\n" + script)
        (self.root / PROGRAM).chmod(0o755)
        found = Experiment(self.root, "paper", "item")
        found.results.mkdir(parents=True, exist_ok=True)
        return found

    def test_the_command_writes_the_page_that_the_report_links(self):
        found = self.experiment(["plan", "part.json"], WRITES_PAGE + "exit 1\n")
        self.assertEqual(link(found), "")
        make_view(found)
        self.assertEqual(link(found), f"paper/item/{PAGE}")
        self.assertEqual((found.results / PAGE).read_text(encoding="utf-8"),
                         f"plan part.json --html -o {found.results}/view --force --quiet\n")

    def test_commands_run_in_order_and_the_last_one_writes_the_page(self):
        found = self.experiment([["plan", "part.json", "-o", "@/view/plan"], ["view", "@", "a@b"]],
                                f'echo "$@" >> {self.root}/log\n')
        make_view(found)
        self.assertEqual((self.root / "log").read_text(encoding="utf-8"),
                         f"plan part.json -o {found.results}/view/plan --force --quiet\n"
                         f"view {found.results} a@b -o {found.results}/{PAGE} --force --quiet\n")

    def test_a_build_without_the_page_is_no_fault_and_an_error_is_one(self):
        make_view(self.experiment(["plan"], 'echo "view: the script of the page is missing" >&2; exit 2\n'))
        with self.assertRaisesRegex(Fault, "no such part"):
            make_view(self.experiment([["plan"], ["view"]], 'echo "no such part" >&2; exit 3\n'))

    def test_words_are_texts(self):
        for bad in ("plan", ["plan", 5], [["plan"], "view"], [[]], {"plan": []}):
            with self.assertRaises(Fault):
                commands_of({"view": bad})

    def test_every_experiment_with_a_drawing_has_a_view_or_a_reason(self):
        for experiment in find_experiments(ROOT):
            params = experiment.params()
            has_drawing = any("plot" not in figure for figure in params.get("figures", []))
            with self.subTest(experiment.name):
                self.assertEqual(has_drawing, bool(commands_of(params)) or experiment.name in WITHOUT_VIEW)
                self.assertFalse(commands_of(params) and experiment.name in WITHOUT_VIEW)


if __name__ == "__main__":
    unittest.main()
