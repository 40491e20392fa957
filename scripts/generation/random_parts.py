# SPDX-License-Identifier: GPL-3.0-or-later
"""Random closed parts with fixed seeds: (vertices, triangles), counter-clockwise seen from outside, in mm.

A part stands on the plane z = 0. The kinds differ in what hides its facets: nothing, the walls of pockets, the roof of
undercuts, or the ridges of a wheel. Outer walls have a draft angle of up to 8 degrees; a third of them are vertical.
"""
import random
from dataclasses import dataclass
from math import cos, pi, radians, sin, tan

from generation.solids import DECIMALS, ring_of_quads

KINDS = ("convex", "pocket", "undercut", "wheel", "relief")
A_KIND = 20  # parts of each kind
SECTORS = 36  # columns of a part of revolution; its blades divide it


def rounded(point):
    """A point whose coordinates hide the last bits of the mathematical library."""
    return tuple(round(c, DECIMALS) + 0.0 for c in point)  # + 0: no -0


def polar(radius, angle, z):
    return rounded((radius * cos(angle), radius * sin(angle), z))


def stack(rings):
    """The closed part between rings of equally many points each, the first at the bottom, and its two end points.

    Consecutive rings are joined. The last ring and the first one are closed by a fan about their middle.
    """
    count = len(rings[0])
    vertices = [point for ring in rings for point in ring]
    numbers = [list(range(first, first + count)) for first in range(0, len(vertices), count)]
    triangles = []
    for lower, upper in zip(numbers, numbers[1:]):
        triangles += ring_of_quads(lower, upper)
    for ring, bottom in ((numbers[0], True), (numbers[-1], False)):
        middle = len(vertices)
        vertices.append(rounded(tuple(sum(vertices[k][axis] for k in ring) / count for axis in range(3))))
        for a, b in zip(ring, ring[1:] + ring[:1]):
            triangles.append((middle, b, a) if bottom else (middle, a, b))
    return vertices, triangles


def revolved(profile, stretch=(1, 1), sectors=SECTORS, twist=0.0):
    """A part with the profile [(r, z)] from the bottom to the top, stretched along x and y; rings turn by `twist` each."""
    rings = []
    for row, (radius, z) in enumerate(profile):
        points = (polar(radius, 2 * pi * k / sectors + twist * row, z) for k in range(sectors))
        rings.append([rounded((x * stretch[0], y * stretch[1], z)) for x, y, z in points])
    return stack(rings)


def draft(source):
    """The tangent of a draft angle."""
    return source.choice((0, 1, 1)) * tan(radians(source.uniform(2, 8)))


def convex(source):
    """A dome on a disc, an ellipsoid above a cone: every facet of the side sees half of the sphere."""
    radius, height, base = source.uniform(15, 40), source.uniform(10, 40), source.uniform(2, 10)
    rows = source.randint(6, 14)
    angles = [pi / 2 * row / (rows + 0.5) for row in range(rows + 1)]
    profile = [(radius + base * draft(source), 0)] + [(radius * cos(a), base + height * sin(a)) for a in angles]
    return revolved(profile, (1, source.uniform(0.5, 1)))


def pocket(source):
    """A disc with a pocket. Its walls lean outwards by up to 20 degrees or overhang; its floor is domed or hollow."""
    radius, height = source.uniform(25, 45), source.uniform(15, 35)
    mouth, depth = radius * source.uniform(0.4, 0.8), height * source.uniform(0.3, 0.8)
    lean = mouth - max(min(depth * source.uniform(-0.2, 0.36), 0.6 * mouth), mouth - 0.9 * radius)
    floor, rows = source.uniform(-0.1, 0.1) * height, 5
    profile = [(radius + height * draft(source), 0), (radius, height), (mouth, height)]
    profile += [(mouth + (lean - mouth) * k / rows, height - depth * k / rows) for k in range(1, rows + 1)]
    profile += [(lean * (1 - k / 6), height - depth + floor * (k / 6)) for k in range(1, 6)]
    return revolved(profile, (1, source.uniform(0.6, 1)))


