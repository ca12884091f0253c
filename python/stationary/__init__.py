"""Stationary ellipsoids (relative equilibria) of an affinely-rigid body.

What the program ``stationary`` computes of a case, from Python, with the same answers, messages and
files::

    import stationary

    case = stationary.Case.read("cases/fold.toml")
    family = stationary.follow(case)          # or solve, atlas, map, curve, study, sensitivity
    family.table["xi"]                        # a NumPy structured array, columns as in the CSV
    family.events                             # the located events, as in the metadata
    family.to_pandas(); family.plot(); family.write("fold.csv")

and the library below it, on arrays: ``Body``, ``Potential``, ``sweep``, ``solve_batch``,
``spectrum``, ``certify`` and ``search``. Units are the user's own: inertia J in mass times length
squared, nu in reciprocal time, potentials in units of energy; stretches are numbers.

Ctrl-C interrupts every computation. Threads may call everything side by side.
"""

from ._core import instructions, version as __version__
from .arrays import (
    Body,
    Certificates,
    Potential,
    Solutions,
    Stability,
    Status,
    certify,
    search,
    solve_batch,
    spectrum,
    sweep,
)
from .case import Case
from .commands import atlas, curve, follow, map, sensitivity, solve, study
from .errors import Error, InputError, NotFound, NumericalError
from .potentials import Model, Models, models
from .result import Result

__all__ = [
    "Body",
    "Case",
    "Certificates",
    "Error",
    "InputError",
    "Model",
    "Models",
    "NotFound",
    "NumericalError",
    "Potential",
    "Result",
    "Solutions",
    "Stability",
    "Status",
    "__version__",
    "atlas",
    "certify",
    "curve",
    "follow",
    "instructions",
    "map",
    "models",
    "search",
    "sensitivity",
    "solve",
    "solve_batch",
    "spectrum",
    "study",
    "sweep",
]
