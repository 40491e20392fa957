# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads CSV files strictly, since a slightly wrong table could compare wrong cells."""
import csv
import math
import re
from dataclasses import dataclass, field

from .fault import Fault

LONGEST_FRACTION = 9  # decimals; a number that needs more is written with an exponent
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def number(text):
    """Parses a finite number. Returns None for any other text."""
    value = float(text) if NUMBER.fullmatch(text) else None
    return None if value in (float("inf"), float("-inf")) else value


def rounded(text, digits=4):
    """`text`, with a number rounded to so many significant digits. Digits before the point are kept."""
    value = number(text)
    if value is None or abs(value) >= 1e15:
        return text
    decimals = 0 if value == 0 else max(0, digits - 1 - math.floor(math.log10(abs(value))))
    if decimals > LONGEST_FRACTION:
        return f"{value:.{digits - 1}e}"
    return plain(f"{value:.{decimals}f}")


def plain(text):
    """A decimal number without zeros at its end. A zero has no sign."""
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return "0" if text in ("+0", "-0") else text


@dataclass(frozen=True)
class Table:
    """A header and rows with the same number of texts."""

    header: list
    rows: list
    lines: list = field(default_factory=list, compare=False)  # the last line of each row in its file

    def column(self, name):
        """The cells of one column, top to bottom."""
        place = self.header.index(name)
        return [row[place] for row in self.rows]

    def cells(self):
        """Maps (row label, column) to the text, for a table whose column `row` labels the rows."""
        return {
            (label, column): text
            for label, row in zip(self.column("row"), self.rows)
            for column, text in zip(self.header, row)
        }


def read_table(path, labelled=False):
    """Reads the CSV file `path`. A `labelled` table has the first column `row` with unique labels.

    Raises Fault with the place if the file is missing, ragged, not UTF-8 or lacks the labels.
    """
    try:
        with open(path, newline="", encoding="utf-8") as file:
            reader = csv.reader(file, strict=True)
            numbered = [(reader.line_num, row) for row in reader]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise Fault(f"{path}: {error}") from None
    if not numbered or not numbered[0][1]:
        raise Fault(f"{path}: no header")
    header = numbered.pop(0)[1]
    if len(set(header)) != len(header):
        raise Fault(f"{path}: a column name stands twice in the header")
    for line, row in numbered:
        if len(row) != len(header):
            raise Fault(f"{path}:{line}: {len(row)} cells, the header has {len(header)}")
    table = Table(header, [row for _, row in numbered], [line for line, _ in numbered])
    if labelled:
        check_labels(path, table)
    return table


def check_labels(path, table):
    if table.header[0] != "row":
        raise Fault(f"{path}: the first column is {table.header[0]!r}, expected 'row'")
    seen = set()
    for label in table.column("row"):
        if label in seen:
            raise Fault(f"{path}: the row {label!r} stands twice")
        seen.add(label)
