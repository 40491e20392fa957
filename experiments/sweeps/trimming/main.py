# SPDX-License-Identifier: GPL-3.0-or-later
"""Share of random curves that each trimming method gets wrong. Columns: README.md beside this.

  PYTHONPATH=scripts python3 experiments/sweeps/trimming/main.py OUTPUT_FOLDER [SIZE] [--prepare | --evaluate]

SIZE is the number of blocks of 1000 curves of each family and number of points.
"""
import sys
from pathlib import Path

from studies import trimming
from studies.study import Study, main

main(Study(Path(__file__).parent, trimming.prepare, trimming.evaluate), sys.argv[1:])
