# SPDX-License-Identifier: GPL-3.0-or-later
"""Manual page and bash completion of the program, both made from its helps."""
