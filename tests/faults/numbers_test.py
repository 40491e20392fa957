# SPDX-License-Identifier: GPL-3.0-or-later
"""Every option of every command that writes, read from its help, gets extreme values. The program answers with
one of its exit codes, soon or with an estimate of the time left, and writes no number that is not finite. So do several
options with random values at once, from fixed seeds."""
import random
import unittest

from faults import (COMMANDS, EXTREMES, IS_LONG, STAGING, FaultTest, contents, environment, options_of, random_value,
                    timed_run, with_random_options)

VALUES_SHORT = 1  # for each option
SEVERAL = 18_100 if IS_LONG else 40  # runs with several options
SECONDS = 30


class ExtremeNumberTest(FaultTest):
    def check(self, name, *settings):
        said = " ".join((name, *settings))

        def act(folder):
            status, lines = timed_run([*self.command(name, folder), *settings], SECONDS, env=environment(),
                                      cwd=folder.parent)
            if status is None:
                self.assert_not_silent(said, SECONDS, lines)
                return
            self.assert_answered(said, status, lines, folder)
            self.assertEqual(list(folder.parent.rglob(STAGING + "*")), [], said)
            if status > 1:
                self.assertIsNone(contents(folder), said)
        self.in_new_place(act)

    def test_every_option(self):
        chance = random.Random(20)
        for name in COMMANDS:
            with self.subTest(name):
                options = options_of(COMMANDS[name][0])
                self.assertGreater(len(options), 2)
                self.in_parallel(self.check, [(name, f"{option}={value}") for option in options for value in
                                              (EXTREMES if IS_LONG else chance.sample(EXTREMES, VALUES_SHORT))])

    def test_several_options(self):
        self.in_parallel(self.check, [with_random_options(seed, (2, 4), random_value) for seed in range(SEVERAL)])


if __name__ == "__main__":
    unittest.main()
