#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks experiments/claims.csv, the table of every claim of the papers, against the files published.csv.

scripts/check_claims.py

A claim names the row of experiments/PAPER/ITEM/published.csv that decides it, and has the verdict of that row. A claim
that only defines or motivates something has the verdict `definition` and names no row. The script reports, with file
and line:

* A claim has an unknown paper, kind, experiment or verdict, or lacks its id, place or text.
* An id stands twice, or a claim stands twice with the same place and row. Several rows may decide one claim.
* A claim names a row that stands in no published.csv, or has another verdict than that row.
* A definition names a row.
* A paper has no claim.
* No claim names a row of a published.csv.

It prints the number of claims by paper and verdict. Exit code 1: something was reported.

Example: scripts/check_claims.py
"""
import sys
from collections import Counter, defaultdict
from pathlib import Path

from reproduction.claim_list import DEFINITION, FILE, KINDS, read_claims
from reproduction.experiments import BESIDE_THE_PAPERS, NOT_A_PAPER, has_driver, place_of_paper
from reproduction.fault import Fault
from reproduction.tables import read_table
from reproduction.verdicts import VERDICTS, checked_rows

ROOT = Path(__file__).resolve().parent.parent
PUBLISHED = "published.csv"


def papers_of(root):
    """The folders of the papers, in the order of the report."""
    folders = {folder.parent.name for folder in (root / "experiments").glob("*/*") if has_driver(folder)}
    return sorted(folders - NOT_A_PAPER - set(BESIDE_THE_PAPERS), key=place_of_paper)


def published_rows(root, bad):
    """Maps (PAPER/ITEM, row, column) to the {verdict: place} of each published.csv.

    A cell that decides several claims in words may have several verdicts.
    """
    rows = defaultdict(dict)
    for file in sorted((root / "experiments").glob(f"*/*/{PUBLISHED}")):
        name, place = f"{file.parent.parent.name}/{file.parent.name}", file.relative_to(root)
        try:
            table = read_table(file)
            for (row, column, _, _, verdict, *_), line in zip(checked_rows(table), table.lines):
                rows[name, row, column].setdefault(verdict, f"{place}:{line}")
        except Fault as fault:
            bad.append(f"{place}: {fault}")
    return rows


def check_fields(claim, root, papers):
    """What is wrong with the cells of a claim."""
    if not (claim.id and claim.place and claim.claim):
        yield "id, place and claim must not be empty"
    if claim.paper not in papers:
        yield f"no paper {claim.paper!r}, expected one of {', '.join(papers)}"
    if claim.kind not in KINDS:
        yield f"kind {claim.kind!r}, expected one of {', '.join(KINDS)}"
    if claim.verdict not in [*VERDICTS, DEFINITION]:
        yield f"verdict {claim.verdict!r}, expected one of {', '.join(VERDICTS)} or {DEFINITION}"
    if claim.verdict == DEFINITION:
        if claim.experiment or claim.row or claim.column:
            yield "a definition names no experiment, row and column"
    elif not is_experiment(root, claim.experiment):
        yield f"no experiment {claim.experiment!r}"


def is_experiment(root, name):
    """Whether `name` is PAPER/ITEM with a driver."""
    return name.count("/") == 1 and has_driver(root / "experiments" / name)


def check_row(claim, rows):
    """What is wrong with the row that a claim names."""
    found = rows.get((claim.experiment, claim.row, claim.column))
    if not found:
        yield f"no row {claim.row!r}, column {claim.column!r} in experiments/{claim.experiment}/{PUBLISHED}"
    elif claim.verdict not in found:
        there = ", ".join(f"{verdict!r} ({place})" for verdict, place in found.items())
        yield f"verdict {claim.verdict!r}, but the row has {there}"


def check_twice(claims):
    """Ids, and claims with one place and row, that stand twice, as (claim, what is wrong)."""
    seen = {}
    for claim in claims:
        whole = (claim.paper, claim.place, claim.claim, claim.experiment, claim.row, claim.column)
        for key, what in ((("id", claim.id), f"id {claim.id!r}"), (whole, "claim")):
            if key in seen:
                yield claim, f"{what} stands twice, see line {seen[key]}"
            seen.setdefault(key, claim.line)


def check(root, claims, papers, bad):
    """Adds all faults to `bad`."""
    rows = published_rows(root, bad)
    faults = list(check_twice(claims))
    for claim in claims:
        wrong = list(check_fields(claim, root, papers))
        if not wrong and claim.verdict != DEFINITION:
            wrong += check_row(claim, rows)
        faults += [(claim, text) for text in wrong]
    bad += [f"{FILE}:{claim.line}: {claim.id}: {text}" for claim, text in sorted(faults, key=lambda f: f[0].line)]
    bad += [f"{FILE}: no claim of the paper {paper!r}" for paper in papers if paper not in {c.paper for c in claims}]
    bad += check_named(claims, rows)


def check_named(claims, rows):
    """The rows that no claim names. A wrong verdict of the only claim is reported elsewhere."""
    named = defaultdict(set)
    for claim in claims:
        named[claim.experiment, claim.row, claim.column].add(claim.verdict)
    for key, places in rows.items():
        for verdict, place in places.items():
            if verdict not in named[key] and (len(places) > 1 or not named[key]):
                yield f"{place}: no claim names row {key[1]!r}, column {key[2]!r} ({verdict})"


def print_counts(claims, papers):
    """Prints the number of claims by paper and verdict."""
    for paper in papers:
        counts = Counter(claim.verdict for claim in claims if claim.paper == paper)
        said = ", ".join(f"{counts[verdict]} {verdict}" for verdict in [*VERDICTS, DEFINITION] if counts[verdict])
        print(f"{paper}: {sum(counts.values())} claims" + (f": {said}" if said else ""))


def main(root):
    try:
        claims = read_claims(root)
    except Fault as fault:
        print(fault)
        return 1
    papers, bad = papers_of(root), []
    check(root, claims, papers, bad)
    for text in bad:
        print(text)
    print_counts(claims, papers)
    print(f"{FILE}: {len(claims)} claims, {len(bad)} fault{'' if len(bad) == 1 else 's'}")
    return 1 if bad else 0


if __name__ == "__main__":
    if sys.argv[1:] in (["--help"], ["-h"]):
        print(__doc__)
        sys.exit(0)
    if sys.argv[1:]:
        sys.exit(f"unknown arguments {sys.argv[1:]}\n\n{__doc__}")
    sys.exit(main(ROOT))
