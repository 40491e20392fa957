# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of random offset curves, scaled to a ball of 10 mm radius, as polyline files.

A block has a family, a number of points on each curve, a number, and its own seed. Its curves are drawn from the
same distributions as the profiles of datasets/offset-curves/random-families.json. Each curve lies in a plane of its
own, so that one run of `endmill trim --polyline` trims them one by one.
"""
from dataclasses import dataclass

from generation.profile_families import Uniform, convex_curve, wavy_curve

RADIUS = 10  # mm, of the ball to which all curves are scaled
FAMILIES = {"wavy": wavy_curve, "convex": convex_curve}
POINTS = (41, 101, 401, 1601)
BLOCKS_A_SEED = 10_000  # blocks of one family and number of points
DECIMALS = 9  # of a coordinate in mm; rounding hides the last bits of the mathematical library


@dataclass(frozen=True)
class Block:
    """Random curves of one family with `points` points each."""

    family: str
    points: int
    number: int

    @property
    def name(self):
        return f"{self.family}-{self.points}-{self.number:03}"

    @property
    def seed(self):
        """No two blocks share a seed, and none has a seed of the dataset's families, 7 and 11."""
        place = list(FAMILIES).index(self.family) * len(POINTS) + POINTS.index(self.points)
        return 100 + BLOCKS_A_SEED * place + self.number


def scaled(points, radius):
    """Points for a ball of `radius`, scaled to the ball of RADIUS."""
    factor = RADIUS / radius
    return [(round(s * factor, DECIMALS), round(z * factor, DECIMALS)) for s, z in points]


def curves(block, count):
    """The first `count` curves of a block. They do not depend on `count`."""
    uniform = Uniform(block.seed)
    for _ in range(count):
        parameters, points = FAMILIES[block.family](uniform, block.points)
        yield scaled(points, parameters[-1])


def polyline_text(all_curves):
    """The text of a polyline file with each curve in a plane of its own."""
    lines = ["plane,s_mm,z_mm"]
    for plane, points in enumerate(all_curves):
        lines += [f"{plane},{s!r},{z!r}" for s, z in points]
    return "\n".join(lines) + "\n"
