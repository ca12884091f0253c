"""A table that was computed, with all that is known beside its rows."""

from __future__ import annotations

import html
import json
import os
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core
from .case import Case

if TYPE_CHECKING:
    import pandas
    import xarray


class Result:
    """What a computation of a case found. Its ``repr`` is the program's summary.

    ``result["xi"]`` is a column, ``len(result)`` the number of rows.
    """

    def __init__(self, computed: _core.Computed, case: Case) -> None:
        self._computed = computed
        self._case = case

    @property
    def case(self) -> Case:
        """The case it was computed of."""
        return self._case

    @cached_property
    def table(self) -> npt.NDArray[np.void]:
        """The rows: a structured array, read-only, shape (rows,), columns as in the CSV.

        Numbers are float64, NaN where nothing was computed; ``sheet`` and ``point`` int64; words
        are strings, empty where nothing was computed.
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
        return self._computed.summary

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the table, and x.meta.json beside it, the same bytes as the program.

        HDF5 for .h5 and .hdf5, else CSV. Raises InputError where the path cannot be written or
        would replace the case file.
        """
        self._computed.write(os.fspath(path))

    def to_pandas(self) -> pandas.DataFrame:
        """The table as ``pandas.read_csv`` reads the file: missing words are NaN too."""
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
        too. Raises ValueError where the table is not a whole map's.
        """
        from ._xarray import dataset

        return dataset(self)

    def plot(self, ax: Any = None, *, show: str | None = None) -> Any:
        """Draws with matplotlib what ``stationary plot`` draws with gnuplot, and returns the axes.

        A bifurcation diagram has two, stretches above and, where there is a spectrum, rates below:
        an array of them; ax: one or two axes to draw into. A map over two parameters has one, with
        the column ``show``.
        """
        from .plot import draw

        return draw(self, ax, show)

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        return self.table[name]

    def __len__(self) -> int:
        return len(self.table)

    def __repr__(self) -> str:
        return (self.summary or f"{len(self)} rows").rstrip("\n")

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(repr(self))}</pre>"
