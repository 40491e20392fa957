# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of experiments: a command of endmill whose page the report links."""
import json
import unittest

from fake_tree import ROOT, FakeTree

from reproduction.experiments import Experiment, find_experiments
from reproduction.fault import Fault
from reproduction.views import PAGE, PROGRAM, link, make_view, words_of


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
        # The last word is the folder.
        found = self.experiment(["plan", "part.json"],
                                'for folder; do :; done; mkdir -p "$folder"; echo "$@" > "$folder/page.html"; exit 1\n')
        self.assertEqual(link(found), "")
        make_view(found)
        self.assertEqual(link(found), f"paper/item/{PAGE}")
        self.assertTrue((found.results / PAGE).read_text(encoding="utf-8").startswith("plan part.json --html"))

    def test_a_build_without_the_page_is_no_fault_and_an_error_is_one(self):
        make_view(self.experiment(["plan"], 'echo "view: the script of the page is missing" >&2; exit 2\n'))
        with self.assertRaisesRegex(Fault, "no such part"):
            make_view(self.experiment(["plan"], 'echo "no such part" >&2; exit 3\n'))

    def test_words_are_texts(self):
        with self.assertRaises(Fault):
            words_of({"view": "plan"})
        with self.assertRaises(Fault):
            words_of({"view": ["plan", 5]})

    def test_some_experiments_of_the_repository_have_a_view(self):
        with_view = [e.name for e in find_experiments(ROOT) if words_of(e.params())]
        self.assertGreaterEqual(len(with_view), 4)


if __name__ == "__main__":
    unittest.main()
