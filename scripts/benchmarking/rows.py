# SPDX-License-Identifier: GPL-3.0-or-later
"""The measured rows of a benchmark, and the comparison of two runs."""
import re
import statistics
from dataclasses import dataclass

LIMIT = 1.03  # smaller median ratios are noise and give no verdict
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
    """1 for times and memory, where more is slower, -1 for speeds, and 0 for ratios and errors."""
    first = re.split(r"[ /]", unit)[0]
    if first in TIME_OR_MEMORY:
        return 1
    return -1 if first == "million" or unit == "times as fast" else 0


def slowdown(old, new):
    """The ratio of the time or memory of `new` to that of `old`."""
    if sense(new.unit) > 0:
        return new.value / old.value
    return old.value / new.value


def verdict(ratio):
    if ratio > LIMIT:
        return "slower"
    return "faster" if ratio < 1 / LIMIT else "same"


def spread_percent(values):
    """The range of the values divided by their median."""
    middle = statistics.median(values)
    return 100 * (max(values) - min(values)) / abs(middle) if middle else 0.0


def peer_ratio(row, run, peers):
    """The ratio of the other library to ours, or None for a row without another library.

    `peers` of params.json maps the other library's row to ours. A row in the unit
    `times ours` has the ratio itself.
    """
    if row.unit == "times ours":
        return row.value
    ours = run.get(peers.get(row.label))
    return slowdown(ours, row) if ours else None
