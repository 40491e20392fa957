# SPDX-License-Identifier: GPL-3.0-or-later
"""The result of one experiment, compared with its expected.csv and published.csv."""
import json
from dataclasses import dataclass, field

from .claims import judge_claims
from .compare import compare
from .experiments import Experiment
from .fault import Fault
from .figures import figures_of
from .tables import Table, read_table
from .verdicts import judge


@dataclass
class Outcome:
    """One experiment as the report shows it."""

    experiment: Experiment
    fresh: bool  # run this time; otherwise the result of an earlier run
    run: dict  # run.json
    faults: list  # texts, such as on a crash or a malformed file
    result: Table = Table([], [])  # result.csv
    lines: list = field(default_factory=list)  # verdicts.Line
    claims: list = field(default_factory=list)  # claims.Claim
    broken: list = field(default_factory=list)  # compare.Broken
    has_expected: bool = False
    figures: list = field(default_factory=list)  # the figures of params.json whose files exist

    @property
    def regression(self):
        """`ok`, `broken: N cells`, `no expected.csv`, or a text that nothing can be compared."""
        if self.faults:
            return "failed"
        if not self.has_expected:
            return "no expected.csv"
        count = len(self.broken)
        return f"broken: {count} cell{'' if count == 1 else 's'}" if count else "ok"

    @property
    def verdicts(self):
        """The verdicts of all published numbers and claims."""
        return [judged.verdict for judged in [*self.lines, *self.claims]]

    @property
    def good(self):
        return not self.faults and not self.broken


def read_run(experiment):
    """run.json of the last complete run, or None."""
    try:
        return json.loads((experiment.results / "run.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None


def gather(experiment, fresh, faults=()):
    """The Outcome of `experiment`, or None without a result."""
    run = read_run(experiment)
    if run is None:
        return None
    outcome = Outcome(experiment, fresh, run, list(faults))
    if run["exit"] != 0:
        outcome.faults.insert(0, f"the driver ended with exit code {run['exit']}; see run.log")
        return outcome
    try:
        examine(outcome)
    except Fault as fault:
        outcome.faults.append(str(fault))
    return outcome


def examine(outcome):
    """Reads the files of the experiment and of its result into `outcome`."""
    experiment = outcome.experiment
    params = experiment.params()
    outcome.figures = [f for f in figures_of(params) if (experiment.results / f["file"]).is_file()]
    result = outcome.result = read_table(experiment.results / "result.csv", labelled=True)
    published = experiment.folder / "published.csv"
    if published.exists():
        table = read_table(published)
        outcome.lines = judge(table, result)
        outcome.claims = judge_claims(table, result)
    expected = experiment.folder / "expected.csv"
    outcome.has_expected = expected.exists()
    if outcome.has_expected:
        declared = params.get("tolerances", {})
        outcome.broken = compare(read_table(expected, labelled=True), result, declared)
