# SPDX-License-Identifier: GPL-3.0-or-later
"""Two families of random profiles, defined by datasets/offset-curves/random-families.json."""
import random
from math import cos, sin, sqrt

WAVY_PROFILES = 400
CONVEX_PROFILES = 500
CONVEX_POINTS = (41, 101, 401, 1601)


class Uniform:
    """Random numbers in [0, 1). Each takes two draws of the Mersenne Twister."""

    def __init__(self, seed):
        state = [seed]
        for i in range(1, 624):
            state.append((1812433253 * (state[-1] ^ state[-1] >> 30) + i) % 2**32)
        self.twister = random.Random()
        self.twister.setstate((3, (*state, 624), None))

    def __call__(self):
        low, high = self.twister.getrandbits(32), self.twister.getrandbits(32)
        return min((low + 4294967296.0 * high) / 18446744073709551616.0, 1 - 2**-53)


def offset_curve(profile, low, high, radius, count):
    """Positions of the centre of a ball along `profile`, a function of x for height and slope."""
    points = []
    for i in range(count):
        x = low + (high - low) * i / (count - 1)
        z, m = profile(x)
        w = sqrt(1 + m * m)
        points.append((x - radius * m / w, z + radius / w))
    return points


def wavy_curve(u, count):
    """The parameters of a wavy profile that is drawn from `u`, and its curve. The last parameter is the radius."""
    a1, a2, a3 = 0.5 * u(), 0.8 * u(), 0.5 * u()
    w1, w2, q1, q2 = 1 + 2 * u(), 2 + 3 * u(), 6 * u(), 6 * u()
    m, radius = 1.5 * (u() - 0.5), 0.3 + 1.5 * u()

    def profile(x):
        z = 0.3 * a1 * x * x + a2 * cos(w1 * x + q1) + 0.5 * a3 * cos(w2 * x + q2) + m * x
        slope = (0.6 * a1 * x - a2 * w1 * sin(w1 * x + q1)
                 - 0.5 * a3 * w2 * sin(w2 * x + q2) + m)
        return z, slope
    return [a1, a2, a3, w1, w2, q1, q2, m, radius], offset_curve(profile, -4, 4, radius, count)


def convex_parameters(u):
    """The parameters of a convex profile that is drawn from `u`. The last one is the radius."""
    a, b = 0.1 + u(), 0.05 * u()
    m, c = 3 * (u() - 0.5), 2 * (u() - 0.5)
    return [a, b, m, c, (0.5 + 2.5 * u()) / (2 * a)]


def convex_offset(parameters, count):
    """The curve of a convex profile."""
    a, b, m, c, radius = parameters

    def profile(x):
        t = x - c
        return a * t * t + b * t**4 + m * x, 2 * a * t + 4 * b * t**3 + m
    end = 4 + 2 * radius
    return offset_curve(profile, -end, end, radius, count)


def convex_curve(u, count):
    """The parameters of a convex profile that is drawn from `u`, and its curve. The last parameter is the radius."""
    parameters = convex_parameters(u)
    return parameters, convex_offset(parameters, count)


def wavy():
    """Pairs of the parameters of a profile and its curve of 401 points."""
    u = Uniform(7)
    for _ in range(WAVY_PROFILES):
        yield wavy_curve(u, 401)


def convex(points):
    """Pairs of the parameters of a profile and its curve, for one number of CONVEX_POINTS."""
    u = Uniform(11)
    for count in CONVEX_POINTS[:CONVEX_POINTS.index(points) + 1]:
        for _ in range(CONVEX_PROFILES):
            parameters = convex_parameters(u)
            if count == points:
                yield parameters, convex_offset(parameters, count)
