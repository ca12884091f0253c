"""A case: what a computation needs to know, validated in full."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any

from . import _core
from ._input import listed, mapping, text
from ._input import path as file_path
from ._text import block, plain
from .arrays import Body, Potential
from .errors import InputError


class Case:
    """A case, as a case file writes it. It never changes.

    ::

        Case.read("disc.toml")
        Case({"body": {"J": [1.0, 1.7, 0.6]}, "potential": {...}, "motion": {...}})
        Case(body={"J": [1.0, 1.7, 0.6]}, potential={...}, motion={"branch": "i", "nu": 0.5})

    Values may be NumPy's; formulas may be SymPy expressions. Raises InputError with every fault,
    with the program's text.
    """

    __slots__ = ("_inner",)
    _inner: _core.Case

    def __init__(self, keys: Mapping[str, Any] | None = None, /, **tables: Any) -> None:
        given = {} if keys is None else mapping(keys, "Case")
        object.__setattr__(self, "_inner", _core.Case.of({**given, **tables}))

    @classmethod
    def read(cls, path: str | os.PathLike[str], overrides: Iterable[str] | None = None) -> Case:
        """The case of a TOML file; overrides: as after ``--set``, ["motion.nu=0.3"]; None: none."""
        given = [] if overrides is None else listed(overrides, "overrides")
        words = [text(each, "overrides") for each in given]
        return cls._holding(_core.Case.read(file_path(path, "Case"), words))

    @classmethod
    def _holding(cls, core: _core.Case) -> Case:
        out = cls.__new__(cls)
        object.__setattr__(out, "_inner", core)
        return out

    def set(self, key: str | Mapping[str, Any], value: Any = None) -> Case:
        """A new case with a dotted key at a value, as ``--set`` does; or several, of a dict.

        A key may end in the index of an array, from 0: ``case.set("body.J.1", 2.0)``.
        """
        values = {key: value} if isinstance(key, str) else mapping(key, "Case.set")
        return self._holding(
            self._inner.with_values({text(key, "Case.set"): each for key, each in values.items()})
        )

    def to_dict(self) -> dict[str, Any]:
        """The keys as written, with what was set since."""
        return self._inner.keys()

    def __getitem__(self, key: str) -> Any:
        """The value at a dotted key, as written: ``case["motion.nu"]``; else KeyError."""
        found: Any = self.to_dict()
        for part in text(key, "Case").split("."):
            try:
                if isinstance(found, list) and not (part.isascii() and part.isdecimal()):
                    raise IndexError(part)
                found = found[int(part)] if isinstance(found, list) else found[part]
            except (KeyError, IndexError, TypeError, ValueError):
                raise KeyError(key) from None
        return found

    def __contains__(self, key: object) -> bool:
        """Whether there is a value at a dotted key: ``"motion.nu" in case``."""
        if not isinstance(key, str):
            return False
        try:
            self[key]
        except KeyError:
            return False
        return True

    # Of tables or of values? to_dict() has both.
    __iter__ = None

    @property
    def title(self) -> str:
        """Empty where the case has none."""
        return self._inner.title

    @property
    def body(self) -> Body:
        """Its body."""
        return _core.body_of_case(self._inner)

    @property
    def potential(self) -> Potential:
        """Its elastic potential, for functions on arrays. ``InputError`` where the body has gravity or a
        held volume, which these do not take."""
        case = self.to_dict()
        if "gravity" in case or "volume" in case["body"]:
            raise InputError("a body with gravity or a held volume is not its elastic potential alone")
        return Potential(case["potential"])

    def check(self) -> str:
        """What ``stationary check`` prints: the model, what will be computed, and what will not."""
        return plain(self._inner.check())

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"a case never changes; case.set(...) returns a new one ({name})")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a case never changes ({name})")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and self._inner.state() == other._inner.state()

    def __hash__(self) -> int:
        return hash(_hashable(self._inner.state()))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, self._inner.state()

    def __repr__(self) -> str:
        return self.check()

    def _repr_html_(self) -> str:
        return block(repr(self))


def _hashable(state: Any) -> Any:
    """Equal for states that are equal: 1 and 1.0, 0.0 and -0.0, whatever the order of keys."""
    if isinstance(state, dict):
        return frozenset((key, _hashable(each)) for key, each in state.items())
    return tuple(map(_hashable, state)) if isinstance(state, (list, tuple)) else state


def _restored(keys: dict[str, Any], name: str, overrides: dict[str, str]) -> Case:
    return Case._holding(_core.Case.restored(keys, name, overrides))
