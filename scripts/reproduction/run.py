# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs drivers, each in a fresh results folder, and records the circumstances in run.json."""
import json
import os
import shutil
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime, timezone

from . import machine


def write_whole(path, data):
    """Writes bytes so that a killed run leaves the old file or the new one, never half of it."""
    partial = path.with_name(path.name + ".partial")
    partial.write_bytes(data)
    os.replace(partial, path)


def run(experiment, revision, say):
    """Runs one driver; run.json, written last, says that the folder is complete."""
    shutil.rmtree(experiment.results, ignore_errors=True)
    experiment.results.mkdir(parents=True)
    output = str(experiment.results.relative_to(experiment.root))
    circumstances = machine.describe(experiment.root)
    started = datetime.now(timezone.utc)
    start = time.monotonic()
    with open(experiment.results / "run.log", "wb") as log:
        exit_code = call([str(experiment.program), output], experiment.root, log)
    seconds = round(time.monotonic() - start, 3)
    record = {
        "experiment": experiment.name,
        "exit": exit_code,
        "revision": revision,
        "started": started.strftime("%Y-%m-%dT%H:%M:%SZ"),
        "seconds": seconds,
        "machine": circumstances,
    }
    write_whole(experiment.results / "run.json", (json.dumps(record, indent=2) + "\n").encode())
    say(f"  {experiment.name}: {seconds:.2f} s" + (f", exit {exit_code}" if exit_code else ""))


def call(command, folder, log):
    """The exit code of `command`; negative: the signal that ended it; 127: there is no program."""
    try:
        return subprocess.run(command, cwd=folder, stdout=log, stderr=log, check=False).returncode
    except OSError as error:
        log.write(f"{error}\n".encode())
        return 127


def run_all(experiments, revision, say):
    """Runs as many at a time as there are cores; then one by one those that measure time."""
    alone = [e for e in experiments if e.runs_alone()]
    together = [e for e in experiments if e not in alone]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(lambda e: run(e, revision, say), together))
    for experiment in alone:
        run(experiment, revision, say)
