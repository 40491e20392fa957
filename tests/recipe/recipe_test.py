# SPDX-License-Identifier: GPL-3.0-or-later
"""Applies the recipe of docs/guide/extend.md for a new trimming method to a copy of the sources.

The test compiles only the changed table. It links the program and the tests again from the objects of
the build. The new object comes before the library, so that the linker ignores the library's own.

  recipe_test.py --picture FILE   writes the picture of docs/guide/extend.md instead
"""
import csv
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("ENDMILL_BUILD", ROOT / "build/release")).resolve()
TABLE = "src/endmill/trimming/trimming_methods.cpp"
PICTURE = ROOT / "docs/images/extend.svg"
# docs/methods/interference.md, section 11, T1: one symmetric loop that crosses itself at (0, 0).
LOOP = "s_mm,z_mm\n-6,6\n2,-2\n0,-1\n-2,-2\n6,6\n"


def succeed(*command, cwd):
    """The output of a command that must succeed."""
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False, timeout=600,
                          stdin=subprocess.DEVNULL, cwd=cwd)
    if done.returncode:
        raise RuntimeError(shlex.join(map(str, command)) + "\n" + done.stdout + done.stderr)
    return done.stdout


def recipe():
    """The steps of the recipe: path and text of the new file, its #include, its table line, the call."""
    text = (ROOT / "docs/guide/extend.md").read_text(encoding="utf-8")
    text = text[text.index("## A trimming method"):]
    path = re.search(r"`(src/\S+\.h)`", text)[1]
    file, lines, call = re.findall(r"^```\w*\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)[:3]
    include, entry = lines.splitlines()
    return path, file, include, entry, call


def apply_recipe(copy):
    """Follows the recipe in a copy of the sources."""
    path, file, include, entry, _ = recipe()
    assert not (copy / path).exists(), path
    (copy / path).write_text(file, encoding="utf-8")
    table = (copy / TABLE).read_text(encoding="utf-8")
    table = table.replace("\n\nnamespace endmill {", f"\n{include}\n\nnamespace endmill {{", 1)
    table = table.replace("\n};\n", f"\n    {entry}\n}};\n", 1)
    assert include in table and entry in table
    (copy / TABLE).write_text(table, encoding="utf-8")


def build_command(target, text):
    """The words of the last command of the build for `target` that contains `text`."""
    lines = succeed("ninja", "-C", BUILD, "-t", "commands", target, cwd=BUILD).splitlines()
    commands = [command for line in lines for command in line.split(" && ")]
    return shlex.split([command for command in commands if text in command][-1])


def compiled_file():
    """The file that the build compiles for the table of methods: a batch of sources, or the table alone."""
    for batch in Path(BUILD, "src/CMakeFiles/endmill_trimming.dir/Unity").glob("*.cxx"):
        if str(ROOT / TABLE) in batch.read_text(encoding="utf-8"):
            return batch
    return ROOT / TABLE


class Changed:
    """The table of methods, compiled after the recipe, and the programs that are linked with it."""

    def __init__(self, folder):
        self.folder = folder
        copy = folder / "copy"
        shutil.copytree(ROOT / "src", copy / "src")
        apply_recipe(copy)
        self.table = folder / "table.o"
        built, changed = compiled_file(), folder / "table.cpp"
        changed.write_text(built.read_text(encoding="utf-8").replace(f"{ROOT}/src", f"{copy}/src")
                           if built != ROOT / TABLE else f'#include "{copy / TABLE}"\n', encoding="utf-8")
        words = build_command("endmill", f"-c {built}")
        words = [{f"-I{ROOT}/src": f"-I{copy}/src", str(built): changed}.get(word, word) for word in words]
        for option, path in (("-o", self.table), ("-MF", folder / "table.d")):
            words[words.index(option) + 1] = path
        succeed(*words, cwd=BUILD)
        (folder / "datasets").symlink_to(ROOT / "datasets")

    def linked(self, made):
        """Links a program of the build with the new table."""
        program = self.folder / Path(made).name
        words = build_command(program.name, f" -o {made} ")
        words[words.index("-o") + 1] = program
        words.insert(words.index("-o"), self.table)
        succeed(*words, cwd=BUILD)
        return program

    def trimmed(self, endmill, output):
        """Runs the command of the page. Returns what it prints."""
        *_, call = recipe()
        name, *words = call.split()
        assert name == "endmill", call
        return succeed(endmill, *words, "--output", output, cwd=self.folder)


class Recipe(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name).resolve()
        cls.changed = Changed(cls.folder)

    def test_program_has_the_new_method(self):
        endmill = self.changed.linked("src/cli/endmill")
        self.assertIn("forward", self.changed.trimmed(endmill, "picture"))
        self.assertEqual((self.folder / "picture/section-0.svg").read_bytes(), PICTURE.read_bytes(),
                         "stale: run scripts/write_pictures.py extend.svg")
        (self.folder / "curves.csv").write_text(LOOP, encoding="ascii")
        succeed(endmill, *"trim --polyline curves.csv --method forward --explain -o out".split(), cwd=self.folder)
        with open(self.folder / "out/trimmed.csv", encoding="ascii", newline="") as file:
            left = [(row["s_mm"], row["z_mm"]) for row in csv.DictReader(file)]
        self.assertEqual(left, [("-6", "6"), ("2", "-2"), ("6", "6")])
        with open(self.folder / "out/loops.csv", encoding="ascii", newline="") as file:
            [cut] = csv.DictReader(file)
        self.assertEqual([cut[key] for key in ("first_point", "last_point", "rule")], ["2", "3", "behind"])
        said = succeed(endmill, "trim", "--polyline", "curves.csv", "--method", "all", cwd=self.folder)
        self.assertIn("forward", said)
        self.assertIn("|forward|all", succeed(endmill, "trim", "--help", cwd=self.folder))

    def test_new_method_passes_the_tests_of_all_methods(self):
        program = self.changed.linked("src/endmill_trimming_test")
        said = succeed(program, "--gtest_filter=TrimmingMethods.*", cwd=self.folder)
        self.assertIn("TrimmingMethods.AllKeepTheContract", said)


def write_picture(file):
    with tempfile.TemporaryDirectory() as folder:
        changed = Changed(Path(folder).resolve())
        changed.trimmed(changed.linked("src/cli/endmill"), "picture")
        shutil.copyfile(changed.folder / "picture/section-0.svg", file)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--picture"]:
        write_picture(sys.argv[2])
    else:
        unittest.main()
