"""The table that a study runs over, from Python's values."""

from __future__ import annotations

import csv
import io
import math
import os
from collections.abc import Mapping
from typing import Any

import numpy as np

from . import _core
from ._input import path, text, type_name
from .errors import InputError

# What messages and metadata call a table that is no file.
_NAME = "table"


def csv_of(table: Any) -> tuple[str, str | None]:
    """A file's path and None, or a name and the text."""
    if isinstance(table, (str, os.PathLike)):
        return path(table, _NAME), None
    columns = _columns(table)
    lengths = {len(cells) for cells in columns.values()}
    if len(lengths) > 1:
        found = ", ".join(f"{len(cells)} of {key}" for key, cells in columns.items())
        raise InputError(f"{_NAME}: found {found}; expected as many values in every column")
    out = io.StringIO()
    rows = csv.writer(out, lineterminator="\n")
    rows.writerow(columns)
    for row in zip(*columns.values()):
        rows.writerow(_cell(value, key) for key, value in zip(columns, row))
    return _NAME, text(out.getvalue(), _NAME)


def _columns(table: Any) -> dict[str, list[Any]]:
    names = getattr(getattr(table, "dtype", None), "names", None)
    if names is None and isinstance(table, Mapping):
        names = list(table)
    elif names is None and hasattr(table, "columns"):
        names = list(table.columns)
    elif names is None:
        raise InputError(
            f"{_NAME}: found {type_name(table)}; expected a path, a DataFrame, a structured array or a "
            "dict of columns"
        )
    keys = [str(name) for name in names]
    for k, key in enumerate(keys):
        # A frame's columns of one name, or names that are one as text.
        if key in keys[:k]:
            raise InputError(f'{_NAME}: found the column "{key}" twice; expected each once')
    return {key: _values(table[name], key) for key, name in zip(keys, names)}


def _values(column: Any, key: str) -> list[Any]:
    if isinstance(column, np.ndarray) and column.dtype.kind == "M":
        # Its own list of fine ones has counts of nanoseconds.
        texts = np.datetime_as_string(column).tolist()
        return ["" if missing else text for missing, text in zip(np.isnat(column), texts)]
    if hasattr(column, "tolist"):
        column = column.tolist()
    if isinstance(column, (str, bytes, Mapping)) or not hasattr(column, "__iter__"):
        raise InputError(f"{_NAME}: {key}: found {type_name(column)}; expected a column of values")
    return list(column)


def _cell(value: Any, key: str) -> str:
    if value is None or type(value).__name__ in ("NAType", "NaTType"):
        return ""
    if isinstance(value, (float, np.floating)) and math.isnan(value):
        return ""
    if isinstance(value, bytes):
        try:
            value = value.decode()
        except UnicodeDecodeError:
            raise InputError(f"{_NAME}: {key}: found {value!r}; expected text in Unicode") from None
    if isinstance(value, str):
        return value
    if key.startswith("_") and not isinstance(value, (float, np.floating)):
        return str(value)
    return _core.assigned_text(value, key)
