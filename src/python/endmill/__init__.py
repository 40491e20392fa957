# SPDX-License-Identifier: GPL-3.0-or-later
"""Computational geometry of sculptured-surface machining.

Values and functions with NumPy arrays: Surface, Mesh, Cutter, DropCutter, ToolPath, Machine,
DirectionGrid, trim_curves, compare_trimming, cutting_coefficients, visibility.

The commands of the program, with the same results bit by bit: plan, trim, verify, post, feed,
setup, info, sample, machine, evaluate, tool_life, import_cad, run_job, run_sweep, view, and command
for all.

Lengths are in mm, angles in degrees where a name ends in _deg. Arrays of points have the shape
(n, 3). Long calls release Python's lock, end at Ctrl-C, and take progress, a function of the
finished share from 0 to 1.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from endmill import errors
from endmill._native import (Cutter, DirectionGrid, DropCutter, Machine, Mesh, Part, Surface,
                             ToolPath, Trimmed, VisibilityMap, _compare_trimming, _read_part,
                             _read_path, cutting_coefficients, move_names, read_visibility,
                             set_thread_count, trim_curves, trimming_methods, visibility)
from endmill.commands import (Result, command, evaluate, feed, import_cad, info, machine, plan,
                              post, run_job, run_sweep, sample, setup, tool_life, trim, verify, view)
from endmill.errors import (DomainError, Error, FormatError, GeometryError, LimitError,
                            OutputError)

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from os import PathLike

    import numpy as np
    import numpy.typing as npt

__all__ = [
    "Cutter", "DirectionGrid", "DomainError", "DropCutter", "Error", "FormatError",
    "GeometryError", "LimitError", "Machine", "Mesh", "OutputError", "Part", "Result", "Surface",
    "ToolPath", "Trimmed", "VisibilityMap", "command", "compare_trimming", "cutting_coefficients",
    "errors", "evaluate", "feed", "import_cad", "info", "machine", "move_names", "plan", "post",
    "read_part", "read_path", "read_visibility", "run_job", "run_sweep", "sample",
    "set_thread_count", "setup", "tool_life", "trim", "trim_curves", "trimming_methods", "verify",
    "view", "visibility"
]


def read_part(path: str | PathLike[str], units: str = "mm", up: str = "z") -> Part:
    """Read a surface file (endmill-surface/1), a mesh file (.stl, .obj, .ply, .off), or a STEP or
    IGES file (as a mesh; see import_cad for its surfaces).

    units ("mm" or "inch") and up ("x", "-x", ... "z": the axis that points upwards) are for mesh
    files; up also for CAD files, which state their unit. Raises FormatError with the place of a
    fault.
    """
    if str(path).lower().endswith((".step", ".stp", ".iges", ".igs")):
        imported = import_cad(path)
        part = _read_part(imported.folder / "mesh.ply", units, up)
    else:
        part = _read_part(path, units, up)
        if part.mesh is None:  # commands get what was read, whatever becomes of the file
            with open(path, "rb") as file:
                part._name = os.path.basename(os.fsdecode(path))
                part._content = file.read()
    return part


def read_path(path: str | PathLike[str]) -> ToolPath:
    """Read a tool path: CSV, G-code of three axes, output of rs274, or APT CL data.

    Raises FormatError with the line of a fault.
    """
    return _read_path(path)


def compare_trimming(
    planes: Sequence[Sequence[npt.ArrayLike]],
    methods: Sequence[str | Callable[[list[npt.NDArray[np.float64]]], Sequence[npt.ArrayLike]]],
    repeat: int = 3,
    tolerance: float = 1e-9,
    detection: str = "guarded",
) -> list[dict[str, Any]]:
    """Trim the curves of drive planes by several methods, and measure times and errors.

    planes: for each plane its curves, arrays (n, 2) of s and z in mm as in trim_curves. methods:
    names from trimming_methods, and functions of your own. A function takes the curves of one
    plane and returns curves. repeat: how often each method runs.

    Returns a dict for each method: method, planes, wrong (number of planes with an error),
    max_gouge_mm (depth below the upper envelope), max_step_back_mm, max_uncovered (share of the
    length in s), times_ms (a list). A result is wrong if it lies more than tolerance in mm
    below the envelope, steps back, or leaves a part of it out. The errors are measured from the
    segments of the curves alone, without any of the methods.
    """
    return _compare_trimming(planes, methods, repeat, tolerance, detection)
