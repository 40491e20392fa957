# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the Python package share."""
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def datasets():
    return ROOT / "datasets"


@pytest.fixture
def folded_curve():
    """A smooth curve with one loop: s + sin(3 s) turns back twice."""
    t = np.linspace(0, 10, 400)
    return np.column_stack([t + 2.5 * np.sin(2 * t) / 2, np.cos(2 * t)])


def net(heights):
    """A net of control points, (3 m + 1, 3 n + 1, 3), 10 mm apart, with these heights."""
    heights = np.asarray(heights, dtype=float)
    y, x = np.mgrid[0:heights.shape[0], 0:heights.shape[1]] * 10.0
    return np.stack([x, y, heights], axis=-1)
