# SPDX-License-Identifier: GPL-3.0-or-later
"""A verdict is shown only as far as the computed number bears it out."""
import unittest

import fake_tree  # noqa: F401 (finds the scripts)
from reproduction.fault import Fault
from reproduction.tables import Table
from reproduction.verdicts import COLUMNS, VERDICTS, as_text, equals_print, judge


def judged(published, computed, digits, verdict):
    """The line of one published number beside one computed cell (None: there is none)."""
    cells = [] if computed is None else [["a", computed]]
    table = Table(COLUMNS, [["a", "x", published, digits, verdict]])
    return judge(table, Table(["row", "x"], cells))[0]


class Verdicts(unittest.TestCase):
    def test_equal_to_the_print_means_half_a_unit_of_its_last_digit(self):
        self.assertTrue(equals_print(25, 25.5, 0))
        self.assertFalse(equals_print(25, 25.51, 0))
        self.assertTrue(equals_print(20809.3, 20809.349, 1))
        self.assertFalse(equals_print(20809.3, 20809.36, 1))
        self.assertTrue(equals_print(1200, 1249, -2))

    def test_reproduced_stays_where_the_numbers_agree(self):
        line = judged("25", "25.08", "0", "reproduced")
        self.assertEqual((line.shown_verdict, line.warning), ("reproduced", ""))
        self.assertEqual((line.computed, line.difference, line.relative_percent),
                         ("25.08", "+0.08", "+0.32"))

    def test_reproduced_turns_into_differs_where_they_do_not(self):
        line = judged("828", "820", "0", "reproduced")
        self.assertEqual((line.shown_verdict, line.difference), ("differs", "-8"))
        self.assertIn("reproduced", line.warning)

    def test_differs_says_so_where_the_numbers_agree_after_all(self):
        line = judged("820", "820.2", "0", "differs")
        self.assertEqual(line.shown_verdict, "differs (equal within rounding)")
        self.assertTrue(line.warning)

    def test_calibrated_stays_calibrated_however_well_it_agrees(self):
        for computed in ("1061", "1066"):
            line = judged("1061", computed, "0", "calibrated")
            self.assertEqual((line.shown_verdict, line.warning), ("calibrated", ""))

    def test_what_cannot_be_recovered_has_no_number(self):
        line = judged("", None, "", "not recoverable")
        self.assertEqual(line.shown(), ["a", "x", "", "", "", "", "not recoverable"])
        self.assertEqual(line.warning, "")

    def test_nothing_computed_is_not_reproduced(self):
        line = judged("25", None, "0", "reproduced")
        self.assertEqual(line.shown_verdict, "differs (nothing to compare)")
        self.assertTrue(line.warning)

    def test_words_are_compared_as_words(self):
        self.assertEqual(judged("feasible", "feasible", "", "reproduced").verdict, "reproduced")
        self.assertEqual(judged("feasible", "infeasible", "", "reproduced").verdict, "differs")

    def test_a_published_zero_has_no_relative_difference(self):
        self.assertEqual(judged("0", "0.25", "0", "reproduced").relative_percent, "")

    def test_a_tiny_difference_has_no_sign(self):
        self.assertEqual(judged("2.0", "1.9999999", "1", "reproduced").difference, "0")

    def test_every_verdict_of_the_project_is_known(self):
        for verdict in VERDICTS:
            judged("1", "1", "0", verdict)

    def test_what_is_no_verdict_or_no_count_of_digits_is_refused(self):
        for digits, verdict in (("0", "agrees"), ("", "reproduced"), ("one", "differs")):
            with self.assertRaises(Fault):
                judged("1", "1", digits, verdict)
        with self.assertRaises(Fault):
            judge(Table(["row", "column"], []), None)

    def test_the_text_is_a_table_with_a_line_each(self):
        text = as_text([judged("25", "25.08", "0", "reproduced")])
        self.assertEqual(len(text.splitlines()), 2)
        self.assertRegex(text, r"a +x +25 +25\.08 +\+0\.08 +\+0\.32 +reproduced")


if __name__ == "__main__":
    unittest.main()
