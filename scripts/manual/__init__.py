# SPDX-License-Identifier: GPL-3.0-or-later
"""Generates manual page and bash completion of the program from its help texts."""
