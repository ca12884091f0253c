"""What functions are given, as C++ takes it; InputError where it is something else."""

from __future__ import annotations

import operator
import os
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import InputError


# Of less the modes lose their digits; a case's nu is refused likewise.
_LEAST_SPIN = 1e-100


def type_name(value: Any) -> str:
    return f"a value of type {type(value).__name__}"


def text(value: Any, name: str) -> str:
    """name, here and below: what messages call it."""
    if not isinstance(value, str):
        raise InputError(f"{name}: found {type_name(value)}; expected text")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InputError(f"{name}: found {value!r}; expected text in Unicode") from None
    return value


def path(value: Any, name: str, allowed: str = "a path") -> str:
    if not isinstance(value, (str, os.PathLike)):
        raise InputError(f"{name}: found {type_name(value)}; expected {allowed}")
    return text(os.fspath(value), name)


def mapping(value: Any, name: str) -> dict[Any, Any]:
    if not isinstance(value, Mapping):
        raise InputError(f"{name}: found {type_name(value)}; expected a dict")
    return dict(value)


def listed(values: Any, name: str) -> list[Any]:
    """Not of a text's characters."""
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise InputError(f"{name}: found {values!r}; expected a list")
    return list(values)


def flag(value: Any, name: str) -> bool:
    """True or False, or what NumPy and C have for it; a text such as "no" would be true."""
    if not isinstance(value, (int, np.bool_)):
        raise InputError(f"{name}: found {value!r}; expected True or False")
    return bool(value)


def whole_number(value: Any, name: str, most: int) -> int | None:
    """From 1 to most, or None."""
    try:
        number = None if value is None else operator.index(value)
    except TypeError:
        number = 0
    if number is None or 1 <= number <= most:
        return number
    raise InputError(f"{name}: found {value!r}; expected None or a whole number from 1 to {most}")


def thread_count(asked: Any) -> int | None:
    return whole_number(asked, "threads", 1024)


def _hides(values: Any) -> bool:
    """Whether it is, or has in its list, an array of which something is masked."""
    if isinstance(values, (list, tuple)):
        return any(_hides(each) for each in values)
    return isinstance(values, np.ma.MaskedArray) and bool(np.any(values.mask))


def numbers(values: Any, name: str, count: int | None = None) -> npt.NDArray[np.float64]:
    try:
        # Dates would be counts of days, complex numbers their real parts, masked ones what they hide.
        given = np.asarray(values)
        if given.dtype.kind not in "biufO" or _hides(values):
            raise TypeError
        if given.dtype.kind == "O" and any(isinstance(each, (str, bytes)) for each in given.flat):
            raise TypeError
        out = np.asarray(values, dtype=float)
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{name}: found {values!r}; expected numbers") from None
    if count is not None and out.shape != (count,):
        raise InputError(f"{name}: found {values!r}; expected {count} numbers")
    return out


def spins(values: Any) -> npt.NDArray[np.float64]:
    """Of nu."""
    out = numbers(values, "nu")
    if not np.isfinite(out).all():
        raise InputError(f"nu: found {out[~np.isfinite(out)][0]}; expected finite numbers")
    small = (out != 0) & (np.abs(out) < _LEAST_SPIN)
    if small.any():
        raise InputError(f"nu: found {out[small][0]}; expected 0 or at least {_LEAST_SPIN} in size")
    return out
