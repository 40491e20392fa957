# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the result of a named experiment its new expected.csv."""
from .compare import compare
from .outcome import read_run
from .run import write_whole
from .tables import read_table


def accept(experiments, say):
    """Copies result.csv to expected.csv. Returns the exit code, 2 if a result is missing or has faults."""
    for experiment in experiments:
        run = read_run(experiment)
        result = experiment.results / "result.csv"
        if run is None or run["exit"] != 0 or not result.is_file():
            say(f"{experiment.name}: no result of a run that succeeded; run it first")
            return 2
        found = read_table(result, labelled=True)
        expected = experiment.folder / "expected.csv"
        if expected.exists():
            declared = experiment.params().get("tolerances", {})
            broken = compare(read_table(expected, labelled=True), found, declared)
            change = f"{len(broken)} differences beyond tolerance from the one before"
        else:
            change = "the first"
        write_whole(expected, result.read_bytes())
        say(f"{experiment.name}: accepted the result of revision {run['revision']} ({change})")
    return 0
