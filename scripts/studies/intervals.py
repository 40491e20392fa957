# SPDX-License-Identifier: GPL-3.0-or-later
"""Confidence intervals of shares."""
from dataclasses import dataclass
from math import sqrt

Z_95 = 1.959963984540054  # the normal distribution has 95 % within this many standard deviations


def wilson(found, count):
    """The 95 % interval of a share of which `found` of `count` independent trials were hits, by Wilson's score.

    The interval holds the shares p with (found / count - p)^2 <= z^2 p (1 - p) / count. It stays within 0 and 1, and
    is not empty at 0 hits. Without trials it is all of 0 to 1.
    """
    if not 0 <= found <= count:
        raise ValueError(f"wilson: {found} hits of {count} trials")
    if count == 0:
        return 0.0, 1.0
    share, weight = found / count, Z_95**2 / count
    middle = (share + weight / 2) / (1 + weight)
    half = Z_95 * sqrt(share * (1 - share) / count + weight / (4 * count)) / (1 + weight)
    return (0.0 if found == 0 else middle - half), (1.0 if found == count else middle + half)


@dataclass
class Tally:
    """Hits among trials."""

    found: int = 0
    count: int = 0

    def add(self, found, count):
        self.found += found
        self.count += count

    def percents(self):
        """The share and its 95 % interval in percent, as texts; empty without trials."""
        if not self.count:
            return ["", "", ""]
        low, high = wilson(self.found, self.count)
        return [f"{100 * share:.3f}" for share in (self.found / self.count, low, high)]


def percent_columns(name):
    """The names of the three texts of `Tally.percents`."""
    return [f"{name}_percent", f"{name}_low", f"{name}_high"]
