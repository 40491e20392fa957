# SPDX-License-Identifier: GPL-3.0-or-later
"""Every option of every command that writes, read from its help, gets extreme values. The program answers with
one of its exit codes, soon or with an estimate of the time left, and writes no number that is not finite. So do several
options with random values at once, from fixed seeds."""
import random
import re
import subprocess
import unittest

from faults import COMMANDS, ENDMILL, IS_LONG, FaultTest, not_finite

EXTREMES = ("0", "-0", "-1", "1e-320", "1e-9", "0.5", "65536", "2147483648", "9223372036854775808", "1e19", "1e100",
            "1e308", "-1e308", "1e999", "nan", "inf", "1,2", "x", "")
VALUES_SHORT = 1  # for each option
SEVERAL = 18_100 if IS_LONG else 40  # runs with several options
SECONDS = 30
# An option with a value: at the beginning of a line of the help, with the name of the value in capitals.
OPTION = re.compile(r"^  (?:-\w,)?(--[\w-]+) [^ a-z]*[A-Z]", re.MULTILINE)


def options_of(command):
    said = subprocess.run([ENDMILL, command, "--help"], capture_output=True, text=True, check=True).stdout
    return sorted(set(OPTION.findall(said)) - {"--output"})


def random_value(chance):
    """An extreme value, or a number of any magnitude."""
    kind = chance.randrange(4)
    if kind == 0:
        return chance.choice(EXTREMES)
    number = 10 ** chance.uniform(-6, 6) if kind == 1 else 10 ** chance.uniform(-1, 2)
    return str(round(number)) if kind == 3 else f"{chance.choice((1, 1, 1, -1)) * number:.6g}"


class ExtremeNumberTest(FaultTest):
    def check(self, name, *settings):
        said = " ".join((name, *settings))

        def act(folder):
            try:
                done = self.run_command(name, folder, *settings, timeout=SECONDS)
            except subprocess.TimeoutExpired as stopped:
                told = (stopped.stderr or b"").decode(errors="replace")
                self.assertRegex(told, "about .+ left", f"{said}: longer than {SECONDS} s in silence")
                return
            case = f"{said}: exit {done.status}, {done.error[-300:]}"
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
                self.in_parallel(self.check, [(name, f"{option}={value}") for option in options for value in
                                              (EXTREMES if IS_LONG else chance.sample(EXTREMES, VALUES_SHORT))])

    def test_several_options(self):
        options = {name: options_of(words[0]) for name, words in COMMANDS.items()}

        def case(seed):
            chance = random.Random(seed)
            name = sorted(COMMANDS)[seed % len(COMMANDS)]
            chosen = chance.sample(options[name], min(len(options[name]), chance.randint(2, 4)))
            return name, *(f"{option}={random_value(chance)}" for option in chosen)
        self.in_parallel(self.check, [case(seed) for seed in range(SEVERAL)])


if __name__ == "__main__":
    unittest.main()
