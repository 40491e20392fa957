# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights of closed formulas on grids."""
from math import cos, exp, pi

# Rounding makes the files independent of the mathematical library.
DECIMALS = 9


def lines(low, high, intervals):
    """Equidistant grid lines."""
    return [low + (high - low) * k / intervals for k in range(intervals + 1)]


def gaussian_bump(x, y):
    return 20 * exp(-(x * x + y * y) / 450)


def wavy(x, y):
    return 3 * cos(2 * pi * x / 80) * cos(2 * pi * y / 60)


def ball_end_test_surface(x, y):
    a, b = x / 40, y / 40
    return 40 * a * b * (a * a - b * b) / (a * a + b * b + 0.25)


def grid(source, formula, x, y):
    """The content of a file."""
    heights = [[round(formula(a, b), DECIMALS) + 0.0 for a in x] for b in y]  # + 0: no -0
    return {"source": source, "type": "height-grid", "x": x, "y": y, "z": heights}


def height_grids():
    """The files of height grids, as name -> content."""
    return {
        "gaussian-bump": grid(
            "Generated: z = 20 exp(-(x^2 + y^2) / 450) in mm, every 5 mm from -45 to 45 both ways.",
            gaussian_bump, lines(-45, 45, 18), lines(-45, 45, 18)),
        "wavy": grid(
            "Generated: z = 3 cos(2 pi x / 80) cos(2 pi y / 60) in mm, every 7.5 mm of x from -60"
            " to 60 and every 5 mm of y from -45 to 45; z_xx = z_yy = 0 on the border.",
            wavy, lines(-60, 60, 16), lines(-45, 45, 18)),
        "ball-end-test-surface": grid(
            "Generated: the test surface of the ball-end milling paper, z = 40 a b (a^2 - b^2) /"
            " (a^2 + b^2 + 0.25) mm with a = x / 40, b = y / 40 (40 mm a unit is our reading),"
            " 16 intervals from -60 to 60 along x, 12 from -40 to 40 along y.",
            ball_end_test_surface, lines(-60, 60, 16), lines(-40, 40, 12)),
    }
