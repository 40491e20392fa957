# SPDX-License-Identifier: GPL-3.0-or-later
"""A study by a sweep: its driver writes the inputs, runs `endmill sweep`, and evaluates the results.

The driver experiments/sweeps/ITEM/main.py OUTPUT_FOLDER [SIZE] [--prepare | --evaluate] writes into its folder

  inputs/        the parts or curves of the cases
  cases.csv      the list of cases that plan.json names
  plan.json      a copy of the item's plan
  sweep/         the results of `endmill sweep`
  result.csv     the table of the study

SIZE replaces "size" of params.json. --prepare stops before the sweep, which may then run elsewhere, and --evaluate
begins behind it.
"""
import csv
import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

PROGRAM = "build/release/src/cli/endmill"
CASES = "cases.csv"
PLAN = "plan.json"
INPUTS = "inputs"


@dataclass(frozen=True)
class Study:
    """What the driver of a study has."""

    folder: Path  # of the item, with params.json and plan.json
    prepare: Callable  # (folder of the inputs, size) -> cases as dicts; all have the same keys
    evaluate: Callable  # results as dicts -> tables by file name, as (header, rows); one is result.csv

    def size(self):
        return json.loads((self.folder / "params.json").read_text(encoding="utf-8"))["parameters"]["size"]


def write_csv(path, header, rows):
    """Writes a table whole."""
    partial = path.with_name(path.name + ".partial")
    with open(partial, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)
    os.replace(partial, path)


def prepare(study, output, size):
    """Writes the inputs, the list of cases and the plan."""
    inputs = output / INPUTS
    shutil.rmtree(inputs, ignore_errors=True)
    inputs.mkdir(parents=True)
    cases = study.prepare(inputs, size)
    write_csv(output / CASES, list(cases[0]), [list(case.values()) for case in cases])
    shutil.copyfile(study.folder / PLAN, output / PLAN)


def run_sweep(output):
    """Runs the sweep with one case on each core. Failed cases are rows of its results."""
    words = [PROGRAM, "sweep", str(output / PLAN), "-o", str(output / "sweep"), "--force", "--keep", "none",
             "--jobs", str(os.cpu_count())]
    code = subprocess.run(words, check=False).returncode
    if code not in (0, 1):
        sys.exit(f"{' '.join(words)} ended with exit code {code}")


def read_results(output):
    """The rows of the sweep's results as dicts. Raises SystemExit if a case was not run."""
    def rows(path):
        with open(path, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))
    results, cases = rows(output / "sweep/results.csv"), rows(output / CASES)
    if len(results) != len(cases):
        sys.exit(f"{output}/sweep/results.csv has {len(results)} of {len(cases)} cases")
    return results


def main(study, arguments):
    """The driver of a study."""
    names = [a for a in arguments if not a.startswith("--")]
    options = [a for a in arguments if a.startswith("--")]
    if len(names) not in (1, 2) or not set(options) <= {"--prepare", "--evaluate"} or len(options) > 1:
        sys.exit(__doc__)
    output = Path(names[0])
    if "--evaluate" not in options:
        prepare(study, output, int(names[1]) if len(names) == 2 else study.size())
    if not options:
        run_sweep(output)
    if "--prepare" not in options:
        for name, (header, rows) in study.evaluate(read_results(output)).items():
            write_csv(output / name, header, rows)
