"""The library below the case: bodies, potentials, and many motions at once, in NumPy's arrays."""

from __future__ import annotations

import copy
import enum
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import Body as Body
from ._input import flag, mapping, numbers, spins, text, thread_count, type_name
from .errors import InputError, NotFound, NumericalError

_NOT_EQUILIBRIUM = 3  # the program's exit code


class Status(enum.IntEnum):
    """The field ``status`` of records."""

    NOT_RUN = 0
    SOLVED = 1
    #: Shown not to exist.
    NONE_EXISTS = 2
    #: Searched for without success, which is no statement about existence.
    NOT_FOUND = 3
    #: A continuum of solutions.
    NOT_ISOLATED = 4
    FAILED = 5
    INTERRUPTED = 6


class Stability(enum.IntEnum):
    """The field ``class`` of records, as the column of that name."""

    NOT_COMPUTED = -1
    STABLE = 0
    ELLIPTIC = 1
    UNSTABLE = 2
    OSCILLATORY = 3
    MARGINAL = 4


class Potential:
    """A potential V(S), written as under ``[potential]`` of a case file.

    ::

        Potential(plane={"model": "reciprocal-determinant", "c": 1.0, "k": 2.0},
                  thickness={"model": "reciprocal-quadratic", "a": 1.0, "b": 3.0})
        Potential(coupled={"expression": "mu/2*(I1 - 2*log(d*rho))", "mu": 1.0})
        Potential({"plane": {...}, "thickness": {...}})

    An expression may be SymPy's. Raises InputError with the program's text.
    """

    __slots__ = ("_inner", "_models")
    _inner: _core.Potential
    _models: dict[str, Any]

    def __init__(self, keys: Mapping[str, Any] | None = None, /, **models: Any) -> None:
        given = {} if keys is None else mapping(keys, "Potential")
        # Copied to the bottom: another process makes it anew of these, whatever the caller's are by then.
        self._models = copy.deepcopy({**given, **models})
        self._inner = _core.Potential(self._models)

    def __reduce__(self) -> tuple[Any, ...]:
        return Potential, (self._models,)

    @property
    def isotropic(self) -> bool:
        """Whether V is a function of the principal stretches alone."""
        return self._inner.isotropic

    @property
    def separable(self) -> bool:
        """Whether V is a sum of a planar part and one of the thickness."""
        return self._inner.separable

    @property
    def coefficients(self) -> dict[str, dict[str, float]]:
        """Of each model, {"plane": {"c": 1.0, "k": 2.0}, ...}."""
        return self._inner.coefficients

    @property
    def formulas(self) -> dict[str, str]:
        """Of each model."""
        return self._inner.formulas

    @property
    def facts(self) -> list[str]:
        """What was found out about formulas, a sentence each."""
        return self._inner.facts

    def value(
        self, alpha: npt.ArrayLike, xi: npt.ArrayLike, zeta: npt.ArrayLike, rho: npt.ArrayLike
    ) -> Any:
        """V at positive definite stretches; the arguments are broadcast.

        NaN where the formula is not defined. Raises InputError where S is not positive definite.
        """
        names = ("alpha", "xi", "zeta", "rho")
        S = [numbers(each, name) for each, name in zip((alpha, xi, zeta, rho), names)]
        try:
            np.broadcast_shapes(*(each.shape for each in S))
        except ValueError:
            shapes = ", ".join(str(each.shape) for each in S)
            raise InputError(f"S: found arrays of shapes {shapes}; expected one shape") from None
        out = self._inner.value(
            *(np.require(each, requirements="C") for each in np.broadcast_arrays(*S))
        )
        return out if out.ndim else float(out)

    def __repr__(self) -> str:
        return "\n".join(
            f"{slot}: {formula}  ({', '.join(f'{k} = {v:g}' for k, v in numbers.items())})"
            for (slot, formula), numbers in zip(
                self.formulas.items(), self.coefficients.values()
            )
        )


def _model(body: Any, potential: Any, branch: Any) -> tuple[Body, _core.Potential, str]:
    for name, value, kind in (("body", body, Body), ("potential", potential, Potential)):
        if not isinstance(value, kind):
            raise InputError(f"{name}: found {type_name(value)}; expected a {kind.__name__}")
    return body, potential._inner, text(branch, "branch")


def _points(points: Any) -> npt.NDArray[np.void]:
    if not isinstance(points, np.ndarray) or points.dtype.names is None:
        raise InputError(
            f"points: found {type_name(points)}; expected a structured array with nu, xi, zeta and rho, "
            "as sweep() returns it"
        )
    return points


