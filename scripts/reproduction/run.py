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
    """Writes bytes atomically. A killed run leaves either the old or the new file."""
    partial = path.with_name(path.name + ".partial")
    partial.write_bytes(data)
    os.replace(partial, path)


def run(experiment, revision, say):
    """Runs one driver. It writes run.json last, which marks the folder as complete."""
    shutil.rmtree(experiment.results, ignore_errors=True)
    experiment.results.mkdir(parents=True)
    output = str(experiment.results.relative_to(experiment.root))
    circumstances = machine.describe(experiment.root)
    started = datetime.now(timezone.utc)
    start = time.monotonic()
    with open(experiment.results / "run.log", "wb") as log:
        exit_code = call(experiment.command(output), experiment.root, log)
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
    """The exit code of `command`. It is the negative signal that ended it, or 127 without a program."""
    try:
        return subprocess.run(command, cwd=folder, stdout=log, stderr=log, check=False).returncode
    except OSError as error:
        log.write(f"{error}\n".encode())
        return 127


def run_all(experiments, revision, say):
    """Runs one experiment per core at a time. Runs those that measure time afterwards, one by one."""
    alone = [e for e in experiments if e.runs_alone()]
    together = [e for e in experiments if e not in alone]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(lambda e: run(e, revision, say), together))
    for experiment in alone:
        run(experiment, revision, say)
