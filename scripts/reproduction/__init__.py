# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the experiments, compares them with expected.csv, and shows published beside computed numbers."""
