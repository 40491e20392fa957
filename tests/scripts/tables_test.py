# SPDX-License-Identifier: GPL-3.0-or-later
"""CSV files are read strictly."""
import unittest

from fake_tree import FakeTree
from reproduction.fault import Fault
from reproduction.tables import number, read_table


class Tables(FakeTree):
    def test_a_table_is_header_and_rows(self):
        table = read_table(self.write("a.csv", 'row,x\n"a, b",1\nc,\n'), labelled=True)
        self.assertEqual(table.cells()[("a, b", "x")], "1")
        self.assertEqual(table.column("x"), ["1", ""])

    def test_what_is_not_quite_a_table_is_refused(self):
        cases = {
            "empty": "",
            "ragged": "row,x\na\n",
            "column twice": "row,x,x\na,1,2\n",
            "label twice": "row,x\na,1\na,2\n",
            "no labels": "x,row\n1,a\n",
            "open quote": 'row,x\n"a,1\n',
        }
        for name, text in cases.items():
            with self.assertRaises(Fault, msg=name):
                read_table(self.write("a.csv", text), labelled=True)

    def test_a_missing_file_is_a_fault_that_names_it(self):
        with self.assertRaisesRegex(Fault, "none.csv"):
            read_table(self.root / "none.csv")

    def test_numbers_are_what_the_drivers_write(self):
        for text, value in {"1": 1, "-2.5": -2.5, ".5": 0.5, "1e-3": 0.001, "+4.": 4}.items():
            self.assertEqual(number(text), value)
        for text in ("", "nan", "inf", "1e999", "1_000", " 1", "0x10", "25 %", "1,5"):
            self.assertIsNone(number(text), text)


if __name__ == "__main__":
    unittest.main()
