#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails if the tables of README.md and the experiments are not the same list."""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAMED = re.compile(r"experiments/[A-Za-z0-9_-]+/[A-Za-z0-9_-]+")


def main(root):
    readme = (root / "README.md").read_text(encoding="utf-8").splitlines()
    listed = {name for line in readme if line.startswith("|") for name in NAMED.findall(line)}
    drivers = (root / "experiments").glob("*/*/main.cpp")
    there = {str(driver.parent.relative_to(root)) for driver in drivers}
    bad = [f"README.md: no table names {name}" for name in sorted(there - listed)]
    bad += [f"README.md: {name} has no main.cpp" for name in sorted(listed - there)]
    print("\n".join(bad) or f"{len(there)} experiments, all in README.md")
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT))
