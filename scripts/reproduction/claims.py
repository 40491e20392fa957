# SPDX-License-Identifier: GPL-3.0-or-later
"""Claims in words: each is decided by a measured quantity and a threshold."""
import re
from dataclasses import dataclass

from .fault import Fault
from .tables import number, rounded
from .verdicts import WITHOUT_NUMBER, checked_rows, honest, is_claim, warn

SHOWN = ["claim", "measured quantity", "measured", "holds if", "verdict"]
CONDITION = re.compile(r"(<=|>=|<|>|=)\s*(\S.*)")


@dataclass(frozen=True)
class Claim:
    """One claim, with its measured cell and the verdict that this cell supports."""

    text: str
    row: str
    column: str
    quantity: str  # what the cell of result.csv is
    measured: str  # the cell as shown, empty if there is none
    condition: str  # when the claim holds, such as `<= 0.05`
    verdict: str  # one of VERDICTS
    remark: str  # shown after the verdict
    warning: str  # empty if the declared verdict is supported

    @property
    def shown_verdict(self):
        return f"{self.verdict} ({self.remark})" if self.remark else self.verdict

    def shown(self):
        """The texts of the columns SHOWN."""
        return [self.text, self.quantity, self.measured, self.condition, self.shown_verdict]


def holds(measured, condition):
    """Whether the text `measured` meets `condition`: <, <=, > or >= and a number, or = and a text or number.

    Raises Fault if the condition has another form, or needs a number and the cell has none.
    """
    match = CONDITION.fullmatch(condition)
    if not match:
        raise Fault(f"condition {condition!r} in column published, expected <, <=, >, >= or = and a value")
    sign, text = match.groups()
    limit, value = number(text), number(measured)
    if sign == "=":
        return measured == text if limit is None or value is None else value == limit
    if limit is None or value is None:
        raise Fault(f"condition {condition!r} in column published needs two numbers, found {measured!r}")
    return {"<": value < limit, "<=": value <= limit, ">": value > limit, ">=": value >= limit}[sign]


def shown_measure(measured, condition):
    """`measured` with the digits that decide the condition, at least four."""
    texts = (rounded(measured, digits) for digits in range(4, 17))
    return next((text for text in texts if holds(text, condition) == holds(measured, condition)), measured)


def judge_claim(row, cells):
    """The Claim of one row of published.csv, whose column `published` is the condition.

    Raises Fault if the condition cannot be decided.
    """
    label, column, condition, _, declared, text, quantity = row
    measured = cells.get((label, column), "")
    if measured:
        verdict, remark = honest(declared, holds(measured, condition))
    elif declared in WITHOUT_NUMBER:
        verdict, remark = declared, ""
    else:
        raise Fault(f"result.csv has no cell in row {label!r}, column {column!r}")
    shown = shown_measure(measured, condition) if measured else ""
    return Claim(text, label, column, quantity, shown, condition, verdict, remark,
                 warn(declared, verdict, remark))


def judge_claims(published, result):
    """The Claims of published.csv, decided by the table result.csv. Raises Fault if one cannot be decided."""
    found = []
    for row in checked_rows(published):
        try:
            if is_claim(row):
                found.append(judge_claim(row, result.cells()))
        except Fault as fault:
            raise Fault(f"published.csv, claim {row[5]!r}: {fault}") from None
    return found
