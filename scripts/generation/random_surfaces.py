# SPDX-License-Identifier: GPL-3.0-or-later
"""Random surfaces with fixed seeds, for studies of many surfaces.

Every surface is the graph of a height over a rectangle of 60 to 120 mm length. Its heights are scaled so that its
curvature is about a random value between 1/300 and 1/25 per mm, of the size that balls of 8 to 20 mm can follow.
"""
import random
from math import ceil, cos, exp, log, pi, radians, sin

KINDS = ("bezier", "high-degree", "nurbs", "anisotropic", "grid")
A_KIND = 40  # surfaces of each kind
CURVATURES = (1 / 300, 1 / 25)  # 1/mm
LENGTHS = (60, 120)  # mm
ASPECTS = (1, 4)  # length over width
DECIMALS = 6  # of a coordinate in mm; rounding hides the last bits of the mathematical library


def drawn(source, low, high):
    """A random number with a uniform logarithm."""
    return low * exp(source.random() * log(high / low))


class Draft:
    """What all kinds draw first: the sides in mm, of which either may be the longer one, and the curvature."""

    def __init__(self, source):
        length = source.uniform(*LENGTHS)
        sides = [length, length / drawn(source, *ASPECTS)]
        source.shuffle(sides)
        self.width, self.depth = sides
        self.curvature = drawn(source, *CURVATURES)


def spaced(length, count):
    """`count` equidistant places from 0 to `length`."""
    return [length * k / (count - 1) for k in range(count)]


def graph(xs, ys, height):
    """Points [v][u] of a height over the places xs and ys."""
    return [[[round(x, DECIMALS), round(y, DECIMALS), round(height(i, j), DECIMALS)]
             for i, x in enumerate(xs)] for j, y in enumerate(ys)]


def random_net(source, draft, count_u, count_v):
    """A net over the draft's rectangle. Its second differences make about the draft's curvature.

    Control points of a polynomial of degree n, or of a spline with as many spans, stand L / n apart; random heights of
    the size a differ by about 4 a in the second difference.
    """
    step = min(draft.width / (count_u - 1), draft.depth / (count_v - 1))
    size = draft.curvature * step * step / 2
    heights = [[source.uniform(-size, size) for _ in range(count_u)] for _ in range(count_v)]
    return graph(spaced(draft.width, count_u), spaced(draft.depth, count_v), lambda i, j: heights[j][i])


def bezier(source, draft):
    """One bicubic patch."""
    net = random_net(source, draft, 4, 4)
    return {"type": "bezier", "patches_u": 1, "patches_v": 1, "control_points": net}


def high_degree(source, draft):
    """One Bezier patch of degrees 4 to 7."""
    net = random_net(source, draft, source.randint(5, 8), source.randint(5, 8))
    return {"type": "bezier-patches", "patches": [net]}


def clamped_knots(count):
    """The knots of a cubic spline with `count` control points."""
    return [0] * 3 + list(range(count - 2)) + [count - 3] * 3


def nurbs(source, draft):
    """A rational bicubic spline with weights from 0.8 to 1.25."""
    count_u, count_v = source.randint(5, 9), source.randint(5, 9)
    net = random_net(source, draft, count_u, count_v)
    weights = [[round(drawn(source, 0.8, 1.25), DECIMALS) for _ in range(count_u)] for _ in range(count_v)]
    return {"type": "nurbs", "degree_u": 3, "degree_v": 3, "knots_u": clamped_knots(count_u),
            "knots_v": clamped_knots(count_v), "control_points": net, "weights": weights}


def height_grid(draft, step, height):
    """A grid of heights with lines about `step` mm apart."""
    x, y = (spaced(side, max(6, ceil(side / step) + 1)) for side in (draft.width, draft.depth))
    points = graph(x, y, lambda i, j: height(x[i], y[j]))
    return {"type": "height-grid", "x": [p[0] for p in points[0]], "y": [row[0][1] for row in points],
            "z": [[p[2] for p in row] for row in points]}


def anisotropic(source, draft):
    """Waves in one direction, at a random angle to the parameter lines."""
    angle, phase = radians(source.uniform(0, 180)), source.uniform(0, 2 * pi)
    wave = source.uniform(0.4, 1.2) * max(draft.width, draft.depth)
    size = draft.curvature * (wave / (2 * pi))**2
    return height_grid(draft, wave / 16, lambda x, y: size * cos(
        2 * pi * (x * cos(angle) + y * sin(angle)) / wave + phase))


def grid(source, draft):
    """Four bumps and hollows."""
    bumps = [(source.uniform(0, draft.width), source.uniform(0, draft.depth),
              source.uniform(0.15, 0.4) * max(draft.width, draft.depth), source.uniform(-1, 1)) for _ in range(4)]

    def height(x, y):
        return sum(share * draft.curvature * spread**2 * exp(-((x - x0)**2 + (y - y0)**2) / (2 * spread**2))
                   for x0, y0, spread, share in bumps)
    return height_grid(draft, min(bump[2] for bump in bumps) / 4, height)


MAKERS = dict(zip(KINDS, (bezier, high_degree, nurbs, anisotropic, grid)))


def random_surface(kind, number):
    """The content of the surface file of a kind and number."""
    source = random.Random(f"surface {kind} {number}")
    draft = Draft(source)
    content = MAKERS[kind](source, draft)
    remark = (f"Generated: random surface {number} of kind {kind}, {draft.width:.1f} x {draft.depth:.1f} mm,"
              f" curvature about 1 / {1 / draft.curvature:.0f} mm.")
    return {"source": remark, **content}


def random_surfaces(each=A_KIND):
    """The first `each` surfaces of every kind, as name -> content."""
    return {f"{kind}-{number:03}": random_surface(kind, number) for kind in KINDS for number in range(each)}
