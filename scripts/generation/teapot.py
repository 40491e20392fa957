# SPDX-License-Identifier: GPL-3.0-or-later
"""The Utah teapot, from ten patches and their symmetry.

The numbers were published by M. Newell. The heights are divided by 1.3, as is usual. The z axis points
upwards, and the spout points along +x.
"""
from fractions import Fraction

MM_PER_UNIT = 30

# Patches of a quarter turn about the z axis, as rows of radius, offset and z. The offset belongs to the
# two middle points of a quarter. It is 0.56 of the radius except for the knob. Rows go downwards, and
# quarters clockwise seen from above.
PROFILES = {
    "rim": "1.4 .784 2.4, 1.3375 .749 2.53125, 1.4375 .805 2.53125, 1.5 .84 2.4",
    "upper body": "1.5 .84 2.4, 1.75 .98 1.875, 2 1.12 1.35, 2 1.12 .9",
    "lower body": "2 1.12 .9, 2 1.12 .45, 1.5 .84 .225, 1.5 .84 .15",
    "knob": "0 0 3.15, .8 .45 3.15, 0 0 2.85, .2 .112 2.7",
    "lid": "0.2 .112 2.7, .4 .224 2.55, 1.3 .728 2.55, 1.3 .728 2.4",
}
BOTTOM = "0 0 0, 1.425 .798 0, 1.5 .84 .075, 1.5 .84 .15"  # rows go outwards, quarters counter-clockwise

# Halves of tubes, whose other halves are mirrored in y = 0. A row has x and z on one side, the half
# width, and x and z on the other side.
TUBES = {
    "upper handle": "-1.6 2.025 .3 -1.5 2.25, -2.3 2.025 .3 -2.5 2.25,"
                    " -2.7 2.025 .3 -3 2.25, -2.7 1.8 .3 -3 1.8",
    "lower handle": "-2.7 1.8 .3 -3 1.8, -2.7 1.575 .3 -3 1.35,"
                    " -2.5 1.125 .3 -2.65 .9375, -2 .9 .3 -1.9 .6",
    "lower spout": "1.7 1.425 .66 1.7 .6, 2.6 1.425 .66 3.1 .825,"
                   " 2.3 2.1 .25 2.4 2.025, 2.7 2.4 .25 3.3 2.4",
    "upper spout": "2.7 2.4 .25 3.3 2.4, 2.8 2.475 .25 3.525 2.49375,"
                   " 2.9 2.475 .15 3.45 2.5125, 2.8 2.4 .15 3.2 2.4",
}


def rows(text):
    """The numbers of a table in mm, as rational numbers."""
    return [[MM_PER_UNIT * Fraction(word) for word in row.split()] for row in text.split(",")]


def quarter_turns(profile, turn):
    """Four patches. The first goes from +x to `turn` * y, each further one is a quarter turn ahead."""
    patch = [[(r, 0, z), (r, turn * offset, z), (offset, turn * r, z), (0, turn * r, z)]
             for r, offset, z in profile]
    patches = []
    for _ in range(4):
        patches.append(patch)
        patch = [[(-turn * y, turn * x, z) for x, y, z in row] for row in patch]
    return patches


def mirrored_halves(tube):
    half = [[(a, 0, b), (a, -width, b), (c, -width, d), (c, 0, d)] for a, b, width, c, d in tube]
    return [half, [[(x, -y, z) for x, y, z in reversed(row)] for row in half]]


def patches():
    """The 32 nets in the usual order: rim, body, handle, spout, knob and lid, bottom."""
    turned = {name: quarter_turns(rows(text), -1) for name, text in PROFILES.items()}
    nets = turned["rim"] + turned["upper body"] + turned["lower body"]
    for text in TUBES.values():
        nets += mirrored_halves(rows(text))
    nets += turned["knob"] + turned["lid"] + quarter_turns(rows(BOTTOM), 1)
    return [[[[float(c) for c in point] for point in row] for row in net] for net in nets]


def teapot():
    """The content of the file."""
    return {
        "source": "The Utah teapot of M. Newell (1975), 32 bicubic patches as listed in three.js"
                  f" 0.187.0 (heights divided by 1.3, as usual), times {MM_PER_UNIT} mm.",
        "type": "bezier-patches", "tool_side": "du_cross_dv", "patches": patches(),
    }
