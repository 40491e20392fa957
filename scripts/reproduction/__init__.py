# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the experiments, holds them to their earlier results and shows published beside computed."""
