#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tests of faults in their long form and writes their counts to docs/faults.md.

    scripts/write_fault_counts.py            runs all tests, an hour or two, and writes the page
    scripts/write_fault_counts.py --check    exits with 1 if the page omits a test or lists an unknown one

Uses the program and the library of failing calls in build/release, which scripts/test.sh builds. Exit 1 if a test
fails; the page then stays as it is.
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = "docs/faults.md"
TEST = re.compile(r"^    def (test_\w+)\(self\):$", re.M)
INTRODUCTION = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by scripts/write_fault_counts.py from the runs of tests/faults. -->
# Faults

The tests in `tests/faults` make system calls fail, or give the program files and numbers with faults. Each run must end
with one of the [exit codes](conventions.md) within the time limit of its test, or state the time left; an error names the
fault. The result folder is then old or new as a whole, and contains only finite numbers. The runs are those of the long
form, `scripts/test.sh --all`; all pass. Runs in which no fault occurs, because the program does not make that call, are
not counted. Random faults and values come from the seeds 0, 1, 2 and so on, one for each run.

| fault | what is tried | runs |
| --- | --- | --- |
"""
# What each test tries.
TRIALS = {
    "test_a_failing_call_leaves_the_old_or_the_new_folder":
        ("a system call fails", "the n-th of each of eleven calls, up to n = 300, alone or with all later ones, by four "
                                "errors, in every command that writes, over the results of an earlier run"),
    "test_a_failing_call_leaves_no_half_of_a_new_folder": ("a system call fails", "the same in a new folder"),
    "test_a_kill_leaves_a_folder_that_the_next_run_mends":
        ("the process is killed", "at the n-th call, most of them between renames; the next run repairs the folder"),
    "test_two_kills_leave_the_old_or_the_new_folder":
        ("the process is killed", "at the n-th rename; then the next run, which repairs the folder, at one of five calls; a "
                                  "third run repairs it"),
    "test_a_kill_leaves_an_empty_folder_empty": ("the process is killed", "at the n-th rename, in an empty folder"),
    "test_a_killed_run_can_be_repeated_without_force": ("the process is killed", "in a new folder"),
    "test_an_interrupt_leaves_the_old_or_the_new_folder":
        ("the process is interrupted", "by SIGTERM during the n-th mkdir, rename or open, over earlier results and in a "
                                       "new folder; no hidden folder stays"),
    "test_the_next_run_mends_what_a_failing_call_left":
        ("a system call fails", "up to four of the calls of each of nine kinds, alone or with all later ones, by four errors, in "
                                "`run` and `sweep`; the next run goes on to the results of a run without faults"),
    "test_the_next_run_mends_what_a_kill_left":
        ("the process is killed", "at up to eight of the calls of each of seven kinds, in `run` and `sweep`; the next run goes on"),
    "test_bytes_do_not_depend_on_threads":
        ("threads", "one to eight threads, in every command that writes and with random values for one or two options; all "
                    "write the same bytes"),
    "test_threads": ("no threads", "none at all, from the n-th on, or not the n-th"),
    "test_memory": ("no memory", "the n-th allocation fails, or all from then on"),
    "test_a_small_address_space": ("no memory", "40 to 200 MB of address space"),
    "test_every_option": ("extreme numbers", "19 values for every option with a value, taken from each `--help`"),
    "test_several_options": ("extreme numbers", "random values for two to four options at once"),
    "test_mutants": ("faulty files", "1 to 3 random faults in a file, 16 kinds of files; limits of 30 s and 4 GB"),
}


def tests(root):
    """The files of the tests, and the names of all tests."""
    files = sorted((root / "tests/faults").glob("*_test.py"))
    return files, [name for file in files for name in TEST.findall(file.read_text(encoding="utf-8"))]


def counts(root):
    """The number of runs of each test. Exits with 1 if one fails."""
    build = root / "build/release"
    with tempfile.TemporaryDirectory() as folder:
        runs = Path(folder) / "runs"
        settings = {**os.environ, "ENDMILL": str(build / "src/cli/endmill"), "ENDMILL_FAULTS": "long",
                    "ENDMILL_FAILING_CALLS": str(build / "tests/libendmill_failing_calls.so"),
                    "ENDMILL_FAULT_RUNS": str(runs)}
        for file in tests(root)[0]:
            print(file.name, flush=True)
            if subprocess.run([sys.executable, file], env=settings, check=False).returncode != 0:
                sys.exit(1)
        return {name: int(count) for name, count in map(str.split, runs.read_text(encoding="utf-8").splitlines())}


def page(count_of):
    """The page with these numbers of runs by test."""
    rows = [f"| {fault} | {trial} | {count_of[name]} |\n" for name, (fault, trial) in TRIALS.items()]
    return INTRODUCTION + "".join(rows)


def main(root, check):
    names = tests(root)[1]
    if sorted(names) != sorted(TRIALS):
        print(f"TRIALS lacks or has too many: {', '.join(sorted({*names} ^ {*TRIALS}))}")
        return True
    file = root / PAGE
    if not check:
        file.write_text(page(counts(root)), encoding="utf-8")
        return False
    rows = re.findall(r"\| (\d+) \|$", file.read_text(encoding="utf-8"), re.M) if file.exists() else []
    stale = len(rows) != len(TRIALS) or file.read_text(encoding="utf-8") != page(dict(zip(TRIALS, rows)))
    print(f"{PAGE} is stale: run scripts/write_fault_counts.py" if stale else f"{PAGE} names every test")
    return stale


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(f"usage: {sys.argv[0]} [--check]\n\n{__doc__}")
    sys.exit(main(ROOT, "--check" in sys.argv))
