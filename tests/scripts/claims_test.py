# SPDX-License-Identifier: GPL-3.0-or-later
"""A claim in words is decided by a measured quantity and a threshold."""
import unittest

import fake_tree  # noqa: F401 (finds the scripts)
from reproduction.claims import holds, judge_claims
from reproduction.fault import Fault
from reproduction.tables import Table
from reproduction.verdicts import CLAIM_COLUMNS, judge


def judged(measured, condition, verdict):
    """The claim of one measured cell, or without a cell."""
    cells = [] if measured is None else [["a", measured]]
    table = Table(CLAIM_COLUMNS, [["a", "x", condition, "", verdict, "It is small.", "its size"]])
    return judge_claims(table, Table(["row", "x"], cells))[0]


class Claims(unittest.TestCase):
    def test_each_condition_has_its_meaning(self):
        for condition, values in {"< 2": (True, False, False), "<= 2": (True, True, False),
                                  "> 2": (False, False, True), ">= 2": (False, True, True),
                                  "= 2": (False, True, False)}.items():
            self.assertEqual(tuple(holds(text, condition) for text in ("1.5", "2.0", "3")), values)

    def test_texts_are_compared_whole(self):
        self.assertTrue(holds("method 3", "= method 3"))
        self.assertFalse(holds("method 2", "= method 3"))

    def test_claim_that_the_measurement_contradicts_differs(self):
        self.assertEqual(judged("0.01", "<= 0.05", "reproduced").shown_verdict, "reproduced")
        claim = judged("0.41", "<= 0.05", "reproduced")
        self.assertEqual(claim.shown_verdict, "differs")
        self.assertTrue(claim.warning)
        self.assertEqual(judged("0.41", "<= 0.05", "differs").warning, "")

    def test_claim_marked_differs_that_holds_gets_a_warning(self):
        self.assertTrue(judged("0.01", "<= 0.05", "differs").warning)

    def test_measured_number_has_the_digits_that_decide(self):
        self.assertEqual(judged("0.412345678", "<= 0.05", "differs").measured, "0.4123")
        self.assertEqual(judged("0.05000012345", "<= 0.05", "differs").measured, "0.0500001")
        self.assertEqual(judged("method 3", "= method 3", "reproduced").measured, "method 3")

    def test_claim_that_nothing_decides_needs_no_cell(self):
        self.assertEqual(judged(None, "", "not recoverable").verdict, "not recoverable")

    def test_bad_claims_are_refused(self):
        for measured, condition, verdict in (("1", "about 1", "reproduced"), ("one", "< 1", "reproduced"),
                                             ("1", "< one", "reproduced"), ("1", "< 2", "agrees"),
                                             (None, "< 2", "reproduced")):
            with self.assertRaises(Fault):
                judged(measured, condition, verdict)
        with self.assertRaises(Fault):
            judge_claims(Table(["claim"], []), Table(["row"], []))

    def test_numbers_and_claims_stand_in_one_table(self):
        rows = [["a", "x", "1.5", "1", "reproduced", "", ""],
                ["a", "y", "> 1", "", "reproduced", "It is large.", "its size"]]
        table, result = Table(CLAIM_COLUMNS, rows), Table(["row", "x", "y"], [["a", "1.52", "3"]])
        self.assertEqual([line.column for line in judge(table, result)], ["x"])
        self.assertEqual([claim.column for claim in judge_claims(table, result)], ["y"])

    def test_row_that_stands_twice_is_refused(self):
        rows = [["a", "x", limit, "", "reproduced", "It is large.", "its size"] for limit in ("> 1", "> 2")]
        with self.assertRaisesRegex(Fault, "stands twice"):
            judge(Table(CLAIM_COLUMNS, rows), Table(["row", "x"], [["a", "1"]]))


if __name__ == "__main__":
    unittest.main()
