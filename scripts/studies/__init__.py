# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies whose cases are runs of the program: they write the inputs of a sweep and evaluate its results."""
