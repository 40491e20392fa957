# SPDX-License-Identifier: GPL-3.0-or-later
# The cutting action coefficient I1 by the slopes of pick feed and feed, as in fig. 3 of Park and
# Maeng: depth of one radius, pick feed of half a radius.
import endmill
import matplotlib.pyplot as plt
import numpy as np

mu = np.linspace(-60, 60, 121)
feed_slope = np.array([-60, -30, 0, 30, 60])
found = endmill.cutting_coefficients(mu[:, None], feed_slope, 0.5, 1.0)  # (121, 5, 8)
plt.plot(mu, found[:, :, 0], label=[f"slope of the feed {a} deg" for a in feed_slope])
plt.xlabel("slope of the pick feed, deg")
plt.ylabel("I1")
plt.legend()
plt.savefig("coefficient_curves.svg")
