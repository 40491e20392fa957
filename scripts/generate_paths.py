#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the tool paths of datasets/paths into that folder or into FOLDER. The result is reproducible.

Usage: scripts/generate_paths.py [FOLDER]
Example: scripts/generate_paths.py /tmp
"""
import math
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "datasets/paths"

DOME_RADIUS = 20  # mm
BALL_RADIUS = 5  # mm
LEAD = math.radians(15)  # lean of the tool towards the feed
CLEARANCE = 30  # mm along the tool axis, of rapids
FEED = 800  # mm/min
COLUMNS = "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z,feed_mm_per_min,spindle_rpm"


def dome_pose(polar, azimuth, sense):
    """Tip and axis of a ball that touches the dome and leans towards its feed along the circle."""
    normal = (math.sin(polar) * math.cos(azimuth), math.sin(polar) * math.sin(azimuth), math.cos(polar))
    feed = (-sense * math.sin(azimuth), sense * math.cos(azimuth), 0)
    axis = [math.cos(LEAD) * n + math.sin(LEAD) * f for n, f in zip(normal, feed)]
    tip = [(DOME_RADIUS + BALL_RADIUS) * n - BALL_RADIUS * v for n, v in zip(normal, axis)]
    return tip, axis


def row(number, point, move, pose):
    """A line of a tool path. Twelve digits behind the point leave the axis a unit vector."""
    tip, axis = pose
    numbers = ",".join(repr(round(x, 12) + 0.0) for x in (*tip, *axis))
    feed = "" if move == "rapid" else str(FEED)
    return f"{number},{point},{move},{numbers},{feed},6000"


def dome():
    """Arcs of circles round a dome, from its top down to 60 degrees, in alternate directions."""
    lines = [COLUMNS]
    for number, polar in enumerate(range(10, 61, 5)):
        sense = 1 if number % 2 == 0 else -1
        azimuths = [sense * azimuth for azimuth in range(-80, 81, 4)]
        poses = [dome_pose(math.radians(polar), math.radians(azimuth), sense) for azimuth in azimuths]
        above = [([t + CLEARANCE * v for t, v in zip(*pose)], pose[1]) for pose in (poses[0], poses[-1])]
        moves = [("rapid", above[0]), ("plunge", poses[0]), *(("cut", pose) for pose in poses[1:]),
                 ("retract", above[1])]
        lines += [row(number, point, *move) for point, move in enumerate(moves)]
    return "\n".join(lines) + "\n"


def main(arguments):
    if len(arguments) > 1 or any(a.startswith("-") for a in arguments):
        print(__doc__.strip())
        return 0 if arguments in (["--help"], ["-h"]) else 2
    path = (Path(arguments[0]) if arguments else FOLDER) / "dome.csv"
    path.write_text(dome(), encoding="ascii")
    print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
