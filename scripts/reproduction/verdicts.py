# SPDX-License-Identifier: GPL-3.0-or-later
"""Published beside computed numbers, each with the verdict that the computed number supports."""
from dataclasses import dataclass

from .fault import Fault
from .tables import number, plain, rounded

COLUMNS = ["row", "column", "published", "digits", "verdict"]
CLAIM_COLUMNS = COLUMNS + ["claim", "quantity"]  # a row with a claim holds its condition in `published`
NAME = "name"  # in the column `digits`: the number names something, such as a method, and is not measured
INPUT = "–"
VERDICTS = ["reproduced", "print agrees", "print disagrees", "calibrated", "differs", "not recoverable",
            "not in the paper", INPUT]
WITHOUT_NUMBER = {"not recoverable", "not in the paper", INPUT}  # may have no computed cell
# The difference of two angles or percentages needs no percentage of its own.
WITHOUT_PERCENTAGE = ("_percent", "_deg")
UNITS = {"_ms": "ms", "_s": "s", "_min": "min", "_mm": "mm", "_percent": "%", "_deg": "°"}  # by end of a column's name
READING = 1e-9  # relative; decimal and binary numbers rarely agree exactly


@dataclass(frozen=True)
class Line:
    """One published number, with its texts and the verdict that the computed number supports."""

    row: str
    column: str
    published: str
    computed: str
    difference: str
    relative_percent: str
    verdict: str  # one of VERDICTS
    remark: str  # shown after the verdict
    warning: str  # empty if the declared verdict is supported

    @property
    def shown_verdict(self):
        return f"{self.verdict} ({self.remark})" if self.remark else self.verdict

    def shown(self):
        """The texts of the columns SHOWN."""
        return [self.row, self.column, self.published, self.computed, self.difference,
                self.relative_percent, self.shown_verdict]


SHOWN = ["row", "column", "published", "computed", "difference", "difference %", "verdict"]


def equals_print(published, computed, digits):
    """Whether `computed` rounds to a number printed with `digits` decimals."""
    return abs(computed - published) <= 0.5 * 10.0**-digits + READING * abs(published)


REFUTED = {"reproduced": "differs", "print agrees": "print disagrees"}


def honest(declared, equal):
    """The verdict and remark to show for a `declared` one, given whether the numbers are equal."""
    if declared in REFUTED and not equal:
        return REFUTED[declared], ""
    if declared in REFUTED.values() and equal:
        return declared, "equal within rounding"
    return declared, ""


def decimals(value, digits, sign=""):
    """`value` with two decimals more than the print, without trailing zeros."""
    return plain(f"{value:{sign}.{max(digits, 0) + 2}f}")


def judge_line(published_row, cells):
    """The Line of one row of published.csv."""
    row, column, printed, digits, declared = published_row
    computed_text = cells.get((row, column), "")
    published, computed = number(printed), number(computed_text)
    if published is None or computed is None or digits == NAME:
        return judge_text(row, column, printed, computed_text, declared)
    digits = int(digits)
    verdict, remark = honest(declared, equals_print(published, computed, digits))
    difference = computed - published
    percent = ""
    if published and not column.endswith(WITHOUT_PERCENTAGE):
        percent = plain(f"{100 * difference / abs(published):+.2f}")
    return Line(row, column, printed, decimals(computed, digits), decimals(difference, digits, "+"),
                percent, verdict, remark, warn(declared, verdict, remark))


def beside_words(computed, column, printed):
    """The text of a computed cell beside printed words: rounded, with its unit if the words state a quantity."""
    unit = next((unit for end, unit in UNITS.items() if column.endswith(end)), "")
    is_quantity = number(printed) is None and any(character.isdigit() for character in printed)
    return f"{rounded(computed)} {unit}" if unit and is_quantity and number(computed) is not None else rounded(computed)


def judge_text(row, column, printed, computed, declared):
    """The Line of a row in which a cell is not a number or is a name. Such cells are compared as texts."""
    if printed and computed:
        verdict, remark = honest(declared, printed == computed)
    elif declared in WITHOUT_NUMBER:
        verdict, remark = declared, ""
    else:
        verdict = REFUTED.get(declared, declared)
        remark = "nothing to compare"
    return Line(row, column, printed, beside_words(computed, column, printed), "", "",
                verdict, remark, warn(declared, verdict, remark))


def warn(declared, verdict, remark):
    """The warning about a declared verdict that the computed number does not support."""
    if verdict == declared and not remark:
        return ""
    return f"marked {declared!r}, shown as {verdict!r}" + (f" ({remark})" if remark else "")


def judge(published, result):
    """The Lines of the rows of published.csv that are numbers, beside the table result.csv.

    Raises Fault if a row is malformed or stands twice.
    """
    return [judge_line(row[:len(COLUMNS)], result.cells())
            for row in checked_rows(published) if not is_claim(row)]


def is_claim(row):
    """Whether a row of published.csv is a claim in words."""
    return len(row) > len(COLUMNS) and row[len(COLUMNS)] != ""


def checked_rows(published):
    """The rows of published.csv. Raises Fault if a row is malformed or stands twice."""
    if published.header not in (COLUMNS, CLAIM_COLUMNS):
        raise Fault(f"published.csv: the header must be {','.join(COLUMNS)}, with or without claim,quantity")
    seen = set()
    for row in published.rows:
        label, column, text, digits, verdict = row[:len(COLUMNS)]
        where = f"published.csv, row {label!r}, column {column!r}"
        key = (label, column, *row[len(COLUMNS):][:1])  # a cell may decide several claims
        if key in seen:
            raise Fault(f"{where}: stands twice")
        seen.add(key)
        if verdict not in VERDICTS:
            raise Fault(f"{where}: verdict {verdict!r}, expected one of {', '.join(VERDICTS)}")
        is_measure = not is_claim(row) and number(text) is not None and digits != NAME
        if is_measure and not digits.lstrip("-").isdecimal():
            raise Fault(f"{where}: digits {digits!r}, expected the count of decimals printed, or {NAME!r}")
    return published.rows


def as_text(head, judged, numeric):
    """The lines or claims as an aligned table for a terminal. `numeric` columns are aligned to the right."""
    table = [head] + [one.shown() for one in judged]
    widths = [max(len(row[i]) for row in table) for i in range(len(head))]
    return "\n".join(
        "  ".join(
            text.rjust(width) if i in numeric else text.ljust(width)
            for i, (text, width) in enumerate(zip(row, widths))
        ).rstrip()
        for row in table
    )
