# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads CSV files strictly, since a slightly wrong table could compare wrong cells."""
import csv
import re
from dataclasses import dataclass

from .fault import Fault

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def number(text):
    """Parses a finite number. Returns None for any other text."""
    value = float(text) if NUMBER.fullmatch(text) else None
    return None if value in (float("inf"), float("-inf")) else value


@dataclass(frozen=True)
class Table:
    """A header and rows with the same number of texts."""

    header: list
    rows: list

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
            lines = list(csv.reader(file, strict=True))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise Fault(f"{path}: {error}") from None
    if not lines or not lines[0]:
        raise Fault(f"{path}: no header")
    header, rows = lines[0], lines[1:]
    if len(set(header)) != len(header):
        raise Fault(f"{path}: a column name stands twice in the header")
    for i, row in enumerate(rows, start=2):
        if len(row) != len(header):
            raise Fault(f"{path}:{i}: {len(row)} cells, the header has {len(header)}")
    table = Table(header, rows)
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
