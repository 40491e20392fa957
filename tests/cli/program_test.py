# SPDX-License-Identifier: GPL-3.0-or-later
"""The program as a whole: help, version, cite."""
import json
import unittest

from program import ROOT, ProgramTest, endmill

COMMANDS = ("info", "sample", "plan", "trim", "verify", "post", "feed", "coefficients", "toollife", "setup", "machine",
            "eval", "cite")


def calls_of_readme(command):
    """The words of README's first call of a command, from its name on."""
    text = (ROOT / "README.md").read_text(encoding="utf-8").replace("\\\n", " ")
    return next(line for line in text.splitlines() if f"cli/endmill {command} " in line).split()[1:]


class Program(ProgramTest):
    def test_every_command_has_help_with_an_example(self):
        for command in COMMANDS:
            done = endmill(command, "--help")
            self.assertEqual(done.returncode, 0)
            self.assertIn(f"endmill {command}", done.stdout.split("Example:")[1])
            self.assertIn("--json-errors", done.stdout)

    def test_every_command_is_told_of(self):
        known = endmill("--help").stdout.split("Subcommands:\n")[1].split("\n\n")[0]
        self.assertEqual(tuple(line.split()[0] for line in known.splitlines() if line[2] != " "), COMMANDS)
        change = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8").split("The program `endmill` with")[1].split("\n- ")[0]
        table = (ROOT / "README.md").read_text(encoding="utf-8")
        for command in COMMANDS:
            self.assertIn(f"`{command}`", change)
            self.assertIn(f"\n| `{command}` |", table)

    def test_an_empty_text_is_no_option_left_out(self):
        points = self.file("azimuth_deg,polar_deg\n0,10\n", "p.csv")
        for call in (("machine", "W/caxyBz/T", "--limits", ""), ("machine", "W/caxyBz/T", "--at", ""),
                     ("machine", "W/caxyBz/T", "-o", ""), ("setup", "x.off", "--family", "CA", "--from-visibility", ""),
                     ("setup", "--points", points, "--family", "CA", "--limits", ""), ("plan", "x.json", "--output", ""),
                     ("eval", "path-interval", "--radius", "5", "--curvature", "0", "--scallop", "1", "-o", "")):
            option = "--output" if call[-2] == "-o" else call[-2]
            self.assert_refused(endmill(*call, cwd=self.folder), 2, f'{option}: found ""')
        self.assert_nothing_left("p.csv")

    def test_examples_of_milling_do_what_they_promise(self):
        (self.folder / "datasets").symlink_to(ROOT / "datasets")
        for command in ("feed", "coefficients", "toollife", "machine"):
            lines = endmill(command, "--help").stdout.split("Example:\n")[1].splitlines()
            calls = "".join("\n" * line.startswith("  endmill ") + line for line in lines).split("\n")[1:]
            self.assertGreaterEqual(len(calls), 1)
            for call in calls:
                done = endmill(*call.split()[1:], cwd=self.folder)
                self.assertEqual(done.returncode, 0, (call, done.stderr))
        facts = json.loads((self.folder / "results/feed/summary.json").read_text())
        self.assertEqual(facts["infeasible"], 0)
        self.assertGreater(facts["saving_percent"], 50)
        self.assertGreater(facts["limits"]["cutting_force"], 0.1)
        # README shows the same call.
        options = calls_of_readme("feed")[2:-2]
        self.assertIn(" ".join(options), " ".join(endmill("feed", "--help").stdout.split()))

    def test_version(self):
        self.assertRegex(endmill("--version").stdout, r"^endmill \d+\.\d+\.\d+\n$")

    def test_unknown_command_gets_a_suggestion(self):
        self.assert_refused(endmill("plam"), 2, 'found "plam"', "did you mean plan?")
        self.assert_refused(endmill(), 2, "subcommand is required", "endmill --help")

    def test_formula_without_eval_is_an_unknown_command(self):
        for arguments in ([], ["--help"], ["--radius", "5", "--curvature", "0", "--scallop", "1"]):
            self.assert_refused(endmill("path-interval", *arguments), 2, '"path-interval", which endmill does not know',
                                "did you mean endmill eval path-interval?")
        self.assert_refused(endmill("step-lenth"), 2, "did you mean endmill eval step-length?")

    def test_help_does_not_make_a_word_known(self):
        self.assert_refused(endmill("plam", "--help"), 2, '"plam"', "did you mean plan?")
        self.assert_refused(endmill("xyz", "--help"), 2, '"xyz"', "see endmill --help")
        self.assert_refused(endmill("eval", "path-intervall", "--help"), 2, '"path-intervall"', "path-interval?")
        for arguments in ([], ["eval"], ["eval", "path-interval"], ["eval", "--radius", "5"], ["plan", "--scalop"]):
            done = endmill(*arguments, "--help")
            self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
            self.assertIn("Example:", done.stdout)

    def test_cite_prints_the_bibliography(self):
        done = endmill("cite", "--bibtex")
        self.assertEqual(done.stdout, (ROOT / "paper/references.bib").read_text(encoding="utf-8"))
        keys = [paper["key"] for paper in self.summary("cite")["papers"]]
        self.assertEqual(keys, ["KimChoi", "JangKimJeong", "KangSuh", "ParkMaeng"])
        for paper in self.summary("cite")["papers"]:
            self.assertGreater(len(paper["title"]), 20)
            self.assertNotIn("=", paper["title"])

    def test_quiet_prints_nothing(self):
        done = endmill("info", ROOT / "datasets/surfaces/plane.json", "--quiet")
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("", "", 0))


if __name__ == "__main__":
    unittest.main()
