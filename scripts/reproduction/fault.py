# SPDX-License-Identifier: GPL-3.0-or-later
"""The one error of this package."""


class Fault(Exception):
    """A file of an experiment, or a driver's output, is not as it must be: which one, and why."""
