# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls of the system fail, or the process is killed at one, in the commands that go on where they were: after one more
run their results are those of a run without faults."""
import signal
import subprocess
import unittest
from pathlib import Path

from faults import ENDMILL, FAILURES, IS_LONG, FaultTest, calls, contents, difference, environment

JOB = Path(__file__).with_name("small-job.json")
# Commands that are run again, and what their second run gets besides. FOLDER is the output folder.
RESUMED = {"run": (["run", JOB, "-o", "FOLDER"], []),
           "sweep": (["sweep", JOB.with_name("small-sweep.json"), "-o", "FOLDER"], ["--resume"])}
# A case that fails is a row of the results, and is not repeated.
ALONE = ("sweep",)
CALLS = ("open", "mkdir", "rename", "unlink", "write", "read", "fsync", "flock", "opendir")
# Without these a process cannot remove its staging folder. The next run that writes does.
REMOVING = ("open", "unlink", "opendir")
KILLS = ("open", "mkdir", "rename", "unlink", "write", "fsync", "flock")


def spread(count, short, long):
    """Numbers from 1 to `count`, evenly spread: `long` of them in the long form, else `short`."""
    most = min(count, long if IS_LONG else short)
    return sorted({1 + round(k * (count - 1) / max(most - 1, 1)) for k in range(most)})


def comparable(name, content):
    """A run that goes on after its end finds its steps up to date. The last column of results.csv has times."""
    if name == "results.csv":
        return b"\n".join(line.rpartition(b",")[0] for line in content.splitlines())
    return content.replace(b'"up to date"', b'"done"')


def without_states(files):
    """The files without what a second run changes."""
    return files and {name: comparable(name, content) for name, content in files.items()}


class Resumed(FaultTest):
    def do(self, name, folder, *options, fault=None):
        """The exit status and the error text of a run, and whether the fault occurred in its own process."""
        counts = folder.parent / "counts"
        counts.unlink(missing_ok=True)
        words = [folder.name if word == "FOLDER" else word for word in RESUMED[name][0]]
        done = subprocess.run([str(word) for word in (ENDMILL, *words, *options)], capture_output=True, check=False,
                              stdin=subprocess.DEVNULL, timeout=120, cwd=folder.parent, env=environment(fault, counts, name in ALONE))
        return done.returncode, done.stderr.decode(errors="replace"), calls(counts)

    def whole(self, name):
        def act(folder):
            status, error, counts = self.do(name, folder)
            self.assertEqual(status, 0, error)
            return without_states(contents(folder)), counts
        return self.in_new_place(act)

    def check(self, name, fault, whole):
        def act(folder):
            status, error, _ = self.do(name, folder, fault=fault)
            case = f"{name}, {fault}: exit {status}, {error}"
            self.assertIn(status, (0, 1, 2, 3, 5, 6, -signal.SIGKILL, 128 + signal.SIGKILL), case)
            again, error, _ = self.do(name, folder, *RESUMED[name][1])
            self.assertEqual(again, 0, f"{case}; then exit {again}, {error}")
            self.assertEqual("", difference(without_states(contents(folder)), whole), case)
            left = [path for path in folder.parent.rglob(".endmill-*")]
            if fault.endswith(":kill") or not fault.startswith(REMOVING):
                self.assertEqual(left, [], case)
            return status != 0
        return self.in_new_place(act)

    def check_all(self, faults):
        for name in RESUMED:
            with self.subTest(name):
                whole, counts = self.whole(name)
                self.in_parallel(self.check, [(name, fault, whole) for fault in faults(counts)])

    def test_the_next_run_mends_what_a_failing_call_left(self):
        self.check_all(lambda counts: [f"{call}:{number}{later}:{error}" for call in CALLS
                                       for number in spread(counts.get(call, 0), 3, 4) for error, later in FAILURES])

    def test_the_next_run_mends_what_a_kill_left(self):
        self.check_all(lambda counts: [f"{call}:{number}:kill" for call in KILLS
                                       for number in spread(counts.get(call, 0), 4, 8)])


if __name__ == "__main__":
    unittest.main()
