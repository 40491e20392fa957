# SPDX-License-Identifier: GPL-3.0-or-later
# A section of an offset before and after trimming, as in fig. 9 of Jang, Kim and Jeong, with a
# method of one's own in the comparison.
import endmill
import matplotlib.pyplot as plt
import numpy as np

s = np.linspace(-10, 10, 400)
normal = np.column_stack([-np.cos(s), np.ones_like(s)]) / np.hypot(np.cos(s), 1)[:, None]
offset = np.column_stack([s, np.sin(s)]) + 2 * normal  # of the curve z = sin s, 2 mm


def forward(curves):
    return [c[c[:, 0] >= np.maximum.accumulate(c[:, 0])] for c in curves]


methods = [*endmill.trimming_methods, forward]
for row in endmill.compare_trimming([[offset]], methods, tolerance=0.01):
    print(f"{row['method']:9} {min(row['times_ms']):.3f} ms, gouge {row['max_gouge_mm']:.3f} mm")
plt.plot(*offset.T, ":", label="offset")
for curve in endmill.trim_curves([offset], method="3").curves:
    plt.plot(*curve.T, label="method 3")
plt.legend()
plt.savefig("trimmed_section.svg")
