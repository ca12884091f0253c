"""A map as an xarray Dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import InputError

if TYPE_CHECKING:
    import xarray

    from .result import Result

# M, L and T are the user's units of mass, length and time.
_UNITS = {
    **dict.fromkeys(("alpha", "xi", "zeta", "rho", "lambda", "mu", "residual", "compatibility"), "1"),
    **dict.fromkeys(("error_bound",), "1"),
    **dict.fromkeys(("nu1", "nu2", "nu3", "growth", "omega", "theta_dot", "nu"), "1/T"),
    **dict.fromkeys((f"{part}{k}" for part in ("re", "im") for k in range(1, 6)), "1/T"),
    **dict.fromkeys(("pi1", "pi2", "pi3", "s3", "p_theta"), "M L^2/T"),
    "energy": "M L^2/T^2",
    "pressure": "M L^2/T^2",
    "body.volume": "1",
    "gravity.g": "M^(3/2) L^3/T^2",
    "angle": "rad",
}


def _unit(name: str) -> str | None:
    if name.startswith("body.J.") and "/" not in name:
        return "M L^2"
    if "/" in name:
        units = [_unit(part) for part in name.split("/")]
        return "1" if units[0] is not None and units[0] == units[1] else None
    return _UNITS.get(name.rpartition(".")[2] if name.startswith("motion.") else name)


def _described(name: str) -> dict[str, str]:
    unit = _unit(name)
    return {"units": unit} if unit else {}


def dataset(result: Result) -> xarray.Dataset:
    import xarray

    command = result.metadata["command"]
    if command != "map":
        raise InputError(f"to_xarray: found a table of {command}; expected a map's, which has a grid")
    case = result.metadata["case"]
    axes = [case["map"][axis] for axis in ("y", "x") if axis in case["map"]]
    shape = tuple(axis["count"] for axis in axes)
    names = [axis["parameter"] for axis in axes]
    if len(result) != int(np.prod(shape)):
        raise InputError(
            f"to_xarray: found {len(result)} rows; expected a map's {int(np.prod(shape))} cells"
        )
    table = result.table.reshape(shape)
    coordinates: dict[str, Any] = {}
    for k, name in enumerate(names):
        first = tuple(slice(None) if k == other else 0 for other in range(len(shape)))
        coordinates[name] = (name, table[name][first], _described(name))
    varied = {name.partition("/")[0] for name in names}
    for name, value in _numbers(case):
        if name not in varied:
            coordinates[name] = ((), value, _described(name))
    data = {
        name: (names, table[name], _described(name))
        for name in table.dtype.names or ()
        if name not in names and name != "point"
    }
    return xarray.Dataset(data, coordinates, {"title": case["title"]})


def _numbers(case: dict[str, Any]) -> list[tuple[str, float]]:
    """The case's own numbers by their dotted keys, as maps name them."""
    out = [(f"body.J.{k}", J) for k, J in enumerate(case["body"]["J"])]
    for part, key in (("body", "volume"), ("gravity", "g")):
        if key in case.get(part, {}):
            out.append((f"{part}.{key}", case[part][key]))
    out += [
        ("nu" if key == "nu" else f"motion.{key}", value)
        for key, value in case["motion"].items()
        if isinstance(value, float)
    ]
    for slot, model in case["potential"].items():
        out += [(f"potential.{slot}.{k}", v) for k, v in model.items() if isinstance(v, float)]
    return out
