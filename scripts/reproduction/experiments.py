# SPDX-License-Identifier: GPL-3.0-or-later
"""The experiments of the repository and their files."""
import json
import re
from dataclasses import dataclass
from pathlib import Path

from .fault import Fault

NOT_A_PAPER = {"support"}  # a library that the drivers share
BENCHMARKS = "benchmarks"
PAPERS = ["economic-cl-data", "interference", "five-axis-setup", "ball-end-milling"]  # in the order of README.md
BESIDE_THE_PAPERS = ["verification", "economy", "five-axis-paths", "sweeps", BENCHMARKS]  # experiments of this project, shown last
DRIVER, SCRIPT = "main.cpp", "main.py"  # an experiment has one of them


def has_driver(folder):
    """Whether a folder of experiments/PAPER is an experiment."""
    return any((folder / name).is_file() for name in (DRIVER, SCRIPT))


@dataclass(frozen=True)
class Experiment:
    """experiments/PAPER/ITEM: one published table or figure, a study by a sweep, or a benchmark."""

    root: Path  # of the repository
    paper: str
    item: str

    @property
    def name(self):
        return f"{self.paper}/{self.item}"

    @property
    def folder(self):
        return self.root / "experiments" / self.paper / self.item

    @property
    def results(self):
        return self.root / "results" / self.paper / self.item

    @property
    def target(self):
        """The name of the driver in the build; for a script that of what it runs, by default the program."""
        return self.params().get("target", "endmill") if self.script.is_file() else f"{self.paper}-{self.item}"

    @property
    def script(self):
        return self.folder / SCRIPT

    @property
    def program(self):
        return self.root / "build/release/experiments" / self.target

    def command(self, output):
        """The words that run the driver, from the root of the repository. It writes into the folder `output`."""
        if self.script.is_file():
            return ["/usr/bin/python3", str(self.script), output]
        return [str(self.program), output]

    def params(self):
        """The contents of params.json, empty without the file."""
        path = self.folder / "params.json"
        if not path.exists():
            return {}
        try:
            params = json.loads(path.read_text(encoding="utf-8"))
        except ValueError as error:
            raise Fault(f"{path}: {error}") from None
        if not isinstance(params, dict):
            raise Fault(f"{path}: expected an object")
        unknown = params.keys() - {"parameters", "tolerances", "figures", "alone", "long", "peers", "target", "view"}
        if unknown:
            raise Fault(f"{path}: unknown keys {sorted(unknown)}")
        return params

    def runs_alone(self):
        """Whether the experiment measures time, so that nothing else may run at the same time."""
        return self.paper == BENCHMARKS or bool(self.params().get("alone"))

    def is_long(self):
        """Whether `reproduce.sh --quick` leaves the experiment out: benchmarks, and runs of over a minute."""
        return self.paper == BENCHMARKS or bool(self.params().get("long"))


def find_experiments(root):
    """All experiments under `root`, that is all folders with a driver, figure-5 before figure-12."""
    folders = [folder for folder in (root / "experiments").glob("*/*") if has_driver(folder)]
    found = [Experiment(root, folder.parent.name, folder.name) for folder in folders]
    return sorted((e for e in found if e.paper not in NOT_A_PAPER), key=place_in_report)


def place_in_report(experiment):
    numbered = [int(part) if part.isdigit() else part
                for part in re.split(r"(\d+)", experiment.item)]
    return *place_of_paper(experiment.paper), numbered


def place_of_paper(paper):
    """A key that sorts the papers as README.md lists them, then others by name, then the project's own studies."""
    for group, names in ((0, PAPERS), (2, BESIDE_THE_PAPERS)):
        if paper in names:
            return group, names.index(paper), paper
    return 1, 0, paper


def plain(names):
    """The set of names. Paths such as experiments/PAPER/ITEM/ become PAPER/ITEM."""
    return {name.removeprefix("experiments/").rstrip("/") for name in names}


def long_ones(experiments, names):
    """The long experiments that --quick leaves out, since `names` do not name them one by one."""
    named = plain(names)
    return [e for e in experiments
            if e.is_long() and e.name not in named
            and not (e.paper == BENCHMARKS and BENCHMARKS in named)]


def select(experiments, names):
    """The experiments that `names` (PAPER or PAPER/ITEM) select, or all without names.

    Also returns the names that select none.
    """
    wanted = plain(names)
    chosen = [e for e in experiments if not wanted or e.name in wanted or e.paper in wanted]
    known = {e.name for e in experiments} | {e.paper for e in experiments}
    return chosen, sorted(wanted - known)
