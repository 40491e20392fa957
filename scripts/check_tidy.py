#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on any finding of clang-tidy in the files that changed (with --all: in all files).

Changed files differ from the merge base with origin/main, or from the previous commit if the merge
base is the current commit. They include uncommitted and untracked files. A header is checked through
the .cpp file of the same name, or else through one that includes it.

Example: scripts/check_tidy.py --all
"""
import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = "build/release"  # the folder of compile_commands.json


def git(root, *arguments):
    """The output lines of git, or None if it fails."""
    command = ["git", *arguments]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    return done.stdout.splitlines() if done.returncode == 0 else None


def base(root):
    """The commit to compare with, or None for a first commit."""
    head = git(root, "rev-parse", "--verify", "--quiet", "HEAD")
    fork = git(root, "merge-base", "HEAD", "origin/main")
    if fork and fork != head:
        return fork[0]
    parent = git(root, "rev-parse", "--verify", "--quiet", "HEAD~1")
    return parent[0] if parent else None


def changed(root):
    """The changed files, or None without a commit to compare with."""
    commit = base(root)
    if commit is None:
        return None
    differing = git(root, "diff", "--name-only", "--diff-filter=d", commit) or []
    untracked = git(root, "ls-files", "--others", "--exclude-standard") or []
    return sorted({root / name for name in differing + untracked})


def through(header, compiled):
    """The .cpp file for checking `header`: the one of the same name, or else the first that includes it."""
    same_name = header.with_suffix(".cpp")
    if same_name in compiled:
        return [same_name]
    return [f for f in compiled if f.exists() and includes(f, header)][:1]


def includes(file, header):
    included = re.findall(r'^#include "(.+)"', file.read_text(encoding="utf-8"), re.M)
    return any(str(header).endswith("/" + name) for name in included)


def select(files, compiled):
    """The files of `compiled` that must be checked to cover all changed `files`."""
    chosen = {f for f in files if f in compiled}
    for header in (f for f in files if f.suffix == ".h"):
        chosen.update(through(header, compiled))
    return sorted(chosen)


def for_clang(command):
    """A compile command of g++, converted for clang."""
    command = re.sub(r"-Winvalid-pch|-include \S+/cmake_pch\.hxx|-Wno-restrict|-Wno-stringop-overflow|-Wno-array-bounds", "", command)
    return command + " -Wno-unknown-warning-option"


def each_alone(entry):
    """A compile command for each file that the file of `entry` includes (a unity build)."""
    gathered = Path(entry["directory"], entry["file"])
    if not gathered.name.startswith("unity_"):
        return [entry]
    parts = re.findall(r'^#include "(.+)"', gathered.read_text(encoding="utf-8"), re.M)
    return [{**entry, "file": part, "command": entry["command"].replace(entry["file"], part)}
            for part in parts]


def tidy(database, file):
    """The findings of clang-tidy in `file`, empty without findings."""
    command = ["clang-tidy", "--quiet", "-p", str(database), str(file)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    found = done.stdout + (done.stderr if done.returncode else "")
    return found if done.returncode or done.stdout.strip() else ""


def main(root, look_at_all):
    database = root / BUILD / "compile_commands.json"
    if not database.exists():
        sys.exit(f"{database} is missing: run cmake --preset release first")
    entries = [alone for entry in json.loads(database.read_text(encoding="utf-8"))
               for alone in each_alone(entry)]
    compiled = sorted({Path(entry["directory"], entry["file"]).resolve() for entry in entries})
    compiled = [f for f in compiled if not f.is_relative_to(root / "build")]
    files = None if look_at_all else changed(root)
    chosen = compiled if files is None else select(files, compiled)
    print(f"clang-tidy: {len(chosen)} of {len(compiled)} files", flush=True)
    for entry in entries:
        entry["command"] = for_clang(entry["command"])
    clean = True
    with ThreadPoolExecutor(os.cpu_count()) as pool, tempfile.TemporaryDirectory() as folder:
        Path(folder, database.name).write_text(json.dumps(entries), encoding="utf-8")
        for found in pool.map(lambda file: tidy(folder, file), chosen):
            if found:
                clean = False
                print(found, flush=True)
    return 0 if clean else 1


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--all"]):
        sys.exit(f"usage: {sys.argv[0]} [--all]\n\n{__doc__}")
    sys.exit(main(ROOT, "--all" in sys.argv))
