# SPDX-License-Identifier: GPL-3.0-or-later
"""Working trees with their builds: the present one, and one of another revision.

Of a revision only this must hold: experiments/benchmarks/NAME/main.cpp is built as the target
benchmarks-NAME of the preset release, and writes result.csv into the folder of its argument.
"""
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from reproduction.fault import Fault


@dataclass(frozen=True)
class Tree:
    """A working tree that is built in build/release below it."""

    root: Path
    revision: str

    def names(self):
        """The names of its benchmarks."""
        return sorted(p.parent.name for p in (self.root / "experiments/benchmarks").glob("*/main.cpp"))

    def program(self, name):
        return self.root / "build/release/experiments" / f"benchmarks-{name}"


def run_whole(command, root):
    """Runs a command; a Fault if it fails."""
    if subprocess.run(command, cwd=root, check=False).returncode != 0:
        raise Fault(f"{' '.join(map(str, command))} failed, see above")


def git(root, *arguments):
    """What git prints; a Fault if it fails."""
    done = subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True, check=False)
    if done.returncode:
        raise Fault(f"git {' '.join(arguments)}: {done.stderr.strip()}")
    return done.stdout.strip()


def checked_out(root, revision):
    """The tree of `revision` in build/bench, checked out if it is not there yet."""
    commit = git(root, "rev-parse", "--verify", f"{revision}^{{commit}}")
    folder = root / "build/bench" / commit[:12]
    if not (folder / ".git").exists():
        git(root, "worktree", "prune")
        git(root, "worktree", "add", "--detach", str(folder), commit)
    return Tree(folder, commit[:12])


def compiler_options(root):
    """The compiler of an existing build, for another build that is compared with it."""
    cache = root / "build/release/CMakeCache.txt"
    text = cache.read_text(encoding="utf-8") if cache.exists() else ""
    found = re.findall(r"^(CMAKE_CXX_COMPILER(?:_LAUNCHER)?):\w+=(.+)$", text, re.MULTILINE)
    return [f"-D{name}={value}" for name, value in found]


def build(tree, names, options=()):
    """Configures a tree and builds its benchmarks."""
    run_whole(["cmake", "--preset", "release", *options], tree.root)
    targets = [f"benchmarks-{name}" for name in names]
    run_whole(["cmake", "--build", "--preset", "release", "--target", *targets], tree.root)
