# SPDX-License-Identifier: GPL-3.0-or-later
"""Passes along u against passes along v on random surfaces. Columns: README.md beside this.

  PYTHONPATH=scripts python3 experiments/sweeps/directions/main.py OUTPUT_FOLDER [SIZE] [--prepare | --evaluate]

SIZE is the number of surfaces of each kind.
"""
import sys
from pathlib import Path

from studies import directions
from studies.study import Study, main

main(Study(Path(__file__).parent, directions.prepare, directions.evaluate), sys.argv[1:])
