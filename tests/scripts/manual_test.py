# SPDX-License-Identifier: GPL-3.0-or-later
"""Generates manual page and completion from the help texts of a shell script."""
import subprocess
import unittest

from fake_tree import FakeTree

import write_manual
from manual.helps import parse

HELPS = {
    "": """Plans paths.
Usage: endmill [OPTIONS] SUBCOMMAND

Options:
  -h,--help                   Print this help message and exit

Subcommands:
  plan                        plans a path
  eval                        evaluates a formula

Example:
  endmill plan a.json
""",
    "plan": """plans a path
Usage: endmill plan [OPTIONS] PART

Positionals:
  PART (required)             surface file

Options:
  -h,--help                   Print this help message and exit
  --order zigzag|one-way      sense of neighbouring passes; default zigzag
  --detection guarded|literal how folds are found; default guarded
  --cutter CUTTER             ball:DIAMETER in mm

Options of every command:
  -o,--output DIR             folder for the results

.Writes toolpath.csv with 1\\2.

Example:
  endmill plan a.json --cutter ball:15
""",
    "eval": "evaluates a formula\nUsage: endmill eval [SUBCOMMAND]\n\nSubcommands:\n"
            "  step                        a step\n",
    "eval step": "a step\nUsage: endmill eval step [OPTIONS]\n\nOptions:\n"
                 "  --radius MM (required)      radius\n",
}


class Parse(unittest.TestCase):
    def setUp(self):
        self.help = parse(["plan"], HELPS["plan"])

    def test_summary_usage_and_notes_are_parsed(self):
        self.assertEqual(self.help.summary, "plans a path")
        self.assertEqual(self.help.usage, "endmill plan [OPTIONS] PART")
        self.assertTrue(self.help.notes.startswith(".Writes"))
        self.assertTrue(self.help.notes.endswith("  endmill plan a.json --cutter ball:15"))

    def test_options_are_parsed_with_values_and_descriptions(self):
        found = {e.names[-1]: (e.names, e.value, e.text) for e in self.help.options}
        self.assertEqual(found["--order"],
                         (["--order"], "zigzag|one-way", "sense of neighbouring passes; default zigzag"))
        self.assertEqual(found["--detection"],
                         (["--detection"], "guarded|literal", "how folds are found; default guarded"))
        self.assertEqual(found["--output"], (["-o", "--output"], "DIR", "folder for the results"))
        self.assertEqual(found["--help"][1], "")


class Written(FakeTree):
    def setUp(self):
        super().setUp()
        cases = "".join(f'  "{words} --help"|"{words}--help") cat <<"TEXT"\n{text}TEXT\n  ;;\n'
                        for words, text in HELPS.items())
        program = self.write("endmill", f'#!/bin/sh\ncase "$*" in\n  --version) echo "endmill 0.1.0 (with endmill-mpi)" ;;\n'
                             f'{cases}  *) exit 2 ;;\nesac\n')
        program.chmod(0o755)
        self.assertEqual(write_manual.main(str(program), self.root / "made"), 0)

    def complete(self, *words):
        """The offers of the completion for the last of the words."""
        line = " ".join(f"'{word}'" for word in words)
        script = (f"source made/endmill\nCOMP_WORDS=({line}) COMP_CWORD={len(words) - 1}\n"
                  'compopt() { :; }\n_endmill\nprintf "%s\\n" "${COMPREPLY[@]}"\n')
        done = subprocess.run(["bash", "-c", script], cwd=self.root, capture_output=True, text=True,
                              check=True)
        return done.stdout.split()

    def test_completion_offers_commands_options_values_and_files(self):
        self.assertEqual(self.complete("endmill", ""), ["plan", "eval"])
        self.assertEqual(self.complete("endmill", "plan", "--or"), ["--order"])
        self.assertEqual(self.complete("endmill", "plan", "--order", ""), ["zigzag", "one-way"])
        self.assertEqual(self.complete("endmill", "plan", "ma"), ["made"])
        self.assertEqual(self.complete("endmill", "eval", ""), ["step"])
        self.assertEqual(self.complete("endmill", "eval", "step", "--"), ["--radius"])

    def test_page_has_every_command_and_escapes_requests_of_troff(self):
        page = (self.root / "made/endmill.1").read_text(encoding="utf-8")
        for command in ("plan", "eval", "eval step"):
            self.assertIn(f"\n.SS endmill {command}\n", page)
        self.assertIn("\n\\&.Writes toolpath.csv with 1\\e2.\n", page)
        self.assertIn("\\-\\-cutter CUTTER", page)
        self.assertEqual(page.count("\\-\\-output DIR"), 1)
        self.assertIn('.TH ENDMILL 1 "" "endmill 0.1.0"', page)

    def test_failing_program_is_reported(self):
        self.assertEqual(write_manual.main(str(self.root / "no_program"), self.root / "made"), 1)


if __name__ == "__main__":
    unittest.main()
