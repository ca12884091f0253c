"""What the program's commands compute of a case."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from typing import Any, Union

from . import _core
from ._input import flag, path, text, thread_count, whole_number
from ._study_table import csv_of
from .case import Case
from .errors import InputError, NotFound, NumericalError
from .result import Result

CaseLike = Union[Case, Mapping[str, Any], str, "os.PathLike[str]"]

_CASES = "a Case, a dict or a path"
# The program's exit codes.
_DONE, _NO_EQUILIBRIUM = 0, 3


def _case(case: CaseLike) -> Case:
    if isinstance(case, Case):
        return case
    if isinstance(case, Mapping):
        return Case(case)
    return Case.read(path(case, "Case", _CASES))


def _keys(case: CaseLike) -> _core.Keys:
    if isinstance(case, Case):
        return _core.Keys.of_case(case._inner)
    if isinstance(case, Mapping):
        return _core.Keys.of(dict(case))
    return _core.Keys.read(path(case, "Case", _CASES))


def _row(row: str | None) -> str:
    if row == "":
        raise InputError("row: found an empty name; expected a row of a table, or None")
    return "" if row is None else text(row, "row")


def _checkpoints(asked: int | None) -> int | None:
    return whole_number(asked, "checkpoints", 1_000_000)


def _finished(
    computed: _core.Computed, case: Union[Case, _core.Keys], keep: bool = False
) -> Result:
    """Its result. What the program says on standard error is a warning, or the error."""
    result = Result(computed, case) if computed.complete else None
    lines = computed.lines
    if computed.code != _DONE and not (keep and result is not None):
        for line in lines[:-1]:
            warnings.warn(line, RuntimeWarning, stacklevel=3)
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
    return _finished(_core.solve(case._inner, thread_count(threads)), case)


def sensitivity(case: CaseLike, *, events: bool = False, threads: int | None = 1) -> Result:
    """How the motion of the case and its modes move with each number of the case: a row a number.

    ``stationary sensitivity``. events: of the events of the family of [continuation] instead. With
    ``output.uncertainty`` in the case a last row has the uncertainties that come of it.

    Raises InputError, NotFound where there is no motion, NumericalError.
    """
    case = _case(case)
    asked = flag(events, "events")
    return _finished(_core.sensitivity(case._inner, asked, thread_count(threads)), case)


def follow(case: CaseLike, *, row: str | None = None, threads: int | None = 1) -> Result:
    """The case's family followed in its parameter, with stability and every event located.

    ``stationary continue``. row: "TABLE:N", "TABLE:EVENT" or "TABLE:EVENT:K" to go on from, as
    after ``--from``.

    Raises InputError, NotFound where there is no motion to start from, NumericalError where the
    family cannot be followed to an end; the table so far is the error's ``result`` then.
    """
    case = _case(case)
    return _finished(_core.follow(case._inner, _row(row), thread_count(threads)), case)


def atlas(
    case: CaseLike,
    *,
    checkpoints: int | None = None,
    complete: bool = False,
    threads: int | None = None,
) -> Result:
    """Every sheet of every family over the case's range of nu, connected to rest or not.

    checkpoints: how many values of nu are searched exhaustively; None as the program's. complete:
    prove for every nu of the range how many sheets there are, and of which classes, not at the
    checkpoints alone; the metadata's ``completeness`` and ``classes`` have the intervals.

    Raises InputError, NotFound where there is no motion in the range, NumericalError.
    """
    case = _case(case)
    asked = flag(complete, "complete")
    return _finished(
        _core.atlas(case._inner, _checkpoints(checkpoints), asked, thread_count(threads)), case
    )


def map(case: CaseLike, *, threads: int | None = None) -> Result:
    """Every cell of the case's grid over one or two parameters, x running fastest.

    A cell without a solution is a row whose ``status`` says so; where the program would complain of
    them, there is a RuntimeWarning. Raises InputError.
    """
    case = _case(case)
    return _finished(_core.map(case._inner, thread_count(threads)), case, keep=True)


def curve(case: CaseLike, *, row: str | None = None, threads: int | None = 1) -> Result:
    """The curves of an event in two numbers of the case, by its ``[curve]``.

    row: "TABLE:N", "TABLE:EVENT" or "TABLE:EVENT:K", an event whose curve is followed; None: every
    such event of the case's family starts one.

    The table has the columns ``event, curve, point, special, branch``, both parameters under their
    keys, then the others from ``nu1`` on. Raises InputError, NotFound where the family has no such
    event, NumericalError.
    """
    case = _case(case)
    return _finished(_core.curve(case._inner, _row(row), thread_count(threads)), case)


def study(
    case: CaseLike,
    table: Any,
    do: str = "solve",
    *,
    checkpoints: int | None = None,
    threads: int | None = None,
) -> Result:
    """The case with the values of each row of a table: solved, followed or charted, in one table.

    case: need be complete only with a row's values (a dict or a path then, not a Case). table: the
    path of a CSV or HDF5 file, a pandas DataFrame, a structured array, or a dict of columns; columns
    are keys of the case ("potential.plane.mu"), or begin with "_" and are carried through; what is
    missing leaves the case's value. do: "solve", "continue" or "atlas"; checkpoints: of each atlas.

    A row that fails is a row with its ``status`` and ``message``, and there is a RuntimeWarning.
    Raises InputError where the table or the case cannot be read.
    """
    keys = _keys(case)
    over, csv = csv_of(table)
    computed = _core.study(keys, over, csv, text(do, "do"), _checkpoints(checkpoints), thread_count(threads))
    return _finished(computed, case if isinstance(case, Case) else keys, keep=True)
