# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of a README of datasets."""
import re


def table(path, heading):
    """Under a heading: for every file the cells beside its name."""
    section = path.read_text(encoding="utf-8").split(f"\n## {heading}\n")[1].split("\n## ")[0]
    rows = re.findall(r"^\| `([\w-]+\.\w+)`[^|]*\|(.*)\|$", section, re.MULTILINE)
    return {name: [cell.strip() for cell in cells.split("|")] for name, cells in rows}


def number(text):
    """"59 675" is 59675; a minus sign may be the typographic one."""
    return float(text.replace(" ", "").replace("−", "-"))


def rounds_to(value, text):
    """Whether `value` is `text` to the digits that `text` shows."""
    digits = len(text.partition(".")[2])
    return abs(value - number(text)) <= 0.5 * 10**-digits * (1 + 1e-9)
