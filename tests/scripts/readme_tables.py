# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the tables of a README of datasets."""
import re


def table(path, heading):
    """The table under a heading, as the cells beside the name of each file."""
    section = path.read_text(encoding="utf-8").split(f"\n## {heading}\n")[1].split("\n## ")[0]
    rows = re.findall(r"^\| `([\w-]+\.\w+)`[^|]*\|(.*)\|$", section, re.MULTILINE)
    return {name: [cell.strip() for cell in cells.split("|")] for name, cells in rows}


def number(text):
    """Parses a number such as "59 675"; the minus sign may be typographic."""
    return float(text.replace(" ", "").replace("−", "-"))


def rounds_to(value, text):
    """Whether `value` rounds to `text`, in the digits that `text` shows."""
    digits = len(text.partition(".")[2])
    return abs(value - number(text)) <= 0.5 * 10**-digits * (1 + 1e-9)
