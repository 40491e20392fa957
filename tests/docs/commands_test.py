# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command of README.md and of the guide works as printed.

The commands of a page are in the fenced `sh` blocks. The test runs the commands of one page in order, in a
temporary folder with a link to `datasets` and with the program on the path. Each page runs without the results
of other pages, and no two pages write files or folders of the same name. A reader can therefore run all pages
in one folder.
"""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("ENDMILL", ROOT / "build/release/src/cli/endmill")).resolve()
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs/guide").glob("*.md"))]
BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.DOTALL | re.MULTILINE)

# Commands that this test does not run: scripts/test.sh itself builds the program and runs this test, and
# with --all also docs.sh and `reproduce.sh economic-cl-data/table-1`, as the guide prints it. No test runs
# reproduce.sh without a name, which takes 15 minutes; tests/scripts/reproduce_test.py tests how it
# chooses the experiments. The test sets the path itself. tests/package installs by pip, with --all.
RUN_BY_TEST_SH = re.compile(r"^(scripts/(test|reproduce|docs|bench|setup|fuzz)\.sh|cmake |ctest |export PATH=|"
                            r"python3 -m venv |my-environment/bin/pip )")


def commands(page):
    """The commands of a page. Lines that end in a backslash are joined with the next."""
    for block in BLOCK.findall(page.read_text(encoding="utf-8")):
        for command in block.replace("\\\n", " ").splitlines():
            command = re.sub(r"\s+#.*$", "", command).strip()
            if command and not command.startswith("#"):
                yield command


# Without endmill-mpi the commands of mpirun are not run. Root may start it here, with more ranks than cores.
HAS_MPI = PROGRAM.with_name("endmill-mpi").exists() and shutil.which("mpirun")
# Nor, without endmill-cad, those of STEP and IGES files, and of what they make.
HAS_CAD = PROGRAM.with_name("endmill-cad").exists()
CAD = re.compile(r"datasets/cad/|datasets/jobs/mould|\bcad-|\bmould")
# Without npm and esbuild the build has no page, and no command writes one.
HAS_PAGE = (PROGRAM.parents[1] / "page/page/page.js").exists()
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}


class Commands(unittest.TestCase):
    """Has one test for each page, which the loop below adds."""

    written = {}  # file or folder that a page wrote -> the page

    def run_page(self, page):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "datasets").symlink_to(ROOT / "datasets")
            path = f"{PROGRAM.parent}{os.pathsep}{os.environ['PATH']}"
            pending = ""
            for command in commands(page):
                if RUN_BY_TEST_SH.match(command) or (command.startswith("mpirun ") and not HAS_MPI) or (
                        not HAS_PAGE and re.search(r"^endmill view | --html", command)) \
                        or (CAD.search(command) and not HAS_CAD):
                    continue
                pending = f"{pending} {command}".strip()
                if pending.endswith("&&"):
                    continue
                done = subprocess.run(["bash", "-c", pending], cwd=folder, capture_output=True, text=True,
                                      check=False, stdin=subprocess.DEVNULL, timeout=600,
                                      env={**os.environ, **MPI, "PATH": path})
                self.assertEqual(done.returncode, EXIT_CODES.get(pending, 0),
                                 f"{page.name}: {pending}\n{done.stdout}{done.stderr}")
                pending = ""
            for entry in sorted(os.listdir(folder)):
                if entry not in ("datasets", ".endmill-cad"):
                    other = self.written.setdefault(entry, page)
                    self.assertEqual(other, page, f"both pages write {entry}")


# Commands that exit with another code than 0, as their page states.
EXIT_CODES = {
    "endmill plan datasets/surfaces/net_rot24_7D.json --mode paper --cutter ball:15 --direction v -o plan-paper": 1,
    "endmill setup datasets/meshes/prism.off --machine W/xyBz/T --max-setups 4 --incidence-deg 70 -o prism-setups": 1,
    "endmill setup datasets/meshes/bladed-wheel.off --skip-facets datasets/meshes/bladed-wheel-bottom.txt "
    "   --machine W/xyBz/T --max-setups 8 --incidence-deg 88 -o wheel-setups": 1,
    "endmill setup datasets/meshes/walled-saddle.off --skip-facets datasets/meshes/walled-saddle-bottom.txt "
    "   --machine W/xyBz/T --max-setups 8 --incidence-deg 85 -o saddle-setups": 1,
}


def add_test(page):
    name = "test_" + re.sub(r"\W", "_", str(page.relative_to(ROOT).with_suffix("")))
    setattr(Commands, name, lambda self: self.run_page(page))


for each in PAGES:
    add_test(each)


class Examples(unittest.TestCase):
    """The guide shows the programs of docs/examples."""

    def test_page_shows_its_example_without_the_licence_line(self):
        for name in ("plan", "verify", "trim", "feed", "setup"):
            with self.subTest(name=name):
                page = (ROOT / f"docs/guide/{name}.md").read_text(encoding="utf-8")
                example = (ROOT / f"docs/examples/{name}.cpp").read_text(encoding="utf-8")
                licence, code = example.split("\n", 1)
                self.assertIn("SPDX-License-Identifier", licence)
                self.assertLessEqual(len(example.splitlines()), 40)
                self.assertIn(f"\n```cpp\n{code}```\n", page)


class OwnMethod(unittest.TestCase):
    """The trimming method of the guide and that of the example."""

    def test_guide_and_example_have_the_same_body(self):
        bodies = []
        for name in ("docs/guide/extend.md", "docs/examples/trim.cpp"):
            text = (ROOT / name).read_text(encoding="utf-8")
            bodies.append(re.search(r"^\{\n    Trimmed trimmed;\n.*?^\}$", text, re.DOTALL | re.MULTILINE)[0])
        self.assertEqual(*bodies)


if __name__ == "__main__":
    unittest.main()
