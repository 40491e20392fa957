#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails if clang-format would change a C++ file under src, experiments or tests, or if a
leftover of a merge or a patch (*.orig, *.rej) is committed."""
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("src", "experiments", "tests")


def sources(root):
    return sorted(f for d in FOLDERS for f in (root / d).rglob("*") if f.suffix in (".h", ".cpp"))


def would_change(files):
    """The messages of clang-format about `files`, empty if they are formatted."""
    if not files:
        return ""
    command = ["clang-format", "--dry-run", "-Werror", *map(str, files)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stdout + done.stderr if done.returncode else ""


def leftovers(root):
    """Committed leftovers of `patch` or a merge. Empty outside a repository."""
    command = ["git", "ls-files", "*.orig", "*.rej"]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    return done.stdout.splitlines()


def main(root):
    files = sources(root)
    cores = os.cpu_count() or 1
    with ThreadPoolExecutor(cores) as pool:
        said = "".join(pool.map(would_change, [files[i::cores] for i in range(cores)]))
    print(said or f"{len(files)} files are formatted")
    if said:
        print("clang-format -i FILE... formats them")
    left = leftovers(root)
    for file in left:
        print(f"{file} is left over from a merge or a patch: git rm it")
    return bool(said or left)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT))
