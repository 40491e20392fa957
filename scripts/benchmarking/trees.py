# SPDX-License-Identifier: GPL-3.0-or-later
"""Working trees with their builds: the present tree, and one of another revision.

A revision must meet one condition: the preset release builds experiments/benchmarks/NAME/main.cpp as
the target benchmarks-NAME, which writes result.csv into the folder of its argument.
"""
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from reproduction.fault import Fault


@dataclass(frozen=True)
class Tree:
    """A working tree with its build in build/release."""

    root: Path
    revision: str

    def names(self):
        """The names of its benchmarks."""
        return sorted(p.parent.name for p in (self.root / "experiments/benchmarks").glob("*/main.cpp"))

    def program(self, name):
        return self.root / "build/release/experiments" / f"benchmarks-{name}"


def run_whole(command, root):
    """Runs a command. Raises Fault if it fails."""
    if subprocess.run(command, cwd=root, check=False).returncode != 0:
        raise Fault(f"{' '.join(map(str, command))} failed, see above")


def git(root, *arguments):
    """The output of git. Raises Fault if git fails."""
    done = subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True, check=False)
    if done.returncode:
        raise Fault(f"git {' '.join(arguments)}: {done.stderr.strip()}")
    return done.stdout.strip()


def checked_out(root, revision):
    """The tree of `revision` in build/bench. Checks it out if it does not exist."""
    commit = git(root, "rev-parse", "--verify", f"{revision}^{{commit}}")
    folder = root / "build/bench" / commit[:12]
    if not (folder / ".git").exists():
        git(root, "worktree", "prune")
        git(root, "worktree", "add", "--detach", str(folder), commit)
    return Tree(folder, commit[:12])


def compiler_options(root):
    """The compiler of an existing build. A build for comparison must use the same."""
    cache = root / "build/release/CMakeCache.txt"
    text = cache.read_text(encoding="utf-8") if cache.exists() else ""
    found = re.findall(r"^(CMAKE_CXX_COMPILER(?:_LAUNCHER)?):\w+=(.+)$", text, re.MULTILINE)
    return [f"-D{name}={value}" for name, value in found]


def build(tree, names, options=()):
    """Configures a tree and builds its benchmarks."""
    run_whole(["cmake", "--preset", "release", *options], tree.root)
    targets = [f"benchmarks-{name}" for name in names]
    run_whole(["cmake", "--build", "--preset", "release", "--target", *targets], tree.root)
