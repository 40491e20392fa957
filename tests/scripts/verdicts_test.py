# SPDX-License-Identifier: GPL-3.0-or-later
"""A verdict is shown only if the computed number supports it."""
import unittest

import fake_tree  # noqa: F401 (finds the scripts)
from reproduction.fault import Fault
from reproduction.tables import Table
from reproduction.verdicts import COLUMNS, SHOWN, VERDICTS, as_text, equals_print, judge


def judged(published, computed, digits, verdict):
    """The line of one published number and one computed cell, or None without a cell."""
    cells = [] if computed is None else [["a", computed]]
    table = Table(COLUMNS, [["a", "x", published, digits, verdict]])
    return judge(table, Table(["row", "x"], cells))[0]


class Verdicts(unittest.TestCase):
    def test_equality_allows_half_a_unit_of_the_last_printed_digit(self):
        self.assertTrue(equals_print(25, 25.5, 0))
        self.assertFalse(equals_print(25, 25.51, 0))
        self.assertTrue(equals_print(20809.3, 20809.349, 1))
        self.assertFalse(equals_print(20809.3, 20809.36, 1))
        self.assertTrue(equals_print(1200, 1249, -2))

    def test_reproduced_is_kept_if_the_numbers_agree(self):
        line = judged("25", "25.08", "0", "reproduced")
        self.assertEqual((line.shown_verdict, line.warning), ("reproduced", ""))
        self.assertEqual((line.computed, line.difference, line.relative_percent),
                         ("25.08", "+0.08", "+0.32"))

    def test_reproduced_becomes_differs_if_the_numbers_differ(self):
        line = judged("828", "820", "0", "reproduced")
        self.assertEqual((line.shown_verdict, line.difference), ("differs", "-8"))
        self.assertIn("reproduced", line.warning)

    def test_differs_gets_a_remark_if_the_numbers_agree(self):
        line = judged("820", "820.2", "0", "differs")
        self.assertEqual(line.shown_verdict, "differs (equal within rounding)")
        self.assertTrue(line.warning)

    def test_arithmetic_on_printed_numbers_agrees_or_disagrees(self):
        for declared in ("print agrees", "print disagrees"):
            equal = judged("60.7", "60.72", "1", declared)
            other = judged("60.7", "60.78", "1", declared)
            self.assertEqual(equal.verdict, declared)
            self.assertEqual(other.verdict, "print disagrees")
            self.assertEqual((bool(equal.warning), bool(other.warning)),
                             (declared == "print disagrees", declared == "print agrees"))

    def test_calibrated_is_kept_for_equal_numbers(self):
        for computed in ("1061", "1066"):
            line = judged("1061", computed, "0", "calibrated")
            self.assertEqual((line.shown_verdict, line.warning), ("calibrated", ""))

    def test_not_recoverable_has_no_number(self):
        line = judged("", None, "", "not recoverable")
        self.assertEqual(line.shown(), ["a", "x", "", "", "", "", "not recoverable"])
        self.assertEqual(line.warning, "")

    def test_missing_number_is_not_reproduced(self):
        line = judged("25", None, "0", "reproduced")
        self.assertEqual(line.shown_verdict, "differs (nothing to compare)")
        self.assertTrue(line.warning)

    def test_words_are_compared_as_texts(self):
        self.assertEqual(judged("feasible", "feasible", "", "reproduced").verdict, "reproduced")
        self.assertEqual(judged("feasible", "infeasible", "", "reproduced").verdict, "differs")

    def test_published_zero_has_no_relative_difference(self):
        self.assertEqual(judged("0", "0.25", "0", "reproduced").relative_percent, "")

    def test_difference_of_angles_or_percentages_has_no_percentage(self):
        for column in ("tilt_deg", "saving_percent"):
            line = judge(Table(COLUMNS, [["a", column, "25", "0", "differs"]]),
                         Table(["row", column], [["a", "28"]]))[0]
            self.assertEqual((line.difference, line.relative_percent), ("+3", ""))

    def test_names_are_compared_as_texts(self):
        line = judged("3", "2", "name", "reproduced")
        self.assertEqual(line.shown(), ["a", "x", "3", "2", "", "", "differs"])
        self.assertEqual(judged("3", "3", "name", "reproduced").verdict, "reproduced")

    def test_number_beside_words_is_rounded(self):
        self.assertEqual(judged("34 s", "0.2133449999999204", "", "not recoverable").computed, "0.2133")
        line = judge(Table(COLUMNS, [["a", "x_ms", "34 s", "", "not recoverable"]]),
                     Table(["row", "x_ms"], [["a", "0.2133449999999204"]]))[0]
        self.assertEqual(line.computed, "0.2133 ms")

    def test_tiny_difference_has_no_sign(self):
        self.assertEqual(judged("2.0", "1.9999999", "1", "reproduced").difference, "0")

    def test_every_verdict_of_the_project_is_known(self):
        for verdict in VERDICTS:
            judged("1", "1", "0", verdict)

    def test_unknown_verdict_or_bad_digits_are_refused(self):
        for digits, verdict in (("0", "agrees"), ("", "reproduced"), ("one", "differs")):
            with self.assertRaises(Fault):
                judged("1", "1", digits, verdict)
        with self.assertRaises(Fault):
            judge(Table(["row", "column"], []), None)

    def test_text_has_one_line_for_each_number(self):
        text = as_text(SHOWN, [judged("25", "25.08", "0", "reproduced")], numeric=range(2, 6))
        self.assertEqual(len(text.splitlines()), 2)
        self.assertRegex(text, r"a +x +25 +25\.08 +\+0\.08 +\+0\.32 +reproduced")


if __name__ == "__main__":
    unittest.main()
