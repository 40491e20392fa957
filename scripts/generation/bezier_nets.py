# SPDX-License-Identifier: GPL-3.0-or-later
"""Composite bicubic nets of polynomials of degree three or less, exact.

Control point (i, j) is the blossom of the polynomial at the knots of i and j, in rational numbers.
"""
from fractions import Fraction

S, T, S2, T2 = (1, 0), (0, 1), (2, 0), (0, 2)


def equal_parts(low, high, count):
    """`count` + 1 equidistant borders from low to high, as rational numbers."""
    return [Fraction(low) + Fraction(high - low, count) * k for k in range(count + 1)]


WIDTH, DEPTH = equal_parts(0, 200, 3), equal_parts(0, 120, 2)

POLYNOMIALS = {
    "plane": {
        "source": "Generated: z = 0 over 200 x 120 mm.",
        "breaks_s": WIDTH, "breaks_t": DEPTH,
        "x": {S: 1}, "y": {T: 1}, "z": {},
    },
    "tilted-plane": {
        "source": "Generated: z = 3 x / 4 over 200 x 120 mm; its lines along u are 250 mm long.",
        "breaks_s": WIDTH, "breaks_t": DEPTH,
        "x": {S: 1}, "y": {T: 1}, "z": {S: Fraction(3, 4)},
    },
    "sheared-plane": {
        "source": "Generated: z = 0 over a parallelogram, x = s + t / 2, y = t"
                  " for s in 0 ... 200 and t in 0 ... 120 mm.",
        "breaks_s": WIDTH, "breaks_t": DEPTH,
        "x": {S: 1, T: Fraction(1, 2)}, "y": {T: 1}, "z": {},
    },
    "saddle": {
        "source": "Generated: z = (x^2 - y^2) / 64 over -45 ... 45 mm both ways;"
                  " the largest ball cutter has a radius of 32 mm, at the origin.",
        "breaks_s": equal_parts(-45, 45, 3), "breaks_t": equal_parts(-45, 45, 3),
        "x": {S: 1}, "y": {T: 1}, "z": {S2: Fraction(1, 64), T2: Fraction(-1, 64)},
    },
    "parabolic-cylinder": {
        "source": "Generated: z = y^2 / 40 over x in 0 ... 200 and y in -60 ... 60 mm;"
                  " the largest ball cutter has a radius of 20 mm, along y = 0.",
        "breaks_s": WIDTH, "breaks_t": equal_parts(-60, 60, 2),
        "x": {S: 1}, "y": {T: 1}, "z": {T2: Fraction(1, 40)},
    },
}

# Each row has y, then z at the two borders and at the two control points between them.
VALLEY_X = (0, 60, 40, 100)
VALLEY_ROWS = ((0, 40, 20), (Fraction(100, 3), 45, 0), (Fraction(200, 3), 55, -20), (100, 60, -40))


def blossom_power(power, arguments):
    """The blossom of t^power, a symmetric trilinear form, at three arguments."""
    a, b, c = arguments
    return [Fraction(1), (a + b + c) / 3, (a * b + b * c + c * a) / 3, a * b * c][power]


def knot_triples(breaks):
    """The arguments of the blossom for the control points of a curve over `breaks`. Patches share joints."""
    triples = []
    for low, high in zip(breaks, breaks[1:]):
        triples += [(low, low, low), (low, low, high), (low, high, high)]
    return triples + [(breaks[-1],) * 3]


def coefficient(polynomial, at_s, at_t):
    """The blossom of sum c s^p t^q, given as {(p, q): c}."""
    return sum(c * blossom_power(p, at_s) * blossom_power(q, at_t)
               for (p, q), c in polynomial.items())


def net(surface):
    """Control points [v][u] of `surface`."""
    us, vs = knot_triples(surface["breaks_s"]), knot_triples(surface["breaks_t"])
    return [[[float(coefficient(surface[axis], s, t)) for axis in "xyz"] for s in us] for t in vs]


def valley_net():
    """The net of one patch that is symmetric about the plane x = 50."""
    return [[[float(x), float(y), float(z)] for x, z in zip(VALLEY_X, (edge, floor, floor, edge))]
            for y, edge, floor in VALLEY_ROWS]


def bezier_surfaces():
    """The files of Bezier nets, as name -> content."""
    files = {
        name: {
            "source": surface["source"], "type": "bezier",
            "patches_u": len(surface["breaks_s"]) - 1, "patches_v": len(surface["breaks_t"]) - 1,
            "control_points": net(surface),
        } for name, surface in POLYNOMIALS.items()
    }
    files["valley"] = {
        "source": "Generated: a valley along y whose section at x = 50 mm narrows from a bottom"
                  " radius of 30 mm at y = 0 to 6 mm at y = 100 mm.",
        "type": "bezier", "patches_u": 1, "patches_v": 1, "control_points": valley_net(),
    }
    return files
