#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the surfaces of datasets/surfaces into that folder or into FOLDER. The result is reproducible.

Usage: scripts/generate_surfaces.py [FOLDER]
Example: scripts/generate_surfaces.py /tmp

The script does not write the net_*.json files, which have no formula.
"""
import json
import sys
from pathlib import Path

from generation.bezier_nets import bezier_surfaces
from generation.height_grids import height_grids
from generation.round_shapes import nurbs_surfaces
from generation.teapot import teapot

FOLDER = Path(__file__).resolve().parent.parent / "datasets/surfaces"

# Nesting depth of the lists that get a separate line: rows of points or of numbers.
ROW_DEPTH = {"control_points": 2, "patches": 2, "weights": 1, "z": 1}


def depth(value):
    return 1 + depth(value[0]) if isinstance(value, list) else 0


def indented(value, row_depth, indent):
    """JSON text with a separate line for every list of that depth."""
    if depth(value) <= row_depth:
        return " " * indent + json.dumps(value)
    inner = ",\n".join(indented(item, row_depth, indent + 1) for item in value)
    return f"{' ' * indent}[\n{inner}\n{' ' * indent}]"


def surface_text(name, content):
    """The text of a file, with one line for each row of the net or grid."""
    members = {"format": "endmill-surface/1", "name": name, **content}
    lines = [f" {json.dumps(key)}: " + indented(value, ROW_DEPTH.get(key, 1), 1).lstrip()
             for key, value in members.items()]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def surfaces():
    """The files, as name -> content."""
    return {**bezier_surfaces(), **nurbs_surfaces(), **height_grids(), "teapot": teapot()}


def main(arguments):
    if len(arguments) > 1 or any(a.startswith("-") for a in arguments):
        print(__doc__.strip())
        return 0 if arguments in (["--help"], ["-h"]) else 2
    folder = Path(arguments[0]) if arguments else FOLDER
    for name, content in surfaces().items():
        path = folder / f"{name}.json"
        path.write_text(surface_text(name, content), encoding="utf-8")
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
