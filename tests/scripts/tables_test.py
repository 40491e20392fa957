# SPDX-License-Identifier: GPL-3.0-or-later
"""The reader of CSV files is strict."""
import unittest

from fake_tree import FakeTree
from reproduction.fault import Fault
from reproduction.tables import number, read_table, rounded


class Tables(FakeTree):
    def test_table_has_header_and_rows(self):
        table = read_table(self.write("a.csv", 'row,x\n"a, b",1\nc,\n'), labelled=True)
        self.assertEqual(table.cells()[("a, b", "x")], "1")
        self.assertEqual(table.column("x"), ["1", ""])

    def test_row_keeps_its_line(self):
        table = read_table(self.write("a.csv", 'row,x\n"two\nlines",1\nc,2\n'))
        self.assertEqual(table.lines, [3, 4])

    def test_malformed_table_is_refused(self):
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

    def test_missing_file_is_named(self):
        with self.assertRaisesRegex(Fault, "none.csv"):
            read_table(self.root / "none.csv")

    def test_numbers_of_the_drivers_are_parsed(self):
        for text, value in {"1": 1, "-2.5": -2.5, ".5": 0.5, "1e-3": 0.001, "+4.": 4}.items():
            self.assertEqual(number(text), value)
        for text in ("", "nan", "inf", "1e999", "1_000", " 1", "0x10", "25 %", "1,5"):
            self.assertIsNone(number(text), text)

    def test_numbers_are_rounded_without_an_exponent(self):
        for text, short in {"0.2133449999999204": "0.2133", "20809.349": "20809", "12.5000": "12.5",
                            "-0.00001234567": "-0.00001235", "1234567": "1234567", "-0.0": "0",
                            "1e-12": "1.000e-12", "word": "word", "": ""}.items():
            self.assertEqual(rounded(text), short)


if __name__ == "__main__":
    unittest.main()
