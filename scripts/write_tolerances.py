#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/tolerances.md from src/endmill/core/tolerance.h.

    scripts/write_tolerances.py            writes the page
    scripts/write_tolerances.py --check    exits with 1 if the page is out of date
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADER = "src/endmill/core/tolerance.h"
PAGE = "docs/tolerances.md"
CONSTANT = re.compile(r"((?:^/// .*\n)+)^inline constexpr double (\w+) = ([^;]+);", re.M)
INTRODUCTION = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by scripts/write_tolerances.py from src/endmill/core/tolerance.h. -->
# Tolerances

The table lists the tolerances that several files of the library share. A tolerance that one file uses alone is a named
constant in that file, with its unit and its reason. None of them is an option: the options of the program have defaults
of their own, which `endmill COMMAND --help` states.

| name | value | meaning and reason |
| --- | --- | --- |
"""


def page(text):
    """The page for the text of the header."""
    rows = []
    for comment, name, value in CONSTANT.findall(text):
        words = " ".join(line.removeprefix("///").strip() for line in comment.splitlines())
        rows.append(f"| `{name}` | {value} | {words} |\n")
    return INTRODUCTION + "".join(rows)


def main(root, check):
    written = page((root / HEADER).read_text(encoding="utf-8"))
    file = root / PAGE
    if not check:
        file.write_text(written, encoding="utf-8")
        return False
    stale = not file.exists() or file.read_text(encoding="utf-8") != written
    print(f"{PAGE} is stale: run scripts/write_tolerances.py" if stale else f"{PAGE} is up to date")
    return stale


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(f"usage: {sys.argv[0]} [--check]\n\n{__doc__}")
    sys.exit(main(ROOT, "--check" in sys.argv))
