"""What the program's commands compute of a case."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from typing import Any, Union

from . import _core
from .case import Case
from .errors import NotFound, NumericalError
from .result import Result

CaseLike = Union[Case, Mapping[str, Any], str, "os.PathLike[str]"]

# The program's exit codes.
_DONE, _NO_EQUILIBRIUM = 0, 3


def _case(case: CaseLike) -> Case:
    if isinstance(case, Case):
        return case
    if isinstance(case, Mapping):
        return Case(case)
    return Case.read(case)


def _finished(computed: _core.Computed, case: Case, keep: bool = False) -> Result:
    """Its result. What the program says on standard error is a warning, or the error."""
    result = Result(computed, case) if computed.complete else None
    lines = computed.lines
    if computed.code != _DONE and not (keep and result is not None):
        error = NotFound if computed.code == _NO_EQUILIBRIUM else NumericalError
        raise error(lines[-1] if lines else "nothing was computed", result)
    for line in lines:
        warnings.warn(line, RuntimeWarning, stacklevel=3)
    assert result is not None
    return result


def solve(case: CaseLike, *, threads: int | None = 1) -> Result:
    """The stationary ellipsoid(s) of the case at its nu and, if asked, the spectrum.

    case: a Case, a dict, or a case file's path. threads: None for all processors.

    Raises InputError, NotFound where none exists or was found, NumericalError.
    """
    case = _case(case)
    return _finished(_core.solve(case._inner, threads), case)


def follow(case: CaseLike, *, row: str | None = None, threads: int | None = 1) -> Result:
    """The case's family followed in its parameter, with stability and every event located.

    ``stationary continue``. row: "TABLE:N", "TABLE:EVENT" or "TABLE:EVENT:K" to go on from, as
    after ``--from``.

    Raises InputError, NotFound where there is no motion to start from, NumericalError where the
    family cannot be followed to an end; the table so far is the error's ``result`` then.
    """
    case = _case(case)
    return _finished(_core.follow(case._inner, row or "", threads), case)


def atlas(
    case: CaseLike, *, checkpoints: int | None = None, threads: int | None = None
) -> Result:
    """Every sheet of every family over the case's range of nu, connected to rest or not.

    checkpoints: how many values of nu are searched exhaustively; None as the program's.

    Raises InputError, NumericalError.
    """
    case = _case(case)
    return _finished(_core.atlas(case._inner, checkpoints, threads), case)


def map(case: CaseLike, *, threads: int | None = None) -> Result:
    """Every cell of the case's grid over one or two parameters, x running fastest.

    A cell without a solution is a row whose ``status`` says so; where the program would complain of
    them, there is a RuntimeWarning. Raises InputError.
    """
    case = _case(case)
    return _finished(_core.map(case._inner, threads), case, keep=True)
