#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes experiments/README.md, the table of all experiments, paper by paper.

scripts/write_experiment_index.py [--check]

A row has the title of the experiment's README.md, its folder, and the time that the README states. --check writes nothing and exits with 1 if the table is out of date, or if an
experiment has no README.md with a title and a time.

Example: scripts/write_experiment_index.py --check
"""
import re
import sys
from itertools import groupby
from pathlib import Path

from reproduction.experiments import find_experiments
from reproduction.fault import Fault

ROOT = Path(__file__).resolve().parent.parent
INDEX = "experiments/README.md"
HEAD = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
# Experiments

Each folder `PAPER/ITEM` computes one published table, figure or statement again, or adds a study
of ours. `scripts/reproduce.sh PAPER/ITEM` builds and runs it. Its README.md states the claim, the
input and the meaning of each column. `scripts/reproduce.sh` runs all experiments except those
marked *long*; `scripts/reproduce.sh --full` runs all of them.

Do not edit the tables below: `scripts/write_experiment_index.py` writes them.
"""


def title_of(folder):
    """The first heading of README.md in a folder. Raises Fault without a heading."""
    try:
        text = (folder / "README.md").read_text(encoding="utf-8")
    except OSError:
        raise Fault(f"{folder}: no README.md") from None
    found = re.search(r"^# (.+)$", text, re.MULTILINE)
    if not found:
        raise Fault(f"{folder}/README.md: no line '# Title'")
    return found[1].strip(), text


def row(experiment):
    """The row of one experiment."""
    title, text = title_of(experiment.folder)
    time = re.search(r"^\| Time \| (.+?) \|$", text, re.MULTILINE)
    if not time:
        raise Fault(f"{experiment.folder}/README.md: no row '| Time | ... |'")
    long = " (*long*)" if experiment.is_long() else ""
    return f"| {title} | [{experiment.item}]({experiment.name}) | {time[1]}{long} |"


def index(root):
    """The text of experiments/README.md."""
    lines = [HEAD]
    for paper, group in groupby(find_experiments(root), key=lambda e: e.paper):
        title, _ = title_of(root / "experiments" / paper)
        lines += [f"## [{title}]({paper})\n", "| what | experiment | time |", "| --- | --- | --- |"]
        lines += [row(experiment) for experiment in group]
        lines.append("")
    return "\n".join(lines)


def main(root, check):
    try:
        text = index(root)
    except Fault as fault:
        print(fault)
        return 1
    path = root / INDEX
    if not check:
        path.write_text(text, encoding="utf-8")
        return 0
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        print(f"{INDEX} is out of date: run scripts/write_experiment_index.py")
        return 1
    print(f"{INDEX} is up to date")
    return 0


if __name__ == "__main__":
    if sys.argv[1:] in (["--help"], ["-h"]):
        print(__doc__)
        sys.exit(0)
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(f"unknown arguments {sys.argv[1:]}\n\n{__doc__}")
    sys.exit(main(ROOT, "--check" in sys.argv))
