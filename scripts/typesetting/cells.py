# SPDX-License-Identifier: GPL-3.0-or-later
"""Resolves the macros of the paper to the text of a cell."""
import json
import re
from functools import lru_cache
from pathlib import Path

from reproduction.claims import holds
from reproduction.fault import Fault
from reproduction.tables import number, read_table
from reproduction.verdicts import checked_rows, equals_print, is_claim

from .claims_table import merged, shown_verdict
from .numbers import escape, fixed, formatted, grouped, significant

MOST_DECIMALS = 4  # more than the print's, to show a difference that its digits would hide
DEFAULT_DIGITS = 3
SCIENTIFIC_BELOW = 1e-4  # smaller numbers are shown with a power of ten  # significant, of numbers that were not published


def differing(published, computed, digits):
    """`computed` with the print's digits, or with so many more that its difference from the print shows."""
    for decimals in range(max(digits, 0), max(digits, 0) + MOST_DECIMALS):
        text = fixed(computed, decimals)
        if equals_print(published, computed, digits) or text != fixed(published, decimals):
            return text
    return text


def matches(pattern, label):
    """Whether `label` fits a pattern in which * stands for any text."""
    return re.fullmatch(".*".join(map(re.escape, pattern.split("*"))), label) is not None


class Cells:
    """The tables of all experiments: published.csv and params.json of `root`, result.csv of `results`."""

    def __init__(self, root, results, claims):
        self.root, self.results, self.claim_rows = Path(root), Path(results), claims
        self.result = lru_cache(maxsize=None)(self.read_result)
        self.published_rows = lru_cache(maxsize=None)(self.read_published)

    def read_result(self, experiment):
        path = self.results / experiment / "result.csv"
        if not path.is_file():
            raise Fault(f"{path} does not exist; scripts/reproduce.sh {experiment} makes it")
        return read_table(path, labelled=True)

    def read_published(self, experiment):
        """Maps (row, column) to the rows of published.csv with that cell."""
        found = {}
        for row in checked_rows(read_table(self.root / "experiments" / experiment / "published.csv")):
            found.setdefault((row[0], row[1]), []).append(row)
        return found

    def cell(self, experiment, row, column):
        """A cell of result.csv. Raises Fault if there is none or it is empty."""
        table = self.result(experiment)
        where = f"{experiment}/result.csv"
        if column not in table.header:
            raise Fault(f"{where} has no column {column!r}; it has {', '.join(table.header)}")
        cells = table.cells()
        if (row, column) not in cells:
            raise Fault(f"{where} has no row {row!r}")
        if cells[row, column] == "":
            raise Fault(f"{where}: row {row!r}, column {column!r} is empty")
        return cells[row, column]

    def value(self, experiment, row, column):
        """A cell as a number. Raises Fault if it is none."""
        text = self.cell(experiment, row, column)
        if number(text) is None:
            raise Fault(f"{experiment}/result.csv: row {row!r}, column {column!r} is {text!r}, no number")
        return number(text)

    def printed(self, experiment, row, column):
        """The rows of published.csv with a cell. Raises Fault if there is none."""
        rows = self.published_rows(experiment).get((row, column))
        if not rows:
            raise Fault(f"experiments/{experiment}/published.csv has no row {row!r} with column {column!r}")
        return rows

    def published(self, form, experiment, row, column):
        text = self.printed(experiment, row, column)[0][2]
        return grouped(text) if number(text) is not None and not form else escape(text)

    def computed(self, form, experiment, row, column):
        text = self.cell(experiment, row, column)
        value = number(text)
        if value is None:
            return escape(text)
        if form:
            return formatted(value, form)
        for line in self.published_rows_or_none(experiment).get((row, column), []):
            if not is_claim(line) and number(line[2]) is not None:
                return differing(number(line[2]), value, int(line[3]))
        if 0 < abs(value) < SCIENTIFIC_BELOW:
            return formatted(value, f"e{DEFAULT_DIGITS - 1}")
        return grouped(text) if re.fullmatch(r"-?\d+", text) else significant(value, DEFAULT_DIGITS)

    def published_rows_or_none(self, experiment):
        exists = (self.root / "experiments" / experiment / "published.csv").is_file()
        return self.published_rows(experiment) if exists else {}

    def verdict(self, form, experiment, row, column):
        verdicts = {line[4] for line in self.printed(experiment, row, column) if form in line[-2] or not form}
        if len(verdicts) != 1:
            raise Fault(f"experiments/{experiment}/published.csv: row {row!r}, column {column!r} has the verdicts "
                        f"{sorted(verdicts)}; name words of the claim in brackets")
        return shown_verdict(verdicts.pop())

    def parameter(self, form, experiment, keys):
        path = self.root / "experiments" / experiment / "params.json"
        try:
            value = json.loads(path.read_text(encoding="utf-8"))["parameters"]
            for key in keys.split("/"):
                value = value[int(key)] if isinstance(value, list) else value[key]
        except (OSError, ValueError, KeyError, IndexError):
            raise Fault(f"{path} has no parameter {keys!r}") from None
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            return formatted(value, form) if form else grouped(f"{value:.12g}")
        return escape(str(value))

    def named(self, _, experiment, text):
        """A number that labels rows or columns, such as 0.5 in the row `d=0.5 u`."""
        table = self.result(experiment)
        if not any(re.search(rf"(?<![\d.]){re.escape(text)}(?![\d.])", name)
                   for name in table.header + table.column("row")):
            raise Fault(f"{experiment}/result.csv has no row or column whose name contains {text}")
        return grouped(text)

    def values(self, experiment, pattern, column):
        """The numbers of a column in the rows that fit a pattern."""
        table = self.result(experiment)
        if column not in table.header:
            raise Fault(f"{experiment}/result.csv has no column {column!r}")
        found = [number(text) for label, text in zip(table.column("row"), table.column(column))
                 if matches(pattern, label) and number(text) is not None]
        if not found:
            raise Fault(f"{experiment}/result.csv has no number in column {column!r} of rows {pattern!r}")
        return found

    def smallest(self, form, experiment, pattern, column):
        return formatted(min(self.values(experiment, pattern, column)), form or f"s{DEFAULT_DIGITS}")

    def largest(self, form, experiment, pattern, column):
        return formatted(max(self.values(experiment, pattern, column)), form or f"s{DEFAULT_DIGITS}")

    def quotient(self, form, experiment, row, column, other_row, other_column):
        divisor = self.value(experiment, other_row, other_column)
        if divisor == 0:
            raise Fault(f"{experiment}/result.csv: row {other_row!r}, column {other_column!r} is 0, a divisor")
        return formatted(self.value(experiment, row, column) / divisor, form or f"s{DEFAULT_DIGITS}")

    def howmany(self, _, experiment, pattern, column, condition):
        """The number of rows that fit the pattern and whose cell holds the condition; `any` for a cell."""
        table = self.result(experiment)
        if column not in table.header:
            raise Fault(f"{experiment}/result.csv has no column {column!r}")
        cells = [text for label, text in zip(table.column("row"), table.column(column))
                 if matches(pattern, label) and text != ""]
        if not cells:
            raise Fault(f"{experiment}/result.csv has no cell in column {column!r} of rows {pattern!r}")
        return str(len(cells) if condition == "any" else sum(holds(text, condition) for text in cells))

    def claimcount(self, _, paper, verdict):
        rows = [row for row in self.claim_rows
                if paper in ("all", row["paper"]) and verdict in ("all", row["verdict"])]
        if not rows and verdict == "all":
            raise Fault(f"claims.csv has no paper {paper!r}")
        return grouped(str(len(rows)))

    def claim(self, name):
        """The row of claims.csv with an id, or the first part such as K-1a of a claim K-1 that has one verdict.

        Raises Fault if there is none, or if the parts have several verdicts.
        """
        parts = [row for row in self.claim_rows
                 if row["id"] == name or re.fullmatch(rf"{re.escape(name)}([a-z]|-\d+)", row["id"])]
        if not parts:
            raise Fault(f"claims.csv has no claim {name!r}")
        if parts[0]["id"] != name and len({row["verdict"] for row in parts}) > 1:
            raise Fault(f"claims.csv: the parts of {name!r} have several verdicts: "
                        + ", ".join(f"{row['id']} {row['verdict']}" for row in parts))
        return parts[0]

    def claimverdict(self, _, name):
        return shown_verdict(self.claim(name)["verdict"])

    def claimline(self, _, name):
        row = self.claim(name)
        said = rf"{escape(row['claim'])} \place{{{escape(row['id'])}: {escape(row['place'])}}}"
        return f"{said} & {self.decision(row)} & {shown_verdict(row['verdict'])}"

    def figurelines(self, _, paper):
        rows = [row for row in self.claim_rows
                if row["paper"] == paper and row["kind"] == "figure" and row["verdict"] != "definition"]
        if not rows:
            raise Fault(f"claims.csv has no figure of {paper!r}")
        return " ".join(rf"{escape(row['place'])} & {escape(row['claim'])} & {shown_verdict(row['verdict'])}\\"
                        for row in merged(rows))

    def decision(self, claim):
        """What was measured to decide a claim in words; a dash if nothing was."""
        lines = self.published_rows_or_none(claim["experiment"]).get((claim["row"], claim["column"]), [])
        if not lines:
            return "--"
        line = next((line for line in lines if line[4] == claim["verdict"]), lines[0])
        shown = self.cell_or_none(claim["experiment"], claim["row"], claim["column"])
        if not is_claim(line):
            parts = ([f"computed {shown}"] if shown else []) + ([f"printed {escape(line[2])}"] if line[2] else [])
            return ", ".join(parts) or "--"
        condition = line[2].replace("<=", "≤").replace(">=", "≥").removeprefix("= ")
        return (escape(line[6]) + (f": {shown}" if shown else "")
                + (f"; holds if {escape(condition)}" if condition else ""))

    def cell_or_none(self, experiment, row, column):
        """A cell of result.csv in LaTeX, empty if there is none."""
        try:
            text = self.cell(experiment, row, column)
            return self.computed("", experiment, row, column) if number(text) is not None else escape(text)
        except Fault:
            return ""

    def resolve(self, call):
        """The LaTeX text of a Call. Raises Fault with the place of the call."""
        try:
            return getattr(self, call.name)(call.form, *call.plain)
        except Fault as fault:
            raise Fault(f"{call.place}: \\{call.name}: {fault}") from None
