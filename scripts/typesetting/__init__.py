# SPDX-License-Identifier: GPL-3.0-or-later
"""Prepares the replication paper: every number, table and figure comes from the CSV files of the experiments."""
