# SPDX-License-Identifier: GPL-3.0-or-later
"""The program as a whole: help, version, unknown words, cite."""
import re
import unittest
from pathlib import Path

from program import ENDMILL, ROOT, ProgramTest, endmill, plane

COMMANDS = ("info", "import", "sample", "plan", "trim", "verify", "post", "feed", "coefficients", "toollife", "setup", "machine",
            "eval", "cite", "run", "demo", "sweep", "view")


class Program(ProgramTest):
    def test_every_command_has_help_with_an_example(self):
        for command in COMMANDS:
            done = endmill(command, "--help")
            self.assertEqual(done.returncode, 0)
            self.assertIn(f"endmill {command}", done.stdout.split("Example:")[1])
            self.assertIn("--json-errors", done.stdout)

    def test_every_command_is_documented(self):
        known = endmill("--help").stdout.split("Subcommands:\n")[1].split("\n\n")[0]
        self.assertEqual(tuple(line.split()[0] for line in known.splitlines() if line[2] != " "), COMMANDS)
        change = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8").split("The program `endmill` with")[1].split("\n- ")[0]
        table = (ROOT / "docs/README.md").read_text(encoding="utf-8")
        for command in COMMANDS:
            self.assertIn(f"`{command}`", change)
            self.assertIn(f"\n| `{command}` |", table)

    def test_empty_text_is_refused(self):
        points = self.file("azimuth_deg,polar_deg\n0,10\n", "p.csv")
        for call in (("machine", "W/caxyBz/T", "--limits", ""), ("machine", "W/caxyBz/T", "--at", ""),
                     ("machine", "W/caxyBz/T", "-o", ""), ("setup", "x.off", "--family", "CA", "--from-visibility", ""),
                     ("setup", "--points", points, "--family", "CA", "--limits", ""), ("plan", "x.json", "--output", ""),
                     ("eval", "path-interval", "--radius", "5", "--curvature", "0", "--scallop", "1", "-o", "")):
            option = "--output" if call[-2] == "-o" else call[-2]
            self.assert_refused(endmill(*call, cwd=self.folder), 2, f'{option}: found ""')
        self.assert_nothing_left("p.csv")

    def test_help_begins_with_a_verb_and_states_defaults_uniformly(self):
        for command in COMMANDS:
            text = endmill(command, "--help").stdout
            self.assertRegex(text.splitlines()[0], r"^[a-z]+ ")
            self.assertNotRegex(text, r"; default")

    def test_description_of_an_option_stands_apart_from_its_name(self):
        for command in COMMANDS:
            lines = endmill(command, "--help").stdout.splitlines()
            column = next(line.index("Print this help") for line in lines if line.startswith("  -h,--help"))
            for name, after in zip(lines, lines[1:]):
                if re.match("  -", name):
                    gap = name[column - 2:column] == "  " and len(name) > column
                    alone = len(name) > column - 2 and after.startswith(" " * column) and after[column] != " "
                    self.assertTrue(gap or alone, (command, name))

    def test_options_without_effect_are_refused(self):
        surface = self.file(plane())
        mesh = ROOT / "datasets/meshes/dome.stl"
        curves = self.file("s_mm,z_mm\n0,0\n1,1\n2,0\n", "curves.csv")
        path = self.file("tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0\n10,0,0\n", "path.csv")
        ball = ("--cutter", "ball:5")
        feed = ("feed", path, *ball, "--flutes", "2", "--stock-top", "1", "--material",
                ROOT / "datasets/materials/steel.json")
        for call, option, expected in (
                (("info", mesh, "--axis", "0,0,1"), "--axis", "a surface"),
                (("info", mesh, "--require", "g1"), "--require", "a surface"),
                (("trim", surface, *ball, "--detection", "guarded"), "--detection", "--method 1, 2, 3 or all"),
                (("trim", surface, *ball, "--m1-step", "1"), "--m1-step", "--method 1 or all"),
                (("trim", surface, *ball, "--m1-threshold", "1", "--method", "2"), "--m1-threshold", "--method 1 or all"),
                (("trim", surface, *ball, "--m3", "scan"), "--m3", "--method 3 or all"),
                (("trim", mesh, *ball, "--m3", "scan", "--method", "all"), "--m3", "a surface"),
                (("trim", "--polyline", curves, "--tolerance", "1"), "--tolerance", "--method all"),
                (("verify", path, *ball, "--scallop", "1"), "--scallop", "--part"),
                (("verify", path, *ball, "--tolerance", "1"), "--tolerance", "--part"),
                (("verify", path, *ball, "--max-refine", "1"), "--max-refine", "--part"),
                (("verify", path, *ball, "--units", "inch"), "--units", "--part or --stock"),
                (("verify", path, *ball, "--block-delete"), "--block-delete", "expects G-code"),
                (("post", path, *ball, "--feed", "1", "--format", "apt", "--comments", "yes"), "--comments", "gcode"),
                ((*feed, "--corner-tolerance", "1"), "--corner-tolerance", "--mode planned"),
                ((*feed, "--corner-tolerance", "1", "--mode", "corrected"), "--corner-tolerance", "--mode planned"),
                ((*feed, "--accuracy", "1e-6", "--coefficients", "table"), "--accuracy", "--coefficients direct"),
                ((*feed, "--resolution", "1"), "--resolution", "--engagement stock"),
                ((*feed, "--up", "z"), "--up", "--part or --stock"),
                (("setup", mesh, "--family", "CA", "--gap", "0.1"), "--gap", "--mode set"),
                (("cite", "--bibtex", "--json"), "--bibtex", "one of the two")):
            self.assert_refused(endmill(*call, cwd=self.folder), 2, option, expected)
        self.assert_nothing_left("curves.csv", "path.csv", "surface.json")

    def test_limit_of_the_ball_is_exclusive(self):
        cylinder = ROOT / "datasets/surfaces/parabolic-cylinder.json"
        self.assertIn("radius below 20 mm", endmill("info", cylinder).stdout)
        limit = "found radius 20 mm; expected a smaller radius than the limit of the surface, 20 mm"
        self.assert_refused(endmill("plan", cylinder, "--cutter", "ball:40", cwd=self.folder), 4, limit)
        done = endmill("plan", cylinder, "--cutter", "ball:39.99", "--chord-tolerance", "0.5", "--direction", "v",
                       cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)

    def test_unknown_columns_are_refused_with_the_known_names(self):
        header = self.file("x,y,z\n0,0,0\n1,1,1\n", "p.csv")
        for call, names in ((("verify", header), ("tip_x_mm, tip_y_mm and tip_z_mm", "feed_mm_per_min")),
                            (("post", header), ("tip_x_mm, tip_y_mm and tip_z_mm", "spindle_rpm")),
                            (("trim", "--polyline", header), ("s_mm", "z_mm", "curve")),
                            (("setup", "--points", header, "--family", "CA"), ("azimuth_deg", "polar_deg")),
                            (("toollife", header, "--tool-change-min", "1", "--tool-cost", "1",
                              "--machine-cost-per-min", "1"), ("phi_over_pi", "v_m_per_min"))):
            self.assert_refused(endmill(*call, cwd=self.folder), 3, "p.csv:1: unknown column", *names)

    def test_version_is_printed_with_the_programs_that_are_there(self):
        others = ", ".join(f"{'with' if Path(ENDMILL).with_name(name).exists() else 'without'} {name}"
                           for name in ("endmill-mpi", "endmill-cad"))
        self.assertRegex(endmill("--version").stdout, rf"^endmill \d+\.\d+\.\d+ \({others}\)\n$")

    def test_unknown_command_gets_a_suggestion(self):
        self.assert_refused(endmill("plam"), 2, 'found "plam"', "did you mean plan?")
        self.assert_refused(endmill(), 2, "subcommand is required", "endmill --help")

    def test_repeated_options_and_missing_values_are_told_in_words(self):
        for options, words in ((["--part", "a.stl", "--part", "b.stl"], "--part: given 2 times; expected once"),
                               (["--scallop", "1", "--scallop", "2", "--scallop", "3"],
                                "--scallop: given 3 times; expected once"),
                               (["--part"], "--part: no value; expected --part FILE"),
                               (["--scallop"], "--scallop: no value; expected --scallop MM")):
            self.assert_refused(endmill("verify", "p.csv", *options), 2, words + "; see endmill verify --help")

    def test_formula_without_eval_gets_a_suggestion(self):
        for arguments in ([], ["--help"], ["--radius", "5", "--curvature", "0", "--scallop", "1"]):
            self.assert_refused(endmill("path-interval", *arguments), 2, '"path-interval", which endmill does not know',
                                "did you mean endmill eval path-interval?")
        self.assert_refused(endmill("step-lenth"), 2, "did you mean endmill eval step-length?")

    def test_unknown_command_with_help_is_refused(self):
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
            self.assertNotIn("not yet", paper["methods"])
            self.assertRegex(paper["author"], r"^[A-Z][A-Za-z,. -]+$")
        self.assertIn("[JangKimJeong] Jang, B. J.; Kim, H. J. and Jeong, J. H.: Removal", endmill("cite").stdout)

    def test_cite_names_the_paper_of_every_command_that_follows_one(self):
        methods = {paper["key"]: paper["methods"] for paper in self.summary("cite")["papers"]}
        for key, commands in (("KimChoi", ("plan", "info", "eval")), ("JangKimJeong", ("trim",)),
                              ("KangSuh", ("setup", "machine")), ("ParkMaeng", ("feed", "coefficients", "toollife"))):
            for command in commands:
                self.assertIn(command, methods[key])

    def test_quiet_prints_nothing(self):
        done = endmill("info", ROOT / "datasets/surfaces/plane.json", "--quiet")
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("", "", 0))


if __name__ == "__main__":
    unittest.main()
