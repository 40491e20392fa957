# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the numbers on height grids in datasets/surfaces/README.md with their formulas."""
import json
import re
import unittest
from math import cos, exp, hypot, pi, sqrt

from fake_tree import ROOT
from readme_tables import rounds_to, table
from spline import heights

FOLDER = ROOT / "datasets/surfaces"
STATED = table(FOLDER / "README.md", "Height grids")

FORMULAS = {
    "gaussian-bump.json": lambda x, y: 20 * exp(-(x**2 + y**2) / 450),
    "wavy.json": lambda x, y: 3 * cos(2 * pi * x / 80) * cos(2 * pi * y / 60),
    "ball-end-test-surface.json": lambda x, y: (
        40 * (x / 40) * (y / 40) * ((x / 40)**2 - (y / 40)**2)
        / ((x / 40)**2 + (y / 40)**2 + 0.25)),
}


def finer(lines, parts):
    """Grid lines with each interval divided into `parts`."""
    return [a + (b - a) * k / parts for a, b in zip(lines, lines[1:]) for k in range(parts)] \
        + lines[-1:]


def greatest_bend(formula, x, y, step=1e-3):
    """The largest upward normal curvature of a graph, by central differences."""
    near = [[formula(x + i * step, y + j * step) for i in (-1, 0, 1)] for j in (-1, 0, 1)]
    p, q = (near[1][2] - near[1][0]) / (2 * step), (near[2][1] - near[0][1]) / (2 * step)
    r = (near[1][2] - 2 * near[1][1] + near[1][0]) / step**2
    t = (near[2][1] - 2 * near[1][1] + near[0][1]) / step**2
    s = (near[2][2] - near[2][0] - near[0][2] + near[0][0]) / (4 * step**2)
    w = sqrt(1 + p * p + q * q)
    mean = ((1 + q * q) * r - 2 * p * q * s + (1 + p * p) * t) / (2 * w**3)
    gauss = (r * t - s * s) / w**4
    return mean + sqrt(max(mean * mean - gauss, 0))


def least_hollow_radius(formula, x_range, y_range):
    """The largest ball radius in mm, by sampling ever closer to the tightest place."""
    (x0, x1), (y0, y1) = x_range, y_range
    step = 1.0
    places = [(x, y) for x in range(int(x0), int(x1) + 1) for y in range(int(y0), int(y1) + 1)]
    while True:
        bend, x, y = max((greatest_bend(formula, x, y), x, y) for x, y in places)
        step /= 5
        if step < 1e-3:
            return 1 / bend
        places = [(x + i * step, y + j * step) for i in range(-5, 6) for j in range(-5, 6)
                  if x0 <= x + i * step <= x1 and y0 <= y + j * step <= y1]


def area(formula, width, depth, step):
    """The area of a graph about the origin, by the midpoint rule. Its error is of order step squared."""
    total = 0
    for i in range(round(width / step)):
        for j in range(round(depth / step)):
            x, y = (i + 0.5) * step - width / 2, (j + 0.5) * step - depth / 2
            p = formula(x + step / 2, y) - formula(x - step / 2, y)
            q = formula(x, y + step / 2) - formula(x, y - step / 2)
            total += step * hypot(step, p, q)
    return total


class HeightGrids(unittest.TestCase):
    def setUp(self):
        self.grids = {name: json.loads((FOLDER / name).read_text()) for name in FORMULAS}

    def test_every_height_grid_is_described(self):
        files = {p.name for p in FOLDER.glob("*.json") if '"height-grid"' in p.read_text()}
        self.assertEqual(files, set(STATED))
        self.assertEqual(files, set(FORMULAS))

    def test_heights_are_those_of_the_formula(self):
        for name, grid in self.grids.items():
            for y, row in zip(grid["y"], grid["z"]):
                for x, z in zip(grid["x"], row):
                    self.assertAlmostEqual(z, FORMULAS[name](x, y), delta=0.6e-9)

    def test_grids_have_the_described_size(self):
        for name, grid in self.grids.items():
            sizes = "{} x {}".format(*(len(grid[axis]) - 1 for axis in "xy"))
            extent = "{:g} x {:g} mm".format(*(grid[axis][-1] - grid[axis][0] for axis in "xy"))
            self.assertEqual(STATED[name][1], f"{sizes} over {extent}")

    def test_distance_of_the_spline_from_the_formula(self):
        for name, grid in self.grids.items():
            x, y = finer(grid["x"], 16), finer(grid["y"], 16)
            spline = heights(grid["x"], grid["y"], grid["z"], x, y)
            error = max(abs(spline[j][i] - FORMULAS[name](x[i], y[j]))
                        for i in range(len(x)) for j in range(len(y)))
            self.assertTrue(rounds_to(error, STATED[name][2]), (name, error))

    def test_largest_ball_of_the_formula(self):
        for name, grid in self.grids.items():
            radius = least_hollow_radius(FORMULAS[name], *((grid[a][0], grid[a][-1]) for a in "xy"))
            self.assertTrue(rounds_to(radius, STATED[name][3]), (name, radius))
        self.assertTrue(rounds_to((60 / (2 * pi))**2 / 3, STATED["wavy.json"][3]))

    def test_area_of_the_ball_end_test_surface(self):
        name = "ball-end-test-surface.json"
        coarse, fine = (area(FORMULAS[name], 120, 80, step) for step in (1, 0.5))
        stated = re.search(r"area ([\d .]+) mm²", STATED[name][0]).group(1)
        self.assertTrue(rounds_to((4 * fine - coarse) / 3, stated), fine)


if __name__ == "__main__":
    unittest.main()
