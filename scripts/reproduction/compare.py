# SPDX-License-Identifier: GPL-3.0-or-later
"""The regression test: compares result.csv with expected.csv, cell by cell."""
from dataclasses import dataclass

from .fault import Fault
from .tables import number

# Different maths libraries may give different last bits.
DEFAULT = {"relative": 1e-9, "absolute": 1e-12}


@dataclass(frozen=True)
class Broken:
    """A cell that differs from the expected one."""

    row: str
    column: str
    expected: str
    found: str

    def __str__(self):
        place = f"row {self.row!r}, column {self.column!r}" if self.column else self.row
        return f"{place}: expected {self.expected!r}, found {self.found!r}"


def column_tolerances(columns, declared):
    """Maps each column to {"relative": r, "absolute": a}, or to None if it is ignored.

    `declared` is "tolerances" of params.json. Raises Fault for an unknown column, since a
    misspelt name would silently leave the default in force.
    """
    unknown = declared.keys() - set(columns) - {"default"}
    if unknown:
        raise Fault(f"params.json: tolerances for unknown columns {sorted(unknown)}")
    for column, tolerance in declared.items():
        keys = set(tolerance) if isinstance(tolerance, dict) else {None}
        if not keys <= {"relative", "absolute"} and (keys != {"ignore"} or column == "default"):
            raise Fault(f"params.json: tolerance of {column!r}: relative, absolute or ignore")
    default = DEFAULT | declared.get("default", {})
    return {
        column: None if "ignore" in declared.get(column, {}) else default | declared.get(column, {})
        for column in columns
    }


def equal(expected, found, tolerance):
    """Whether two cells agree: numbers within the larger of both tolerances, other texts exactly."""
    a, b = number(expected), number(found)
    if a is None or b is None:
        return expected == found
    return abs(a - b) <= max(tolerance["absolute"], tolerance["relative"] * abs(a))


def compare(expected, found, declared):
    """The cells of the table `found` that differ from `expected`. Rows are matched in order."""
    if expected.header != found.header:
        return [Broken("header", "", ",".join(expected.header), ",".join(found.header))]
    tolerances = column_tolerances(expected.header, declared)
    tolerances["row"] = {"relative": 0, "absolute": 0}
    broken = []
    if len(expected.rows) != len(found.rows):
        broken.append(Broken("count of rows", "", str(len(expected.rows)), str(len(found.rows))))
    for old, new in zip(expected.rows, found.rows):
        for column, was, now in zip(expected.header, old, new):
            tolerance = tolerances[column]
            if tolerance is not None and not equal(was, now, tolerance):
                broken.append(Broken(old[0], column, was, now))
    return broken
