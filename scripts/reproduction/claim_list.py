# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads experiments/claims.csv, the table of every claim of the papers with the row that decides it."""
from dataclasses import dataclass

from .fault import Fault
from .tables import read_table

FILE = "experiments/claims.csv"
COLUMNS = ["id", "paper", "place", "kind", "claim", "experiment", "row", "column", "verdict"]
KINDS = ["cell", "figure", "sentence", "equation", "input", "definition"]
DEFINITION = "definition"  # the verdict of a claim that only defines or motivates something


@dataclass(frozen=True)
class ListedClaim:
    """One claim of a paper. Experiment, row and column are empty for a definition."""

    id: str
    paper: str  # folder of experiments
    place: str  # in the paper
    kind: str  # one of KINDS
    claim: str  # the statement in plain English
    experiment: str  # PAPER/ITEM
    row: str  # of published.csv
    column: str
    verdict: str  # that of the row, or DEFINITION
    line: int  # in claims.csv


def read_claims(root):
    """The claims in the order of the file. Raises Fault if the file is missing or malformed."""
    path = root / FILE
    table = read_table(path)
    if table.header != COLUMNS:
        raise Fault(f"{path}:1: the header must be {','.join(COLUMNS)}")
    return [ListedClaim(*row, line) for row, line in zip(table.rows, table.lines)]
