"""A table that was computed, with all that is known beside its rows."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._input import listed, text
from ._input import path as file_path
from ._text import block, plain
from .case import Case
from .errors import InputError

if TYPE_CHECKING:
    import pandas
    import xarray


class Result:
    """What a computation of a case found. Its ``repr`` is the program's summary.

    ``result["xi"]`` is a column, ``len(result)`` the number of rows.
    """

    def __init__(self, computed: _core.Computed, case: Case | _core.Keys) -> None:
        self._computed = computed
        self._given = case

    @cached_property
    def case(self) -> Case:
        """The case it was computed of; InputError where a study's is none without a row's values."""
        given = self._given
        return given if isinstance(given, Case) else Case._holding(given.case())

    @cached_property
    def table(self) -> npt.NDArray[np.void]:
        """The rows: a structured array, read-only, shape (rows,), columns as in the CSV.

        Numbers are float64, NaN where nothing was computed; words are strings, empty there.
        ``sheet`` and ``point`` are int64, but float64 of a study and of a sensitivity, whose rows
        may lack them.
        """
        return self._computed.table

    @cached_property
    def metadata(self) -> dict[str, Any]:
        """What the program writes as x.meta.json beside a table."""
        out: dict[str, Any] = json.loads(self._computed.metadata)
        return out

    @property
    def events(self) -> list[dict[str, Any]]:
        """The events, located or not: {"event", "sheet", "point", "parameter", "bracket", ...}."""
        return list(self.metadata["events"])

    @property
    def segments(self) -> list[dict[str, Any]]:
        """The pieces of one class: {"sheet", "segment", "class", "from", "to", "ranges", ...}."""
        return list(self.metadata["segments"])

    @property
    def summary(self) -> str:
        """What the program prints for a person."""
        return plain(self._computed.summary)

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the table, and x.meta.json beside it, the same bytes as the program.

        HDF5 for .h5 and .hdf5, else CSV; "-": CSV to the standard output, and no metadata. Raises InputError where the path cannot be written or
        would replace the case file, OSError where the disk is full.
        """
        self._computed.write(file_path(path, "write"))

    def to_pandas(self) -> pandas.DataFrame:
        """The table's values as a frame: missing words are NaN too.

        They are those that ``pandas.read_csv(path, float_precision="round_trip")`` reads of the
        CSV, in the types of ``table``; read_csv guesses types from the texts.
        """
        import pandas

        columns = {}
        for name in self.table.dtype.names or ():
            column = self.table[name]
            if column.dtype.kind == "U":
                words = column.astype(object)
                words[column == ""] = np.nan
                columns[name] = words
            else:
                columns[name] = column
        return pandas.DataFrame(columns)

    def to_xarray(self) -> xarray.Dataset:
        """A map's table over its parameters, which are the coordinates; dimensions (y, x).

        Columns and coordinates carry their units, the coordinates the rest of the case's numbers
        too. Raises InputError where the table is not a whole map's.
        """
        from ._xarray import dataset

        return dataset(self)

    def plot(
        self,
        ax: Any = None,
        *,
        show: str | Sequence[str] | None = None,
        diagram: str = "parameter",
        sheets: Iterable[int | str] = (),
        branches: Iterable[str] = (),
    ) -> Any:
        """Draws with matplotlib what ``stationary plot`` draws with gnuplot, and returns the axes.

        A bifurcation diagram has two for each panel (an atlas has a panel a branch), stretches above and,
        where there is a spectrum, rates below: an array of them. ax: as many axes to draw into, or one a
        panel, without the rates. show: up to three columns instead of the stretches; diagram:
        "energy-momentum" for the energy against the size of the momentum; only these sheets, only these
        branches, where they are named.

        A map over two parameters has one, with the column ``show``, and so have curves of events,
        which may be drawn into a map's: ``curves.plot(chart.plot())``.

        Raises InputError where the table has no such column, sheet or branch.
        """
        from .plot import draw

        if show is None or isinstance(show, str):
            show = [] if show is None else [show]
        columns = [text(each, "show") for each in listed(show, "show")]
        numbers = [str(each) for each in listed(sheets, "sheets")]
        names = [text(each, "branches") for each in listed(branches, "branches")]
        return draw(self, ax, columns, diagram, numbers, names)

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        """A column; KeyError where there is none of that name."""
        names = self.table.dtype.names or ()
        if name not in names:
            raise KeyError(f"no column {name!r}; there are {', '.join(names)}")
        return self.table[name]

    def __reduce__(self) -> tuple[Any, ...]:
        return Result, (self._computed, self._given)

    def __iter__(self) -> Iterator[np.void]:
        """The rows."""
        return iter(self.table)

    def __len__(self) -> int:
        return len(self.table)

    def __repr__(self) -> str:
        return self.summary or f"{len(self)} rows"

    def _repr_html_(self) -> str:
        return block(repr(self))
