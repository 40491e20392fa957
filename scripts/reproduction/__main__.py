# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/reproduce.sh, whose --help describes it."""
import subprocess
import sys
import time
from datetime import datetime, timezone
from itertools import groupby
from pathlib import Path

from . import claims, machine, report
from .accept import accept
from .experiments import find_experiments, long_ones, select
from .fault import Fault
from .figures import draw_all
from .outcome import gather, read_run
from .run import run_all, write_whole
from .verdicts import SHOWN, as_text
from .views import commands_of, make_view

ROOT = Path(__file__).resolve().parents[2]
START = time.monotonic()
CELLS_SHOWN = 20


def say(text):
    print(text, flush=True)


def step(text):
    minutes, seconds = divmod(int(time.monotonic() - START), 60)
    say(f"== [{minutes}:{seconds:02}] {text}")


def run_whole(command, root):
    """Runs a command. Raises Fault if it fails."""
    if subprocess.run(command, cwd=root, check=False).returncode != 0:
        raise Fault(f"{' '.join(command)} failed, see above")


def build(root, experiments):
    """Builds the drivers of the experiments, and the program for those that are scripts."""
    targets = list(dict.fromkeys([e.target for e in experiments] +
                                 ["endmill" for e in experiments if commands_of(e.params())]))
    run_whole(["cmake", "--build", "--preset", "release", "--target", *targets], root)


def draw(experiment):
    """Draws the figures of a successful run. Returns the faults."""
    run = read_run(experiment)
    try:
        if run and run["exit"] == 0:
            draw_all(experiment.params(), experiment.results)
            make_view(experiment)
    except Fault as fault:
        return [str(fault)]
    return []


def show(outcome):
    """Prints one outcome: published beside computed numbers, then the faults."""
    say(f"\n{outcome.experiment.name}: regression {outcome.regression}")
    if outcome.lines:
        say(as_text(SHOWN, outcome.lines, numeric=range(2, 6)))
    if outcome.claims:
        say(as_text(claims.SHOWN, outcome.claims, numeric=[2]))
    for judged in [*outcome.lines, *outcome.claims]:
        if judged.warning:
            say(f"warning: row {judged.row!r}, column {judged.column!r}: {judged.warning}")
    for fault in outcome.faults:
        say(f"error: {fault}")
    if outcome.run["exit"] != 0:
        say("\n".join(f"  | {line}" for line in last_words(outcome.experiment)))
    for cell in outcome.broken[:CELLS_SHOWN]:
        say(f"broken: {cell}")
    if len(outcome.broken) > CELLS_SHOWN:
        say(f"broken: and {len(outcome.broken) - CELLS_SHOWN} cells more")


def last_words(experiment):
    log = (experiment.results / "run.log").read_text(encoding="utf-8", errors="replace")
    return log.splitlines()[-10:]


def write_report(root, outcomes, not_run):
    date = datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    pages = report.render(root, outcomes, not_run, machine.revision(root), machine.describe(root), date)
    (root / "results").mkdir(exist_ok=True)
    for name, text in pages.items():
        write_whole(root / "results" / name, text.encode())


def stages(chosen):
    """The groups of experiments that are built and run one after the other.

    The first table is a group of its own, so that it is printed as early as possible.
    """
    first = next((e for e in chosen if e.item.startswith("table")), chosen[0])
    rest = [e for e in chosen if e != first]
    return [[first]] + [list(group) for _, group in groupby(rest, key=lambda e: e.paper)]


def run_stage(stage, revision):
    """Runs the experiments of a stage, draws their figures and prints their outcomes."""
    run_all(stage, revision, say)
    faults = {experiment: draw(experiment) for experiment in stage}
    outcomes = [gather(e, True, faults[e]) for e in stage]
    for outcome in outcomes:
        show(outcome)
    return outcomes


def reproduce(root, experiments, chosen, build_drivers=build):
    """Builds and runs the `chosen` of all `experiments`. Returns whether all are as expected."""
    # Read the revision before the runs, since files that are edited meanwhile do not affect the results.
    revision = machine.revision(root)
    fresh = []
    for stage in stages(chosen):
        step(f"building {count(stage)}")
        build_drivers(root, stage)
        step(f"running {count(stage)}")
        fresh += run_stage(stage, revision)
    by_name = {outcome.experiment: outcome for outcome in fresh}
    found = {e: by_name.get(e) or gather(e, False) for e in experiments}
    outcomes = [outcome for outcome in found.values() if outcome]
    write_report(root, outcomes, [e.name for e, outcome in found.items() if not outcome])
    bad = [outcome.experiment.name for outcome in fresh if not outcome.good]
    say("")
    step(f"{len(fresh)} experiments run, {len(bad)} failed or broken")
    for name in bad:
        say(f"  {name}")
    say("report: results/report.html")
    return not bad


def count(stage):
    """The name of the only experiment, or the number of experiments and their paper."""
    return stage[0].name if len(stage) == 1 else f"{len(stage)} experiments of {stage[0].paper}"


def say_left_out(left_out):
    """Prints the experiments that --quick leaves out."""
    if left_out:
        names = [e.name for e in left_out if e.paper != "benchmarks"]
        names += ["benchmarks"] if any(e.paper == "benchmarks" for e in left_out) else []
        say(f"left out by --quick: {', '.join(names)} (--full runs them)")


def main(arguments):
    options = [a for a in arguments if a.startswith("-")]
    names = [a for a in arguments if not a.startswith("-")]
    if "--quick" in options and "--full" in options:
        say("reproduce.sh: --quick and --full exclude each other")
        return 2
    # The user must examine each new expected.csv, so --accept does not take a whole paper.
    if "--accept" in options and not (names and all("/" in name for name in names)):
        say("reproduce.sh: --accept needs PAPER/ITEM, see --help")
        return 2
    experiments = find_experiments(ROOT)
    chosen, unknown = select(experiments, names)
    if unknown:
        say(f"reproduce.sh: no experiment {', '.join(unknown)}; there are:")
        say("\n".join(f"  {e.name}" for e in experiments))
        return 2
    try:
        if "--accept" in options:
            return accept(chosen, say)
        left_out = [] if "--full" in options else long_ones(chosen, names)
        chosen = [e for e in chosen if e not in left_out]
        if not chosen:
            say("reproduce.sh: every experiment that was named is long; use --full")
            return 2
        step("configuring build/release")
        run_whole(["cmake", "--preset", "release"], ROOT)
        good = reproduce(ROOT, experiments, chosen)
        say_left_out(left_out)
        return 0 if good else 1
    except Fault as fault:
        say(f"error: {fault}")
        return 1
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
