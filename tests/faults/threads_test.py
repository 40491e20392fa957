# SPDX-License-Identifier: GPL-3.0-or-later
"""The bytes of every result are the same on one to eight threads, with the options of COMMANDS and with random ones."""
import subprocess
import unittest

from faults import COMMANDS, IS_LONG, FaultTest, difference, usual_value, with_random_options

RANDOM_CASES = 600 if IS_LONG else 8  # with seeds from 0 on
NUMBERS = range(2, 9) if IS_LONG else (2, 8)
SECONDS = 60
# Options that set the threads themselves, or make a run write the times that it took.
VARYING = ("--threads", "--repeat")


class ThreadsTest(FaultTest):
    def run_on(self, threads, name, *options):
        """The exit status, the error and the files of a run; None if it takes too long."""
        def act(folder):
            done = self.run_command(name, folder, f"--threads={threads}", *options, timeout=SECONDS)
            errors = [line for line in done.error.splitlines() if line.startswith("endmill: error: ")]
            return done.status, errors, done.files
        try:
            return self.in_new_place(act)
        except subprocess.TimeoutExpired:
            return None

    def check(self, name, *options):
        """Returns the number of runs if they write files, else 0."""
        options = [option for option in options if not option.startswith(VARYING)]
        expected = self.run_on(1, name, *options)
        if expected is None:  # a random option makes the work too long
            return 0
        for threads in NUMBERS:
            found = self.run_on(threads, name, *options)
            case = f"{name} {' '.join(options)} on {threads} threads"
            self.assertIsNotNone(found, f"{case}: more than {SECONDS} s, though one thread needs less")
            self.assertEqual(found[:2], expected[:2], case)
            self.assertEqual("", difference(found[2], expected[2]), case)
        return 1 + len(NUMBERS) if expected[2] else 0

    def test_bytes_do_not_depend_on_threads(self):
        cases = [(name,) for name in COMMANDS] + [with_random_options(seed, (1, 2), usual_value) for seed in range(RANDOM_CASES)]
        self.in_parallel(self.check, cases)


if __name__ == "__main__":
    unittest.main()
