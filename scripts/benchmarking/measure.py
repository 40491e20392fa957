# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs benchmarks and writes their results."""
import csv
import io
import json
import os
import shutil
import statistics
import subprocess

from reproduction import machine
from reproduction.fault import Fault
from reproduction.run import write_whole
from reproduction.tables import read_table

from .rows import peer_ratio, rows_of, sense, slowdown, spread_percent, verdict

MACHINE = ["cpu", "cores", "load_average", "compiler"]
RUN_HEAD = ["revision", *MACHINE, "benchmark", "row", "unit", "runs", "median", "spread_percent",
            "ratio_to_peer"]
COMPARE_HEAD = ["old_revision", "new_revision", *MACHINE, "benchmark", "row", "unit", "pairs",
                "old_median", "new_median", "ratio", "least_ratio", "largest_ratio", "verdict"]


def run_once(tree, name, folder):
    """The measured rows of one run of a benchmark."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    with open(folder / "run.log", "wb") as log:
        try:
            code = subprocess.run([str(tree.program(name)), str(folder)], cwd=tree.root, stdout=log,
                                  stderr=log, check=False).returncode
        except OSError as error:
            raise Fault(f"{name}: {error}") from None
    if code != 0:
        raise Fault(f"{name} of {tree.revision} ended with exit code {code}; see {folder}/run.log")
    return rows_of(read_table(folder / "result.csv", labelled=True))


def peers_of(tree, name):
    """The rows of other libraries, as a map from their row to our row."""
    path = tree.root / "experiments/benchmarks" / name / "params.json"
    try:
        return json.loads(path.read_text(encoding="utf-8")).get("peers", {})
    except (OSError, ValueError):
        return {}


def circumstances(root):
    """The columns of MACHINE."""
    described = machine.describe(root)
    return [" ".join(map(str, described[key])) if isinstance(described[key], list) else described[key]
            for key in MACHINE]


def write_csv(path, head, rows):
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerows([head, *rows])
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, text.getvalue().encode())


def measure(tree, names, runs, say):
    """Runs each benchmark `runs` times; the rows of results/bench.csv."""
    found = []
    facts = circumstances(tree.root)
    for name in names:
        peers = peers_of(tree, name)
        done = [run_once(tree, name, tree.root / "build/bench/runs" / name) for _ in range(runs)]
        for label, row in done[0].items():
            values = [run[label].value for run in done if label in run]
            ratios = [peer_ratio(run[label], run, peers) for run in done if label in run]
            known = [ratio for ratio in ratios if ratio is not None]
            found.append([tree.revision, *facts, name, label, row.unit, len(values),
                          statistics.median(values), round(spread_percent(values), 2),
                          statistics.median(known) if known else ""])
            say(f"  {name}: {label}: {found[-1][-3]:.6g} {row.unit}, spread {found[-1][-2]} %"
                + (f", {found[-1][-1]:.3g} times ours" if known else ""))
    return found


def pairs_of(old, new, name, pairs, say):
    """The rows of interleaved runs, as a list of (old, new). The order of the runs alternates."""
    found = []
    for number in range(pairs):
        order = (old, new) if number % 2 == 0 else (new, old)
        folder = new.root / "build/bench/runs"
        rows = {tree: run_once(tree, name, folder / f"{name}-{'old' if tree is old else 'new'}")
                for tree in order}
        found.append((rows[old], rows[new]))
        say(f"  {name}: pair {number + 1} of {pairs}")
    return found


def judged(name, found, peers):
    """Rows of the comparison of one benchmark: [name, row, unit, pairs, ..., verdict]."""
    first_old, first_new = found[0]
    rows = []
    for label, row in first_new.items():
        both = [(old[label], new[label]) for old, new in found if label in old and label in new]
        if not both:
            rows.append([name, label, row.unit, 0, "", row.value, "", "", "", "only new"])
            continue
        medians = [statistics.median(values) for values in zip(*((o.value, n.value) for o, n in both))]
        if not sense(row.unit) or label in peers or any(o.unit != n.unit for o, n in both):
            rows.append([name, label, row.unit, len(both), *medians, "", "", "", "not judged"])
            continue
        ratios = [slowdown(old, new) for old, new in both]
        middle = statistics.median(ratios)
        rows.append([name, label, row.unit, len(both), *medians, round(middle, 4),
                     round(min(ratios), 4), round(max(ratios), 4), verdict(middle)])
    rows += [[name, label, row.unit, 0, row.value, "", "", "", "", "only old"]
             for label, row in first_old.items() if label not in first_new]
    return rows


def compare(old, new, names, pairs, say):
    """Runs both trees in pairs; the rows of results/bench_compare.csv."""
    facts = [old.revision, new.revision, *circumstances(new.root)]
    found = []
    for name in names:
        rows = judged(name, pairs_of(old, new, name, pairs, say), peers_of(new, name))
        for row in rows:
            ratio = f"{row[6]:.3f} ({row[7]:.3f} to {row[8]:.3f})" if row[6] != "" else ""
            say(f"  {row[-1]:10} {ratio:24} {name}: {row[1]}")
        found += [facts + row for row in rows]
    return found


def busy():
    """A warning if other programs keep the machine busy, empty if none does."""
    load, cores = os.getloadavg()[0], len(os.sched_getaffinity(0))
    return f"warning: the load average is {load:.1f} on {cores} cores" if load > 0.5 * cores else ""
