# SPDX-License-Identifier: GPL-3.0-or-later
# Cutter locations along u and along v by scallop height, as in table 1 of Kim and Choi (1995).
import endmill
import matplotlib.pyplot as plt

part = endmill.read_part("datasets/surfaces/net_rot24_1A.json")
heights = [0.2, 0.3, 0.4, 0.5]
figure, axes = plt.subplots()
for direction in ("u", "v"):
    plans = [
        endmill.plan(part, cutter="ball:15", mode="paper", direction=direction, scallop=height,
                     chord_tolerance=height) for height in heights
    ]
    axes.plot(heights, [plan["ncl"] for plan in plans], "o-", label=f"passes along {direction}")
axes.set_xlabel("scallop height and chord tolerance, mm")
axes.set_ylabel("number of cutter locations")
axes.legend()
figure.savefig("points_along_u_and_v.svg")
