"""The built-in potentials."""

from __future__ import annotations

from typing import NamedTuple

from . import _core
from ._input import text
from ._text import block, plain


class Model(NamedTuple):
    """A built-in potential. Its ``str`` is what ``stationary models NAME`` prints."""

    name: str
    #: Where it stands in [potential]: "plane", "thickness", "coupled", or "fibre".
    slot: str
    formula: str
    #: Names of its coefficients.
    parameters: list[str]
    #: Inequalities on the coefficients, all required.
    domain: list[str]
    #: What is assumed of it.
    assumed: str

    def __str__(self) -> str:
        return plain(_core.model_list(self.name))

    def _repr_html_(self) -> str:
        return block(str(self))


class Models(dict[str, Model]):
    """Of every name its Model. Its ``repr`` is what ``stationary models`` prints."""

    def __missing__(self, name: str) -> Model:
        _core.model_list(text(name, "models"))  # raises InputError with the nearest name
        raise KeyError(name)

    def __repr__(self) -> str:
        return plain(_core.model_list(""))

    def _repr_html_(self) -> str:
        return block(repr(self))


def models() -> Models:
    """The built-in potentials, by name: ``stationary.models()["hencky"].parameters``.

    A name that there is not raises InputError, with the nearest one.
    """
    return Models((each[0], Model(*each)) for each in _core.models())
