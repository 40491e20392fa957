# SPDX-License-Identifier: GPL-3.0-or-later
"""write_experiment_index.py writes the table from the folders and refuses an outdated one."""
import unittest

from fake_tree import ROOT, FakeTree

import write_experiment_index
from reproduction.experiments import find_experiments

README = "# {}\n\n| | |\n|---|---|\n| Claim | a claim |\n| Time | {} |\n"


class Index(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("experiments/paper/README.md", "# A paper (Author)\n")
        self.add("paper/table-2", "Table 2: lengths", "under 1 s")
        self.add("paper/table-10", "Table 10: times", "about 2 minutes", '{"long": true}')

    def add(self, name, title, time, params="{}"):
        self.write(f"experiments/{name}/main.cpp")
        self.write(f"experiments/{name}/params.json", params)
        self.write(f"experiments/{name}/README.md", README.format(title, time))

    def run_script(self, check):
        return self.check(write_experiment_index.main, self.root, check)

    def test_rows_have_title_folder_and_time_in_natural_order(self):
        self.assertEqual(self.run_script(False)[0], 0)
        text = (self.root / "experiments/README.md").read_text(encoding="utf-8")
        rows = [line for line in text.splitlines() if line.startswith("| Table")]
        self.assertEqual(rows, [
            "| Table 2: lengths | [table-2](paper/table-2) | under 1 s |",
            "| Table 10: times | [table-10](paper/table-10) | about 2 minutes (*long*) |"])
        self.assertIn("## [A paper (Author)](paper)", text)
        self.assertEqual(self.run_script(True)[0], 0)

    def test_table_without_an_experiment_is_out_of_date(self):
        self.run_script(False)
        self.add("paper/figure-1", "Figure 1", "under 1 s")
        code, said = self.run_script(True)
        self.assertEqual(code, 1)
        self.assertIn("out of date", said)

    def test_table_with_a_removed_experiment_is_out_of_date(self):
        self.run_script(False)
        (self.root / "experiments/paper/table-2/main.cpp").unlink()
        self.assertEqual(self.run_script(True)[0], 1)

    def test_missing_table_is_out_of_date(self):
        self.assertEqual(self.run_script(True)[0], 1)

    def test_readme_without_title_or_time_is_named(self):
        for text in ("no title\n", "# Only a title\n"):
            self.write("experiments/paper/table-2/README.md", text)
            code, said = self.run_script(False)
            self.assertEqual(code, 1)
            self.assertIn("paper/table-2/README.md", said)


class LongExperiments(unittest.TestCase):
    def test_long_experiments_state_a_time_of_a_minute_or_more(self):
        for experiment in find_experiments(ROOT):
            text = (experiment.folder / "README.md").read_text(encoding="utf-8")
            time = next(line for line in text.splitlines() if line.startswith("| Time |"))
            states_minutes = "under a minute" not in time and ("minute" in time or "about 60 s" in time)
            if states_minutes:
                self.assertTrue(experiment.is_long(), experiment.name)
            if not states_minutes and experiment.paper != "benchmarks":
                self.assertFalse(experiment.is_long(), experiment.name)


if __name__ == "__main__":
    unittest.main()
