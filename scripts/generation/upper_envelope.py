# SPDX-License-Identifier: GPL-3.0-or-later
"""The exact upper envelope of a polyline in the plane.

Between two neighbouring abscissae of the vertices, every run of the curve is one straight line. The
envelope is therefore computed interval by interval. Doubles decide where their rounding error permits,
and rational numbers otherwise.
"""
from fractions import Fraction

SURE = 1e-11  # relative bound far above the rounding error of one interpolation


def runs(points):
    """The segments between two turns in s, as lists of (index, left, right) from left to right."""
    found = [[]]
    rising = None
    for i, (p, q) in enumerate(zip(points, points[1:])):
        if p[0] == q[0]:
            raise ValueError(f"segment {i} is vertical")
        if rising not in (None, p[0] < q[0]):
            found.append([])
        rising = p[0] < q[0]
        found[-1].append((i, p, q) if rising else (i, q, p))
    return [run if run[0][1] < run[-1][1] else run[::-1] for run in found]


def height(segment, s):
    """The height of a segment above s, exact."""
    (s0, z0), (s1, z1) = ((Fraction(c) for c in point) for point in segment[1:])
    return z0 + (z1 - z0) * (Fraction(s) - s0) / (s1 - s0)


def rounded_heights(segment, left, right):
    """The heights of a segment at two places, in doubles."""
    _, (s0, z0), (s1, z1) = segment
    slope = (z1 - z0) / (s1 - s0)
    return z0 + slope * (left - s0), z0 + slope * (right - s0)


def crossing(one, two):
    """The s at which the lines of two segments meet, or None."""
    rise = height(one, 1) - height(one, 0)
    rise -= height(two, 1) - height(two, 0)
    return rise and (height(two, 0) - height(one, 0)) / rise


def highest_lines(lines, left, right):
    """The highest of `lines` from left to right, as pairs of a line and the s where it ends."""
    at, left, right = Fraction(left), Fraction(left), Fraction(right)
    found = []
    while at < right:
        # The highest line just right of `at` is higher at `at`, or equally high and steeper.
        top = max(lines, key=lambda line: (height(line, at), height(line, right)))
        ends = (crossing(top, line) for line in lines
                if height(line, right) > height(top, right))
        at = min((s for s in ends if s > at), default=right)
        found.append((top, at))
    return found


def sure_top(lines, left, right):
    """The line that is highest from end to end, if doubles can decide it."""
    if len(lines) == 1:
        return lines[0]
    ends = [rounded_heights(line, left, right) for line in lines]
    best = max(range(len(lines)), key=lambda k: ends[k][0])
    margin = SURE * max(abs(z) for line in lines for _, z in line[1:])
    sure = all(ends[best][0] > low + margin and ends[best][1] > high + margin
               for k, (low, high) in enumerate(ends) if k != best)
    return lines[best] if sure else None


def upper_envelope(points):
    """The envelope from left to right, as pairs of a segment and the exact s where it ends."""
    pending = [run[::-1] for run in runs(points)]
    places = sorted({s for s, _ in points})
    found = []
    for left, right in zip(places, places[1:]):
        lines = []
        for run in pending:
            while run and run[-1][2][0] <= left:
                run.pop()
            if run and run[-1][1][0] <= left:
                lines.append(run[-1])
        top = sure_top(lines, left, right)
        for line, end in [(top, right)] if top else highest_lines(lines, left, right):
            if found and found[-1][0] is line:
                found.pop()
            found.append((line, end))
    return found


def carriers_and_joints(points):
    """Index ranges of the segments on the envelope, and the joints between them.

    A joint is [s, z], or [s, z on the left, z on the right] where the curve ends or turns back.
    """
    ranges, joints = [], []
    before = None
    for line, end in upper_envelope(points):
        index = line[0]
        if before is None or abs(index - before[0][0]) != 1:
            if before:
                sides = [height(side, before[1]) for side in (before[0], line)]
                joints.append([before[1], *(sides if sides[0] != sides[1] else sides[:1])])
            ranges.append([index, index])
        ranges[-1] = [min(ranges[-1][0], index), max(ranges[-1][1], index)]
        before = (line, end)
    return ranges, [[float(f"{float(value):.15g}") for value in joint] for joint in joints]
