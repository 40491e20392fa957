# SPDX-License-Identifier: GPL-3.0-or-later
"""Random parts that can be machined in one setup, by type of machine. Columns: README.md beside this.

  PYTHONPATH=scripts python3 experiments/sweeps/machinability/main.py OUTPUT_FOLDER [SIZE] [--prepare | --evaluate]

SIZE is the number of parts of each kind.
"""
import sys
from pathlib import Path

from studies import machinability
from studies.study import Study, main

main(Study(Path(__file__).parent, machinability.prepare, machinability.evaluate), sys.argv[1:])
