#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the curves of datasets/offset-curves into that folder or into FOLDER.

Usage: scripts/generate_offset_curves.py [FOLDER]
Example: scripts/generate_offset_curves.py /tmp

The script reads vectors.json, hard-cases.json and random-families.json of the dataset. It writes
their curves as polyline files, vectors/*.csv and hard-cases/*.csv, and into random-families/*.json
the profiles of the families with the exact envelopes of their curves.
"""
import json
import sys
from math import cos, cosh, log, sin, sqrt, tanh
from pathlib import Path

from generation.profile_families import CONVEX_POINTS, convex, wavy
from generation.upper_envelope import carriers_and_joints

FOLDER = Path(__file__).resolve().parent.parent / "datasets/offset-curves"


def sign(x):
    """The sign of a number: -1, 0 or 1."""
    return (x > 0) - (x < 0)


def sech2(x):
    """The square of the hyperbolic secant, 1 / cosh^2."""
    return 1 / (cosh(x) * cosh(x))


PARABOLA = (lambda x: x * x / 2, lambda x: x)
QUARTIC = (lambda x: (x * x - 1) * (x * x - 1), lambda x: 4 * x * (x * x - 1))
POCKET = (lambda x: 1.5 * (tanh(6 * (x - 1)) - tanh(6 * (x + 1))),
          lambda x: 9 * (sech2(6 * (x - 1)) - sech2(6 * (x + 1))))

# Height and slope of each profile. hard-cases.json has the interval and the radius.
PROFILES = {
    "parabola": PARABOLA,
    "tilted-parabola": (lambda x: x * x / 2 + 1.2 * x, lambda x: x + 1.2),
    "parabola-small-tool": PARABOLA,
    "gentle-wave": (lambda x: 0.3 * cos(x), lambda x: -0.3 * sin(x)),
    "hill-and-valley": (lambda x: 0.5 * sin(x), lambda x: 0.5 * cos(x)),
    "cosine-three-valleys": (lambda x: -cos(2 * x), lambda x: 2 * sin(2 * x)),
    "w-low-ridge": (lambda x: x * x / 4 + 0.5 * cos(3 * x),
                    lambda x: x / 2 - 1.5 * sin(3 * x)),
    "w-nested": (lambda x: x * x / 4 + 0.8 * cos(3 * x),
                 lambda x: x / 2 - 2.4 * sin(3 * x)),
    "quartic-w": QUARTIC,
    "quartic-w-large-tool": QUARTIC,
    "many-valleys": (lambda x: 0.2 * x * x - 0.6 * cos(4 * x) + 0.3 * sin(1.7 * x),
                     lambda x: 0.4 * x + 2.4 * sin(4 * x) + 0.51 * cos(1.7 * x)),
    "v-groove": (abs, sign),
    "ridge-crease": (lambda x: -abs(x), lambda x: -sign(x)),
    "sharp-grooves": (lambda x: 1.5 * abs(sin(x)), lambda x: 1.5 * sign(sin(x)) * cos(x)),
    "starts-in-loop": PARABOLA,
    "ends-in-loop": PARABOLA,
    "short-branch": PARABOLA,
    "steep-valley": (lambda x: 2 * x + 9 / 11 * log(cosh(2.2 * x)),
                     lambda x: 2 + 1.8 * tanh(2.2 * x)),
    "step-wall": (lambda x: 2 * tanh(4 * x), lambda x: 8 * sech2(4 * x)),
    "pocket": POCKET,
    "pocket-wide-tool": POCKET,
}


def offset(case, count=401):
    """Positions of the centre of a ball that moves along a profile."""
    height, slope = PROFILES[case["name"]]
    low, high = case["interval"]
    radius = case["radius_mm"]
    points = []
    for i in range(count):
        x = low + (high - low) * i / (count - 1)
        m = slope(x)
        w = sqrt(1 + m * m)
        points.append((x - radius * m / w, height(x) + radius / w))
    return points


def write(path, points):
    """Writes a polyline file for `endmill trim --polyline`."""
    path.parent.mkdir(exist_ok=True)
    rows = [f"{float(s)!r},{float(z)!r}\n" for s, z in points]
    path.write_text("s_mm,z_mm\n" + "".join(rows), encoding="utf-8")
    print(path)


def write_family(path, family):
    """Writes the profiles of a family, one line each, with the segments of the exact envelope."""
    path.parent.mkdir(exist_ok=True)
    rows = []
    for number, (parameters, points) in enumerate(family, 1):
        ranges, joints = carriers_and_joints(points)
        rows.append(json.dumps({"profile": number, "parameters": parameters,
                                "carriers": ranges, "joints": joints}))
    path.write_text("[\n" + ",\n".join(rows) + "\n]\n", encoding="utf-8")
    print(path)


def main(arguments):
    if len(arguments) > 1 or any(a.startswith("-") for a in arguments):
        print(__doc__.strip())
        return 0 if arguments in (["--help"], ["-h"]) else 2
    folder = Path(arguments[0]) if arguments else FOLDER
    for vector in json.loads((FOLDER / "vectors.json").read_text())["vectors"]:
        write(folder / "vectors" / f"{vector['name']}.csv", vector["points"])
    for case in json.loads((FOLDER / "hard-cases.json").read_text())["cases"]:
        write(folder / "hard-cases" / f"{case['name']}.csv", offset(case))
    families = folder / "random-families"
    write_family(families / "wavy.json", wavy())
    for points in CONVEX_POINTS:
        write_family(families / f"convex-{points}.json", convex(points))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
