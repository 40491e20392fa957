# SPDX-License-Identifier: GPL-3.0-or-later
"""Overhead of sweeps, jobs and ranks, with the bars.

  PYTHONPATH=scripts python3 experiments/benchmarks/sweep/main.py OUTPUT_FOLDER

About three minutes; measures time, so nothing else should run. Columns: README.md beside this.
"""
import csv
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

from studies.study import PROGRAM, write_csv

FOLDER = Path(__file__).parent
PARAMETERS = json.loads((FOLDER / "params.json").read_text(encoding="utf-8"))["parameters"]
OUTPUT = Path(sys.argv[1])
DATASETS = Path("datasets").resolve()
MPIRUN = ["mpirun", "--oversubscribe", "--allow-run-as-root"]
HAS_MPI = shutil.which("mpirun") and Path(PROGRAM).with_name("endmill-mpi").is_file()
SHORT = {"command": "coefficients",
         "options": {"material": str(DATASETS / "materials/steel.json"), "cutter": "ball:10", "flutes": 2,
                     "pick_feed_ratio": 0.3, "lambda_deg": 0, "mu_deg": 0, "depth_ratio": 0.5}}
LONG = {"command": "plan", "input": str(DATASETS / "surfaces/saddle.json"),
        "options": {"cutter": "ball:10", "strategy": "iso"}}


def run(*words, ranks=1):
    """Runs the program on one thread for each rank. Returns the wall time in s and the standard output."""
    launch = [*MPIRUN, "-n", str(ranks)] if ranks > 1 else []
    begin = time.monotonic()
    done = subprocess.run([*launch, PROGRAM, *map(str, words), "--quiet"], check=True, capture_output=True, text=True)
    return time.monotonic() - begin, done.stdout


def plan_of(case, name, parameter, low, high, count):
    """Writes the plan of a sweep that draws one parameter."""
    drawn = {"count": count, "seed": 1, "parameters": {parameter: {"from": low, "to": high}}}
    path = OUTPUT / f"{name}.json"
    path.write_text(json.dumps({"format": "endmill-sweep/1", **case, "random": drawn}), encoding="utf-8")
    return path


def sweep(plan, ranks=1):
    """The wall time of a sweep in s, one case at a time on each rank, and the sum of the times of its cases."""
    shutil.rmtree(OUTPUT / "sweep", ignore_errors=True)
    seconds, _ = run("sweep", plan, "--jobs", 1, "--threads", 1, "-o", OUTPUT / "sweep", ranks=ranks)
    with open(OUTPUT / "sweep/results.csv", encoding="utf-8", newline="") as file:
        return seconds, sum(float(row["wall_s"]) for row in csv.DictReader(file))


def overhead_of_a_case():
    """Time of a sweep beyond the processes of its cases, in ms for a case."""
    count = PARAMETERS["short_cases"]
    seconds, of_cases = sweep(plan_of(SHORT, "short", "feed_per_tooth", 0.01, 0.2, count))
    return 1e3 * (seconds - of_cases) / count


def sweep_on_ranks(ranks):
    return sweep(plan_of(LONG, "long", "scallop", 0.1, 0.4, PARAMETERS["long_cases"]), ranks)[0]


def visibility_on_ranks(ranks):
    side = round((PARAMETERS["facets"] / 2)**0.5) + 1
    mesh = OUTPUT / "mesh/mesh.off"
    if not mesh.exists():
        run("sample", DATASETS / "surfaces/wavy.json", "--grid", side, "--format", "off", "-o", OUTPUT / "mesh")
    _, summary = run("setup", mesh, "--machine", "W/xyBz/T", "--sphere", PARAMETERS["sphere"], "--threads", 1, "--json",
                     "--force", "-o", OUTPUT / "setup", ranks=ranks)
    return json.loads(summary)["visibility_s"]


def two_ranks_by_one(seconds_on):
    """The least time on two ranks divided by that on one, of interleaved runs; empty without MPI."""
    if not HAS_MPI or os.cpu_count() < 2:
        print("two ranks: not measured without mpirun, endmill-mpi and two cores", file=sys.stderr)
        return ""
    times = [(seconds_on(1), seconds_on(2)) for _ in range(PARAMETERS["runs"])]
    return min(two for _, two in times) / min(one for one, _ in times)


def job_that_is_up_to_date():
    words = ("run", DATASETS / "jobs/economic-cl-data.json", "-o", OUTPUT / "job")
    run(*words)
    return min(run(*words)[0] for _ in range(PARAMETERS["runs"]))


write_csv(OUTPUT / "result.csv", ["row", "measured", "unit", "bar_at_most"],
          [["overhead of a case of a sweep", overhead_of_a_case(), "ms", 10],
           ["run of a job that is up to date", job_that_is_up_to_date(), "s", 0.2],
           ["sweep, two ranks by one", two_ranks_by_one(sweep_on_ranks), "times", 0.55],
           ["visibility, two ranks by one", two_ranks_by_one(visibility_on_ranks), "times", 0.55]])
