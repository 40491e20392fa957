# SPDX-License-Identifier: GPL-3.0-or-later
"""Every option of every command that writes, read from its help, gets extreme values. The program answers with
one of its exit codes, soon or with an estimate of the time left, and writes no number that is not finite."""
import random
import re
import subprocess
import unittest

from faults import COMMANDS, ENDMILL, IS_LONG, FaultTest, not_finite

EXTREMES = ("0", "-0", "-1", "1e-320", "1e-9", "0.5", "65536", "2147483648", "9223372036854775808", "1e19", "1e100",
            "1e308", "-1e308", "1e999", "nan", "inf", "1,2", "x", "")
VALUES_SHORT = 1  # for each option
SECONDS = 30
# An option with a value: at the beginning of a line of the help, with the name of the value in capitals.
OPTION = re.compile(r"^  (?:-\w,)?(--[\w-]+) [^ a-z]*[A-Z]", re.MULTILINE)


def options_of(command):
    said = subprocess.run([ENDMILL, command, "--help"], capture_output=True, text=True, check=True).stdout
    return sorted(set(OPTION.findall(said)) - {"--output"})


class ExtremeNumberTest(FaultTest):
    def check(self, name, option, value):
        def act(folder):
            try:
                done = self.run_command(name, folder, f"{option}={value}", timeout=SECONDS)
            except subprocess.TimeoutExpired as stopped:
                told = (stopped.stderr or b"").decode(errors="replace")
                self.assertRegex(told, "about .+ left", f"{name} {option}={value}: longer than {SECONDS} s in silence")
                return
            case = f"{name} {option}={value}: exit {done.status}, {done.error[-300:]}"
            self.assertIn(done.status, range(7), case)
            if done.status > 1:
                self.assertRegex(done.error, "(?m)^endmill: error: ", case)
                self.assertIsNone(done.files, case)
            self.assertEqual((done.left, not_finite(done.files)), (0, []), case)
        self.in_new_place(act)

    def test_every_option(self):
        chance = random.Random(20)
        for name in COMMANDS:
            with self.subTest(name):
                options = options_of(COMMANDS[name][0])
                self.assertGreater(len(options), 2)
                self.in_parallel(self.check, [(name, option, value) for option in options for value in
                                              (EXTREMES if IS_LONG else chance.sample(EXTREMES, VALUES_SHORT))])


if __name__ == "__main__":
    unittest.main()
