# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/reproduce.sh, which tells its use."""
import subprocess
import sys
import time
from datetime import datetime, timezone
from pathlib import Path

from . import machine, report
from .accept import accept
from .experiments import find_experiments, select
from .fault import Fault
from .figures import draw_all
from .outcome import gather, read_run
from .run import run_all, write_whole
from .verdicts import as_text

ROOT = Path(__file__).resolve().parents[2]
START = time.monotonic()
CELLS_SHOWN = 20


def say(text):
    print(text, flush=True)


def step(text):
    minutes, seconds = divmod(int(time.monotonic() - START), 60)
    say(f"== [{minutes}:{seconds:02}] {text}")


def build(root):
    """Whether the release preset could be built; cmake says why not."""
    commands = ["cmake --preset release", "cmake --build --preset release"]
    return all(
        subprocess.run(command.split(), cwd=root, check=False).returncode == 0
        for command in commands
    )


def draw(experiment):
    """Draws the figures of a run that succeeded; the faults met."""
    run = read_run(experiment)
    try:
        if run and run["exit"] == 0:
            draw_all(experiment.params(), experiment.results)
    except Fault as fault:
        return [str(fault)]
    return []


def show(outcome):
    """Prints one outcome: published beside computed, then what is wrong."""
    say(f"\n{outcome.experiment.name}: regression {outcome.regression}")
    if outcome.lines:
        say(as_text(outcome.lines))
    for line in outcome.lines:
        if line.warning:
            say(f"warning: row {line.row!r}, column {line.column!r}: {line.warning}")
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
    page = report.render(outcomes, not_run, machine.revision(root), machine.describe(root), date)
    (root / "results").mkdir(exist_ok=True)
    write_whole(root / "results/report.html", page.encode())


def reproduce(root, experiments, chosen):
    """Runs the `chosen` of all `experiments` and reports; whether all are as they were."""
    step(f"running {len(chosen)} experiments")
    run_all(root, chosen, say)
    step("drawing figures")
    faults = {experiment: draw(experiment) for experiment in chosen}
    found = {e: gather(e, e in faults, faults.get(e, ())) for e in experiments}
    outcomes = [outcome for outcome in found.values() if outcome]
    fresh = [outcome for outcome in outcomes if outcome.fresh]
    for outcome in fresh:
        show(outcome)
    write_report(root, outcomes, [e.name for e, outcome in found.items() if not outcome])
    bad = [outcome.experiment.name for outcome in fresh if not outcome.good]
    say("")
    step(f"{len(fresh)} experiments run, {len(bad)} failed or broken")
    for name in bad:
        say(f"  {name}")
    say("report: results/report.html")
    return not bad


def main(arguments):
    accepting = "--accept" in arguments
    names = [a for a in arguments if a != "--accept"]
    # A new expectation is looked at one by one, so --accept takes no whole paper.
    if accepting and not (names and all("/" in name for name in names)):
        say("reproduce.sh: --accept needs PAPER/ITEM, see --help")
        return 2
    experiments = find_experiments(ROOT)
    chosen, unknown = select(experiments, names)
    if unknown:
        say(f"reproduce.sh: no experiment {', '.join(unknown)}; there are:")
        say("\n".join(f"  {e.name}" for e in experiments))
        return 2
    try:
        if accepting:
            return accept(chosen, say)
        step("building (release)")
        if not build(ROOT):
            say("reproduce.sh: the build failed")
            return 1
        return 0 if reproduce(ROOT, experiments, chosen) else 1
    except Fault as fault:
        say(f"error: {fault}")
        return 1
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
