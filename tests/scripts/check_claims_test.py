# SPDX-License-Identifier: GPL-3.0-or-later
"""check_claims.py accepts a table of claims that agrees with each published.csv, and names each fault with its line."""
import csv
import io
import unittest

from fake_tree import FakeTree

import check_claims
from reproduction.claim_list import COLUMNS, FILE

PUBLISHED = ("row,column,published,digits,verdict,claim,quantity\n"
             "a,x,1,0,reproduced,,\n"
             'a,y,< 2,,differs,"It is\nsmall.",its size\n')
CELL = ["A-1", "paper", "Table 1", "cell", "It is 1.", "paper/table-1", "a", "x", "reproduced"]
SENTENCE = ["A-2", "paper", "Section 2", "sentence", "It is small.", "paper/table-1", "a", "y", "differs"]
DEFINITION = ["A-3", "paper", "Section 1", "definition", "It is named.", "", "", "", "definition"]


def changed(entry, **cells):
    """A claim with other cells in the named columns."""
    return [cells.get(name, cell) for name, cell in zip(COLUMNS, entry)]


class CheckClaims(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("experiments/paper/table-1/main.cpp")
        self.write("experiments/support/x/main.cpp")
        self.write("experiments/verification/study/main.cpp")
        self.write("experiments/paper/table-1/published.csv", PUBLISHED)

    def run_script(self, *claims, header=None):
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows([header or COLUMNS, *claims])
        self.write(FILE, text.getvalue())
        return self.check(check_claims.main, self.root)

    def assert_named(self, expected, *claims):
        """Asserts that the script fails, and that the only fault is `expected`."""
        code, said = self.run_script(*claims)
        self.assertEqual(code, 1, said)
        self.assertIn(expected, said)
        self.assertIn(" 1 fault\n", said)

    def test_claims_that_agree_pass_and_are_counted(self):
        second = changed(CELL, id="A-4", place="Section 3")  # a row may decide several claims
        third = changed(SENTENCE, id="A-5", row="a", column="x", verdict="reproduced")  # two rows decide one claim
        code, said = self.run_script(CELL, SENTENCE, DEFINITION, second, third)
        self.assertEqual(code, 0, said)
        self.assertIn("paper: 5 claims: 3 reproduced, 1 differs, 1 definition\n", said)

    def test_bad_cell_is_named_with_its_line(self):
        for cells, expected in (({"kind": "table"}, "kind 'table'"), ({"verdict": "proved"}, "verdict 'proved'"),
                                ({"paper": "support"}, "no paper 'support'"),
                                ({"place": ""}, "id, place and claim must"),
                                ({"experiment": "paper/table-9"}, "no experiment 'paper/table-9'"),
                                ({"experiment": ""}, "no experiment ''"),
                                ({"verdict": "calibrated"}, "verdict 'calibrated', but the row has 'reproduced' "
                                                            "(experiments/paper/table-1/published.csv:2)")):
            self.assert_named(f"{FILE}:4: A-4: {expected}", CELL, SENTENCE, changed(CELL, id="A-4", claim="x", **cells))

    def test_row_that_is_not_published_is_named(self):
        for cells in ({"row": "b"}, {"column": "z"}):
            self.assert_named(f"{FILE}:4: A-4: no row", CELL, SENTENCE, changed(CELL, id="A-4", claim="x", **cells))

    def test_definition_with_a_row_is_named(self):
        self.assert_named(f"{FILE}:4: A-3: a definition names no", CELL, SENTENCE, changed(DEFINITION, row="a"))

    def test_id_or_claim_that_stands_twice_is_named(self):
        self.assert_named(f"{FILE}:4: A-1: id 'A-1' stands twice, see line 2", CELL, SENTENCE,
                          changed(DEFINITION, id="A-1"))
        self.assert_named(f"{FILE}:4: A-4: claim stands twice, see line 2", CELL, SENTENCE, changed(CELL, id="A-4"))

    def test_paper_without_a_claim_is_named(self):
        self.write("experiments/other/figure-1/main.cpp")
        self.assert_named(f"{FILE}: no claim of the paper 'other'", CELL, SENTENCE)

    def test_published_row_without_a_claim_is_named_with_its_line(self):
        self.assert_named("experiments/paper/table-1/published.csv:4: no claim names row 'a', column 'y'", CELL)

    def test_cell_with_two_verdicts_needs_a_claim_for_each(self):
        another = "a,y,< 9,,reproduced,It is finite.,its size\n"
        self.write("experiments/paper/table-1/published.csv", PUBLISHED + another)
        finite = changed(SENTENCE, id="A-4", claim="It is finite.", verdict="reproduced")
        self.assertEqual(self.run_script(CELL, SENTENCE, finite)[0], 0)
        self.assert_named("published.csv:5: no claim names row 'a', column 'y' (reproduced)", CELL, SENTENCE)

    def test_malformed_files_are_named(self):
        code, said = self.run_script(CELL, header=[*COLUMNS[:-1], "judgement"])
        self.assertEqual(code, 1)
        self.assertIn("claims.csv:1: the header must be", said)
        self.write("experiments/paper/table-1/published.csv", "row,column\n")
        self.assertIn("experiments/paper/table-1/published.csv: ", self.run_script(DEFINITION)[1])

    def test_missing_table_is_named(self):
        code, said = self.check(check_claims.main, self.root)
        self.assertEqual(code, 1)
        self.assertIn(FILE, said)


if __name__ == "__main__":
    unittest.main()
