# SPDX-License-Identifier: GPL-3.0-or-later
r"""Finds the macros in the LaTeX source that stand for a cell of a CSV file.

The macros are listed in MACROS. An optional argument in square brackets is the format of the number, for example
\computed[2]{economic-cl-data/exponents}{print u}{tcd_by_tolerance}.
"""
import re
from dataclasses import dataclass

from reproduction.fault import Fault

# Name and number of arguments in braces. paper/macros.tex defines them with the same arguments.
MACROS = {
    "published": 3,  # experiment, row, column: as printed in the paper
    "computed": 3,  # experiment, row, column: cell of result.csv
    "verdict": 3,  # experiment, row, column: of the row in published.csv
    "parameter": 2,  # experiment, keys: of "parameters" in params.json, joined by slashes
    "named": 2,  # experiment, number: in the name of a row or column of result.csv
    "smallest": 3,  # experiment, row pattern, column: least cell
    "largest": 3,  # experiment, row pattern, column: greatest cell
    "quotient": 5,  # experiment, row, column, row, column: first cell divided by the second
    "howmany": 4,  # experiment, row pattern, column, condition: number of rows whose cell holds it
    "claimcount": 2,  # paper or all, verdict or all: rows of claims.csv
    "claimverdict": 1,  # id: verdict in claims.csv
    "figurelines": 1,  # paper: rows of a table with the place, statement and verdict of each of its figures
    "claimline": 1,  # id: claim, what decides it, and verdict as three cells of a table
}
FIGURES = "figureslist"  # paper, label: \\figurelines in a table
BOTH = "both"  # experiment, row, column: \\published and \\computed as two cells of a table
CALL = re.compile(r"\\(" + "|".join([*MACROS, BOTH, FIGURES]) + r")(?![A-Za-z@])")
COMMENT = re.compile(r"(?<!\\)%[^\n]*")


@dataclass(frozen=True)
class Call:
    """One use of a macro, with its place for messages."""

    name: str
    form: str  # the optional argument, empty if there is none
    arguments: tuple  # as written, such as 'chord > delta, \\% of steps'
    place: str  # file:line

    @property
    def key(self):
        """What paper/macros.tex looks up; the same text as written there."""
        return "|".join((self.name, self.form, *self.arguments))

    @property
    def plain(self):
        """The arguments without the escapes of LaTeX."""
        return tuple(re.sub(r"\\([%&#_])", r"\1", text) for text in self.arguments)


def without_comments(text):
    """The text with comments blanked, at the same offsets."""
    return COMMENT.sub(lambda match: " " * len(match.group()), text)


def bracket_end(text, start, opening, closing):
    """The offset behind the bracket that opens at `start`, or None if it is not closed."""
    depth = 0
    for i in range(start, len(text)):
        if text[i - 1] == "\\" and i > start:
            continue
        depth += (text[i] == opening) - (text[i] == closing)
        if depth == 0:
            return i + 1
    return None


def read_argument(text, start, opening, closing):
    """The argument in brackets at `start`, behind blanks, and the offset behind it; None without one."""
    start += len(text[start:]) - len(text[start:].lstrip())
    if text[start:start + 1] != opening:
        return None, start
    end = bracket_end(text, start, opening, closing)
    return (None, start) if end is None else (text[start + 1:end - 1], end)


def find_calls(path):
    """All Calls in the LaTeX file `path`, in order. Raises Fault if arguments are missing."""
    text = without_comments(path.read_text(encoding="utf-8"))
    found = []
    for match in CALL.finditer(text):
        name = match.group(1)
        place = f"{path}:{text.count(chr(10), 0, match.start()) + 1}"
        form, end = read_argument(text, match.end(), "[", "]")
        names = {BOTH: ["published", "computed"], FIGURES: ["figurelines"]}.get(name, [name])
        arguments = []
        for _ in range(MACROS[names[0]]):
            argument, end = read_argument(text, end, "{", "}")
            if argument is None:
                raise Fault(f"{place}: \\{name} needs {MACROS[names[0]]} arguments in braces")
            arguments.append(" ".join(argument.split()))
        found += [Call(each, form or "", tuple(arguments), place) for each in names]
    return found
