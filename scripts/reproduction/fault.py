# SPDX-License-Identifier: GPL-3.0-or-later
"""The exception of this package."""


class Fault(Exception):
    """A wrong file of an experiment or a failed command; the text states which one and why."""
