# SPDX-License-Identifier: GPL-3.0-or-later
"""The exceptions of endmill. Each is also one of Python's own."""


class Error(RuntimeError):
    """Base of all exceptions of endmill.

    code: a stable word, such as "E_JSON". file and place: of the input with the fault, or empty.
    """

    def __init__(self, message: str, code: str = "", file: str = "", place: str = "") -> None:
        super().__init__(message)
        self.code = code
        self.file = file
        self.place = place


class DomainError(Error, ValueError):
    """An argument is outside its domain, or an option is wrong."""


class FormatError(Error, ValueError):
    """An input file is missing, unreadable or malformed."""


class GeometryError(Error, ArithmeticError):
    """The input is sound, and the geometry does not allow what is asked."""


class OutputError(Error, OSError):
    """A result could not be written."""


class LimitError(Error, MemoryError):
    """A limit of memory, time or points was reached."""
