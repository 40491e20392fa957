# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the benchmarks of a working tree, alone or in comparison with another revision."""