def undercut(source):
    """A shaft with a mushroom head: the lower side of the head faces the bottom, at a slope of 0 to 60 degrees."""
    shaft, head = source.uniform(8, 15), source.uniform(20, 35)
    low, slope = source.uniform(8, 20), source.uniform(0, 1.7)
    rim = low + slope * (head - shaft)
    crown, rows = source.uniform(5, 15), 6
    profile = [(shaft * 1.3, 0), (shaft, low / 2), (shaft, low)]
    profile += [(shaft + (head - shaft) * k / rows, low + (rim - low) * k / rows) for k in range(1, rows + 1)]
    profile += [(head * cos(pi / 2 * k / 6.5), rim + 2 + crown * sin(pi / 2 * k / 6.5)) for k in range(7)]
    return revolved(profile, (1, source.uniform(0.7, 1)))


def wheel(source):
    """A tapered hub with twisted ridges, whose flanks hide the hub beside them."""
    ridges = source.choice((4, 6, 9))
    radius, height = source.uniform(20, 35), source.uniform(15, 30)
    ridge, twist = source.uniform(0.15, 1), source.uniform(-0.12, 0.12)
    rows = 10
    rings = []
    for row in range(rows + 1):
        taper = 1 - 0.4 * row / rows
        rings.append([])
        for column in range(SECTORS):
            is_ridge = 0 < row < rows and column % (SECTORS // ridges) in (0, 1)
            across = radius * taper * (1 + ridge if is_ridge else 1)
            rings[-1].append(polar(across, 2 * pi * column / SECTORS + twist * row, height * row / rows))
    return stack(rings)


def relief(source):
    """A block with leaning or vertical sides whose top is a wavy relief."""
    steps, length, width = 14, source.uniform(40, 80), source.uniform(30, 60)
    waves = [(source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(0, 2 * pi)) for _ in range(3)]
    level, size = source.uniform(10, 20), source.uniform(1, 8)

    def height(i, j):
        return level + size * sum(cos(2 * pi * (a * i + b * j) / 7 + c) for a, b, c in waves) / 3

    top = [[rounded((length * i / steps, width * j / steps, height(i, j))) for i in range(steps + 1)]
           for j in range(steps + 1)]
    return block_under(top, draft(source))


def block_under(top, spread):
    """The closed part between a grid of points [row][column], seen from above, and the plane z = 0.

    Downwards its sides move away from the middle by `spread` mm for each mm of the lowest height.
    """
    rows, columns = len(top), len(top[0])
    vertices = [point for row in top for point in row]
    triangles = []
    for j in range(rows - 1):
        for i in range(columns - 1):
            a = j * columns + i
            triangles += [(a, a + 1, a + columns + 1), (a, a + columns + 1, a + columns)]
    rim = ([i for i in range(columns)] + [j * columns + columns - 1 for j in range(1, rows)]
           + [(rows - 1) * columns + i for i in range(columns - 2, -1, -1)]
           + [j * columns for j in range(rows - 2, 0, -1)])
    below = list(range(len(vertices), len(vertices) + len(rim)))
    length, width = vertices[-1][:2]
    outwards = spread * min(vertices[k][2] for k in rim)
    vertices += [rounded((x + outwards * (2 * x / length - 1), y + outwards * (2 * y / width - 1), 0.0))
                 for x, y, _ in (vertices[k] for k in rim)]
    triangles += ring_of_quads(below, rim)
    middle = len(vertices)
    vertices.append(rounded((length / 2, width / 2, 0)))
    triangles += [(middle, b, a) for a, b in zip(below, below[1:] + below[:1])]
    return vertices, triangles


MAKERS = dict(zip(KINDS, (convex, pocket, undercut, wheel, relief)))


@dataclass(frozen=True)
class Part:
    """A random part of a kind and number."""

    kind: str
    number: int

    @property
    def name(self):
        return f"{self.kind}-{self.number:03}"

    def solid(self):
        return MAKERS[self.kind](random.Random(f"part {self.kind} {self.number}"))


def random_parts(each=A_KIND):
    """The first `each` parts of every kind."""
    return [Part(kind, number) for kind in KINDS for number in range(each)]
