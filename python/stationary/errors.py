"""What goes wrong, with the program's own text."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .result import Result


class Error(Exception):
    """Of all errors that this package raises by itself."""


class InputError(Error, ValueError):
    """The input is wrong; found before anything is computed. The program would exit with 2.

    ``key`` is dotted, ``line`` and ``column`` count from 1; what does not apply is None.
    """

    key: str | None = None
    file: str | None = None
    line: int | None = None
    column: int | None = None
    option: str | None = None
    found: str | None = None
    allowed: str | None = None
    remedy: str | None = None


class _WithResult(Error):
    """An outcome that may leave a table nevertheless."""

    def __init__(self, text: str, result: Result | None = None) -> None:
        super().__init__(text)
        #: The table that the program would write all the same, or None.
        self.result = result


class NotFound(_WithResult):
    """No stationary ellipsoid exists or was found; the text says which, and why. Exit code 3."""


class NumericalError(_WithResult, ArithmeticError):
    """A numerical failure; the text says where. Exit code 4."""
