# SPDX-License-Identifier: GPL-3.0-or-later
"""Bytes and seconds of the visibility of large parts on many ranks, by formulas and by a simulation of the schedule.

  PYTHONPATH=scripts python3 experiments/sweeps/scale/main.py OUTPUT_FOLDER

Deterministic. Columns: README.md beside this.
"""
import json
import sys
from pathlib import Path

from studies import scale
from studies.study import write_csv

parameters = json.loads((Path(__file__).parent / "params.json").read_text(encoding="utf-8"))["parameters"]
write_csv(Path(sys.argv[1]) / "result.csv", *scale.table(parameters))