def sweep(
    body: Body,
    potential: Potential,
    branch: str,
    nu: npt.ArrayLike,
    *,
    start: npt.ArrayLike | None = None,
    error_bound: bool = True,
) -> npt.NDArray[np.void]:
    """One family at many nu, one after the other; each solve starts from the last ones.

    potential: an isotropic one; solve_batch takes others too. branch: "i", "ii" or "iii". nu: in the
    order in which they are to be solved, along the branch's axis, in reciprocal time. start: (alpha, xi, zeta, rho) near the solution at the first nu; None:
    the solution connected to rest. error_bound: False leaves it NaN and spares its work.

    Returns records of nu's shape: ``nu, xi, zeta, rho, error_bound, steps, status``. A sweep stays
    on the sheet that it begins on; where that ends, points are Status.NOT_FOUND.

    Raises InputError, and NotFound or NumericalError where there is no solution at the first nu.
    C++: Sweep, solver/batch/sweep.hpp.
    """
    model = _model(body, potential, branch)
    if not potential.isotropic:
        raise InputError("potential: found an anisotropic one; expected an isotropic one; solve_batch takes others")
    out, code, text = _core.sweep(
        *model,
        spins(nu),
        None if start is None else numbers(start, "start", 4),
        flag(error_bound, "error_bound"),
    )
    if code:
        raise (NotFound if code == _NOT_EQUILIBRIUM else NumericalError)(text)
    return out


def solve_batch(
    body: Body,
    potential: Potential,
    branch: str,
    nu: npt.ArrayLike,
    parameters: Mapping[str, npt.ArrayLike] | None = None,
    *,
    spectrum: str | None = None,
    error_bound: bool = True,
    threads: int | None = None,
) -> Any:
    """Many bodies and materials, each at many nu, on the sheet of its rest state; in SIMD lanes.

    nu: shape (n,), in any order. parameters: by dotted key ("body.J.0", "potential.plane.c"), the
    values of each lane, shape (lanes,); what is not named is body's and potential's.

    Returns records of shape (lanes, n): ``alpha, xi, zeta, rho, error_bound, status``; with spectrum
    = "class" or "modes" a pair of these and the records of spectrum(), ``growth`` and modes only
    with "modes".

    Raises InputError. C++: solve_batch and cell_spectra, solver/batch, solver/batch_spectrum.
    """
    varied = {} if parameters is None else mapping(parameters, "parameters")
    cells, spectra = _core.solve_batch(
        *_model(body, potential, branch),
        spins(nu).ravel(),
        {str(key): numbers(each, str(key)) for key, each in varied.items()},
        None if spectrum is None else text(spectrum, "spectrum"),
        flag(error_bound, "error_bound"),
        thread_count(threads),
    )
    return cells if spectrum is None else (cells, spectra)


def spectrum(
    body: Body,
    potential: Potential,
    branch: str,
    points: npt.NDArray[np.void],
    *,
    threads: int | None = None,
) -> npt.NDArray[np.void]:
    """The linearization at solved motions.

    points: records with ``nu, xi, zeta, rho`` (and ``alpha, error_bound, status`` where they are
    there), as sweep() and search() return them.

    Returns records of their shape: ``class`` (a Stability), ``negative``, ``growth``, ``modes``, and
    ``re, im, krein`` of the five modes in reciprocal time: NaN where there is none, krein 0 there and
    where the signature is not certain. What is not solved is Stability.NOT_COMPUTED. Raises
    InputError. C++: Kind::spectrum, solver/kind/kind.hpp.
    """
    return _core.spectrum(*_model(body, potential, branch), _points(points), thread_count(threads))


class Certificates(NamedTuple):
    """What certify() proves."""

    #: ``proven, class_proven, error_bound``, and where the solution lies: ``alpha, xi, zeta, rho``,
    #: each a lower and an upper bound.
    records: npt.NDArray[np.void]
    #: Why a point is not proven; empty where it is.
    reasons: list[str]
    #: Identities of a formula that the proofs take for granted; mostly none.
    assuming: list[str]


def certify(
    body: Body,
    potential: Potential,
    branch: str,
    points: npt.NDArray[np.void],
    *,
    threads: int | None = None,
) -> Certificates:
    """Proves that near each point there is exactly one motion, and its class.

    points: as of spectrum(). The proofs are for all decimals that read as the numbers given.
    Raises InputError. C++: certify, solver/proof/certify.hpp.
    """
    return Certificates(*_core.certify(*_model(body, potential, branch), _points(points), thread_count(threads)))


class Solutions(NamedTuple):
    """What search() finds."""

    #: ``index`` (of nu), ``nu, alpha, xi, zeta, rho, error_bound, residual, status, proven``.
    records: npt.NDArray[np.void]
    #: Whether at this nu they are proven to be all in the box; of nu's shape.
    complete: npt.NDArray[np.bool_]
    #: The program's words, one a nu.
    messages: list[str]


def search(
    body: Body,
    potential: Potential,
    branch: str,
    nu: npt.ArrayLike,
    *,
    box: npt.ArrayLike = (1e-3, 1e3),
    threads: int | None = None,
) -> Solutions:
    """Every motion at each nu with stretches in the box, with proof.

    Raises InputError. C++: Kind::search, solver/search/search.hpp.
    """
    return Solutions(
        *_core.search(
            *_model(body, potential, branch),
            spins(nu),
            numbers(box, "box", 2),
            thread_count(threads),
        )
    )
