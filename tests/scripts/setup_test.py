# SPDX-License-Identifier: GPL-3.0-or-later
"""setup.sh lists groups of packages, and with --no-install looks for their contents."""
import re
import shutil
import subprocess
import unittest

from fake_tree import ROOT, FakeTree

GROUPS = ["build", "mpi", "python", "page", "cad", "figures", "benchmarks", "tests", "sanitizers", "docs", "paper", "packaging"]


class Setup(FakeTree):
    def setup_with(self, packages, *arguments):
        """Runs setup.sh with another packages.txt."""
        self.write("scripts/packages.txt", packages)
        shutil.copy(ROOT / "scripts/setup.sh", self.root / "scripts/setup.sh")
        return subprocess.run([self.root / "scripts/setup.sh", *arguments], capture_output=True,
                              text=True, check=False, stdin=subprocess.DEVNULL)

    def test_groups_are_those_of_the_help(self):
        text = (ROOT / "scripts/packages.txt").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"^\[(.+)\]$", text, re.MULTILINE), GROUPS)
        helped = subprocess.run([ROOT / "scripts/setup.sh", "--help"], capture_output=True, text=True,
                                check=True).stdout
        for group in GROUPS:
            self.assertRegex(helped, rf"(?m)^  {group} ")

    def test_every_package_has_a_test_and_a_reason(self):
        for line in (ROOT / "scripts/packages.txt").read_text(encoding="utf-8").splitlines():
            if line and line[0] not in "#[":
                package, test, reason = (part.strip() for part in line.split("|"))
                self.assertTrue(package and reason, line)
                self.assertRegex(test, r"^(program|cmake|library|python|header|sanitizer|tex) \S")

    def test_list_prints_the_packages_of_the_groups(self):
        packages = "[a]\none | program sh | x\n[b]\ntwo | program sh | x\nthree | program sh | x\n"
        self.assertEqual(self.setup_with(packages, "--list", "b").stdout.split(), ["two", "three"])
        self.assertEqual(self.setup_with(packages, "--list").stdout.split(), ["one", "two", "three"])

    def test_no_install_accepts_contents_from_any_source(self):
        packages = ("[a]\nno-such-package | program sh | a shell\nother | header vector | a header\n"
                    "third | python json | a module\nfourth | program no-such-program sh | either\n"
                    "fifth | cmake Threads | threads\nsixth | library m | mathematics\n")
        done = self.setup_with(packages, "--no-install", "a")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_no_install_lists_everything_that_is_missing(self):
        packages = ("[a]\none | program no-such-program | first reason\n"
                    "two | cmake NoSuchPackage 3 | second reason\nthree | library no-such-library | third\n"
                    "four | header no/such_header.h | fourth\nfive | python no_such_module | fifth\n"
                    "six | program sh | there\nseven | tex no-such-file.sty | seventh\n")
        done = self.setup_with(packages, "--no-install", "a")
        self.assertEqual(done.returncode, 1)
        for package in ("one", "two", "three", "four", "five", "seven"):
            self.assertIn(f"(Debian package {package})", done.stderr)
        self.assertNotIn("Debian package six", done.stderr)
        self.assertIn("6 of 7 requirements are missing", done.stderr)

    def test_unknown_group_or_option_is_refused(self):
        for argument in ("nonsense", "--nonsense"):
            done = self.setup_with("[a]\none | program sh | x\n", argument)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(argument, done.stderr)


class Scripts(unittest.TestCase):
    def test_scripts_have_a_help_with_an_example_and_refuse_unknown_options(self):
        for name in ("setup", "reproduce", "test", "fuzz", "docs", "bench", "paper"):
            script = ROOT / f"scripts/{name}.sh"
            helped = subprocess.run([script, "--help"], capture_output=True, text=True, check=False)
            self.assertEqual(helped.returncode, 0, name)
            self.assertIn(f"Example: scripts/{name}.sh", helped.stdout)
            wrong = subprocess.run([script, "--nonsense"], capture_output=True, text=True, check=False)
            self.assertEqual(wrong.returncode, 2, name)
            self.assertIn(f"{name}.sh: unknown", wrong.stdout + wrong.stderr)


if __name__ == "__main__":
    unittest.main()
