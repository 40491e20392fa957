# SPDX-License-Identifier: GPL-3.0-or-later
"""Cylinder, sphere and torus as rational quadratic NURBS, exact up to rounding.

A section is a list of (across, up, weight), the control points of arcs of the unit circle. It goes from
the lower left over the top to the lower right. Its steepest normal is (±sin, cos) of the half angle. The
cosine is at least 0.28, so a tool along +z reaches the whole section.
"""
from fractions import Fraction
from math import sqrt


def one_arc(sine, cosine):
    """An arc that is symmetric about the top. Its half angle has this sine and cosine."""
    return [(-sine, cosine, 1), (0, 1 / cosine, cosine), (sine, cosine, 1)]


def two_arcs(tangent, cosine):
    """Two arcs that meet at the top. Tangent and cosine belong to half the angle of one arc."""
    end = (1 - tangent**2) / (1 + tangent**2)
    side = 2 * tangent / (1 + tangent**2)
    return [(-side, end, 1), (-tangent, 1, cosine), (0, 1, 1), (tangent, 1, cosine), (side, end, 1)]


WIDE = two_arcs(Fraction(3, 4), Fraction(4, 5))  # 2 x 73.74 degrees: sine 0.96, cosine 0.28
NARROW = one_arc(Fraction(4, 5), Fraction(3, 5))  # 2 x 53.13 degrees
AXIS_LINE = [(0, 1), (1, 1)]  # along, weight
RING = [(1, 0, 1), (1, 1, sqrt(0.5)), (0, 1, 1), (-1, 1, sqrt(0.5)), (-1, 0, 1),
        (-1, -1, sqrt(0.5)), (0, -1, 1), (1, -1, sqrt(0.5)), (1, 0, 1)]


def knots(degree, points):
    """A clamped knot vector 0, 1, 2, ... whose inner knots have the multiplicity of the degree."""
    pieces = (points - 1) // degree
    inner = [k for k in range(1, pieces) for _ in range(degree)]
    return [0] * (degree + 1) + inner + [pieces] * (degree + 1)


def nurbs(source, degree_u, net):
    """The content of a file; `net` is [v][u] of ((x, y, z), weight), quadratic along v."""
    return {
        "source": source, "type": "nurbs", "degree_u": degree_u, "degree_v": 2,
        "knots_u": knots(degree_u, len(net[0])), "knots_v": knots(2, len(net)),
        "control_points": [[[float(c) for c in point] for point, _ in row] for row in net],
        "weights": [[float(weight) for _, weight in row] for row in net],
    }


def cylinder(radius, length):
    return [[((length * along, radius * across, radius * up), w * weight)
             for along, w in AXIS_LINE] for across, up, weight in WIDE]


def sphere(radius):
    """A part of a sphere, with longitudes about the y axis along u and latitudes along v."""
    return [[((radius * distance * across, radius * y, radius * distance * up), w * weight)
             for across, up, w in NARROW] for y, distance, weight in NARROW]


def torus(ring_radius, tube_radius):
    """The top of a torus. u goes once around the z axis, v from the inside over the top to the outside."""
    net = []
    for across, up, weight in WIDE:
        distance = ring_radius + tube_radius * across
        net.append([((distance * x, distance * y, tube_radius * up), w * weight)
                    for x, y, w in RING])
    return net


def nurbs_surfaces():
    """The files of round shapes, as name -> content."""
    return {
        "cylinder": nurbs(
            "Generated: y^2 + z^2 = 20^2, z >= 5.6, x in 0 ... 60 mm; seen from +z it is convex.",
            1, cylinder(20, 60)),
        "sphere": nurbs(
            "Generated: x^2 + y^2 + z^2 = 25^2 mm^2, longitudes and latitudes about the y axis"
            " from -53.13 to 53.13 degrees (sine 4/5), so that no pole is in it.",
            2, sphere(25)),
        "torus": nurbs(
            "Generated: (sqrt(x^2 + y^2) - 40)^2 + z^2 = 15^2, z >= 4.2 mm, all around; convex"
            " outside, a saddle inside, where the largest ball cutter has a radius of 80/3 mm.",
            2, torus(40, 15)),
    }
