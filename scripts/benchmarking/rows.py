# SPDX-License-Identifier: GPL-3.0-or-later
"""The measured rows of a benchmark: what they measure, and how two runs compare."""
import re
import statistics
from dataclasses import dataclass

LIMIT = 1.03  # a median ratio beyond it is a verdict; smaller ones are noise
TIME_OR_MEMORY = {"s", "ms", "us", "ns", "bytes", "MB", "GiB"}


@dataclass(frozen=True)
class Row:
    """One measured row of result.csv."""

    label: str
    unit: str
    value: float


def rows_of(table):
    """label -> Row, from a result.csv with the columns row, measured and unit."""
    labels, values, units = (table.column(name) for name in ("row", "measured", "unit"))
    return {label: Row(label, unit, float(value))
            for label, value, unit in zip(labels, values, units) if value}


def sense(unit):
    """1 if more of it is slower, -1 if more is faster, 0 if it is neither: a ratio, an error."""
    first = re.split(r"[ /]", unit)[0]
    if first in TIME_OR_MEMORY:
        return 1
    return -1 if first == "million" or unit == "times as fast" else 0


def slowdown(old, new):
    """How many times more time or memory `new` needs than `old`."""
    if sense(new.unit) > 0:
        return new.value / old.value
    return old.value / new.value


def verdict(ratio):
    if ratio > LIMIT:
        return "slower"
    return "faster" if ratio < 1 / LIMIT else "same"


def spread_percent(values):
    """Largest less smallest of the values, over their median."""
    middle = statistics.median(values)
    return 100 * (max(values) - min(values)) / abs(middle) if middle else 0.0


def peer_ratio(row, run, peers):
    """How many times more the other library needs; None of a row without one.

    `peers` of params.json leads from the other library's row to ours; a row in the unit
    `times ours` is that ratio itself.
    """
    if row.unit == "times ours":
        return row.value
    ours = run.get(peers.get(row.label))
    return slowdown(ours, row) if ours else None
