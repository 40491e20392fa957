#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the manual page endmill.1 and the bash completion `endmill` from the help texts of the program.

scripts/write_manual.py PROGRAM FOLDER

The build calls it (cmake/endmill_package.cmake).
Example: scripts/write_manual.py build/release/src/cli/endmill build/manual
"""
import subprocess
import sys
from pathlib import Path

from manual.completion import completion
from manual.helps import all_helps
from manual.page import page


def main(program, folder):
    try:
        helps = all_helps(program)
        said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True)
    except (OSError, RuntimeError, subprocess.CalledProcessError) as error:
        print(f"write_manual.py: {error}", file=sys.stderr)
        return 1
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    version = said.stdout.split()[1]
    (folder / "endmill.1").write_text(page(helps, version), encoding="utf-8")
    (folder / "endmill").write_text(completion(helps), encoding="utf-8")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        sys.exit(0 if sys.argv[1:] in (["--help"], ["-h"]) else 2)
    sys.exit(main(*sys.argv[1:]))
