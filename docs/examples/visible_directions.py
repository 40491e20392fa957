# SPDX-License-Identifier: GPL-3.0-or-later
# The share of the teapot that each direction reaches, on the sphere of directions of Kang and Suh.
import endmill
import matplotlib.pyplot as plt
import numpy as np

mesh = endmill.read_part("datasets/meshes/teapot-288.off").mesh
directions = endmill.DirectionGrid("hex:10").centres
reached = endmill.visibility(mesh, directions).accessible().mean(axis=0)
azimuth = np.degrees(np.arctan2(directions[:, 1], directions[:, 0]))
polar = np.degrees(np.arccos(directions[:, 2]))
plt.scatter(azimuth, polar, c=100 * reached, s=12)
plt.colorbar(label="facets reached, per cent")
plt.xlabel("azimuth, deg")
plt.ylabel("angle from +z, deg")
plt.gca().invert_yaxis()
plt.savefig("visible_directions.svg")
