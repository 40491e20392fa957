# SPDX-License-Identifier: GPL-3.0-or-later
"""Medians and ratios over revisions: each run of scripts/bench.sh is kept, and drawn with those before."""
import csv
from datetime import datetime, timezone
from pathlib import Path

from .measure import RUN_HEAD, write_csv

KEPT_HEAD = ["date", *RUN_HEAD]
LEAST_RUNS = 2  # of a row, for a curve


def kept(path):
    """The rows of earlier runs as dicts, oldest first; none without the file or with another head."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            lines = csv.DictReader(file)
            return list(lines) if lines.fieldnames == KEPT_HEAD else []
    except OSError:
        return []


def keep(path, rows, date=None):
    """Adds the rows of a run, in the order of RUN_HEAD, to those of earlier ones. Returns all."""
    date = date or datetime.now(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    old = kept(path)
    new = [dict(zip(KEPT_HEAD, [date, *map(str, row)])) for row in rows]
    write_csv(path, KEPT_HEAD, [[row[name] for name in KEPT_HEAD] for row in old + new])
    return old + new


def series(rows, column):
    """For each benchmark and row with its unit the values of a column over the runs: {name: [(run, value)]}.

    Runs are counted over all rows, so that curves of one picture share their axis.
    """
    runs = list(dict.fromkeys((row["date"], row["revision"]) for row in rows))
    found = {}
    for row in rows:
        if row[column]:
            name = row["benchmark"], f"{row['row']}, {row['unit']}"
            found.setdefault(name, []).append((runs.index((row["date"], row["revision"])), float(row[column])))
    return runs, {name: values for name, values in found.items() if len(values) >= LEAST_RUNS}


def draw(folder, rows):
    """Writes bench-BENCHMARK.svg for each benchmark with two runs or more. Returns the names of the files."""
    from reproduction.figures import STYLE  # Matplotlib takes a second
    import matplotlib.pyplot as plt

    written = []
    runs, medians = series(rows, "median")
    _, ratios = series(rows, "ratio_to_peer")
    for benchmark in sorted({name for name, _ in medians}):
        with plt.rc_context(STYLE):
            both = [("median", medians), ("ratio to the library compared with", ratios)]
            shown = [(title, {row: values for (one, row), values in found.items() if one == benchmark})
                     for title, found in both]
            shown = [(title, curves) for title, curves in shown if curves]
            figure, axes = plt.subplots(len(shown), squeeze=False, figsize=(9, 4.5 * len(shown)))
            for place, (title, curves) in zip(axes[:, 0], shown):
                for row, values in curves.items():
                    place.plot(*zip(*values), marker="o", label=row)
                place.set_yscale("log")
                place.set_ylabel(title)
                place.set_xticks(range(len(runs)), [f"{revision[:8]}\n{date[:10]}" for date, revision in runs], fontsize=8)
                place.legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
            axes[0, 0].set_title(benchmark)
            name = f"bench-{benchmark}.svg"
            figure.savefig(Path(folder) / name, bbox_inches="tight", metadata={"Date": None})
            plt.close(figure)
            written.append(name)
    return written
