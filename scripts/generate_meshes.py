#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the meshes and lists of facets of datasets/meshes into that folder or into FOLDER. The result is reproducible.

Usage: scripts/generate_meshes.py [FOLDER]
Example: scripts/generate_meshes.py /tmp

The script does not write teapot-288.off, which has no formula.
"""
import sys
from pathlib import Path

from generation import mesh_texts, solids

FOLDER = Path(__file__).resolve().parent.parent / "datasets/meshes"

MESHES = {
    "pocket.stl": (mesh_texts.stl_ascii, solids.pocket),
    "dome.stl": (mesh_texts.stl_binary, solids.dome),
    "v-groove.stl": (mesh_texts.stl_ascii, solids.v_groove),
    "prism.obj": (mesh_texts.obj, solids.prism),
    "prism.ply": (mesh_texts.ply_binary, solids.prism),
    "prism.off": (mesh_texts.off, solids.prism),
    "bladed-wheel.off": (mesh_texts.off, solids.bladed_wheel),
    "bladed-wheel-bottom.txt": (mesh_texts.bottom_facets, solids.bladed_wheel),
    "walled-saddle.off": (mesh_texts.off, solids.walled_saddle),
    "walled-saddle-bottom.txt": (mesh_texts.bottom_facets, solids.walled_saddle),
}


def main(arguments):
    if len(arguments) > 1 or any(a.startswith("-") for a in arguments):
        print(__doc__.strip())
        return 0 if arguments in (["--help"], ["-h"]) else 2
    folder = Path(arguments[0]) if arguments else FOLDER
    for name, (write, solid) in MESHES.items():
        path = folder / name
        path.write_bytes(write(path.stem, *solid()))
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
