# SPDX-License-Identifier: GPL-3.0-or-later
"""The regression test reports changed cells and no others."""
import unittest

import fake_tree  # noqa: F401 (finds the scripts)
from reproduction.compare import Broken, compare
from reproduction.fault import Fault
from reproduction.tables import Table

EXPECTED = Table(["row", "length_mm", "kind"], [["a", "100", "cut"], ["b", "0", "link"]])


def with_cell(row, column, text):
    rows = [list(r) for r in EXPECTED.rows]
    rows[row][column] = text
    return Table(EXPECTED.header, rows)


class Compare(unittest.TestCase):
    def test_table_equals_itself(self):
        self.assertEqual(compare(EXPECTED, EXPECTED, {}), [])

    def test_number_in_another_notation_is_equal(self):
        self.assertEqual(compare(EXPECTED, with_cell(0, 1, "1.00e2"), {}), [])

    def test_broken_cell_is_named(self):
        broken = compare(EXPECTED, with_cell(0, 1, "100.1"), {})
        self.assertEqual(broken, [Broken("a", "length_mm", "100", "100.1")])

    def test_default_tolerance_is_1e_9_relative(self):
        self.assertEqual(compare(EXPECTED, with_cell(0, 1, "100.00000009"), {}), [])
        self.assertEqual(len(compare(EXPECTED, with_cell(0, 1, "100.0000002"), {})), 1)

    def test_absolute_tolerance_applies_near_zero(self):
        self.assertEqual(compare(EXPECTED, with_cell(1, 1, "1e-13"), {}), [])
        self.assertEqual(len(compare(EXPECTED, with_cell(1, 1, "1e-11"), {})), 1)

    def test_column_may_have_its_own_tolerance(self):
        found = with_cell(0, 1, "100.5")
        self.assertEqual(compare(EXPECTED, found, {"length_mm": {"relative": 0.01}}), [])
        self.assertEqual(compare(EXPECTED, found, {"default": {"absolute": 1}}), [])

    def test_ignored_column_may_have_any_text(self):
        declared = {"length_mm": {"ignore": "a time"}}
        self.assertEqual(compare(EXPECTED, with_cell(0, 1, "7"), declared), [])

    def test_texts_and_labels_must_be_equal(self):
        self.assertEqual(len(compare(EXPECTED, with_cell(0, 2, "link"), {})), 1)
        self.assertEqual(len(compare(EXPECTED, with_cell(0, 0, "A"), {})), 1)

    def test_missing_number_is_broken(self):
        for text in ("", "nan", "inf", "1e999"):
            self.assertEqual(len(compare(EXPECTED, with_cell(0, 1, text), {})), 1, text)

    def test_other_header_or_number_of_rows_is_broken(self):
        other = Table(["row", "length", "kind"], EXPECTED.rows)
        self.assertEqual(compare(EXPECTED, other, {})[0].row, "header")
        shorter = Table(EXPECTED.header, EXPECTED.rows[:1])
        self.assertEqual(compare(EXPECTED, shorter, {}), [Broken("count of rows", "", "2", "1")])

    def test_misspelt_tolerance_is_refused(self):
        for declared in ({"lenght_mm": {}}, {"length_mm": {"rel": 1}}, {"length_mm": 1e-3},
                         {"default": {"ignore": "all"}}):
            with self.assertRaises(Fault, msg=declared):
                compare(EXPECTED, EXPECTED, declared)


if __name__ == "__main__":
    unittest.main()
