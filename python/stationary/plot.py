"""Drawings of results with matplotlib: what the program draws with gnuplot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from .result import Result

# The line says the class, in whatever colour: width, dashes.
_LINES: dict[str | None, tuple[float, Any]] = {
    "stable": (2.4, "-"),
    "elliptic": (1.0, "-"),
    "unstable": (1.4, (0, (6, 3))),
    "oscillatory": (1.4, (0, (7, 2, 1.5, 2))),
    "marginal": (1.4, (0, (1, 2))),
    None: (1.6, "-"),
}
# Markers of events, and whether they are filled.
_EVENTS: dict[str, tuple[str, bool]] = {
    "fold-nu": ("o", True),
    "fold-momentum": ("o", False),
    "tilt": ("s", True),
    "ellipse": ("D", True),
    "shear": ("D", False),
    "oblique": ("s", False),
    "krein-pass": ("v", False),
    "hamiltonian-hopf": ("^", True),
    "inertia-exchange": ("p", False),
    "unexplained": ("*", True),
    "collapse": ("v", True),
    "escape": ("^", False),
}
_CLASS_COLOURS = ("#24507a", "#7fb2d6", "#c2410c", "#efb366", "#111111")
_SYMBOLS = {"nu": "ν", "xi": "ξ", "zeta": "ζ", "rho": "ϱ", "lambda": "λ", "mu": "μ"}


def draw(result: Result, ax: Any, show: str | None) -> Any:
    axes = result.metadata.get("case", {}).get("map", {})
    if result.metadata.get("command") == "map" and "y" in axes:
        return _map(result._computed.map_diagram(show), result, ax)
    if show is not None:
        raise ValueError("show: a column of a map over two parameters")
    return _diagram(result._computed.diagram(), result, ax)


def _diagram(found: dict[str, Any], result: Result, ax: Any) -> Any:
    import matplotlib.pyplot as plt

    rates = "growth" in found
    if ax is None:
        _, made = plt.subplots(
            2 if rates else 1,
            sharex=True,
            squeeze=False,
            figsize=(8, 6),
            gridspec_kw={"height_ratios": [3, 2] if rates else [1]},
            layout="constrained",
        )
        panels = made[:, 0]
        panels[0].set_title(result.case.title)
    else:
        panels = np.atleast_1d(np.asarray(ax, dtype=object))
    _stretches(found, panels[0])
    if rates and len(panels) > 1:
        _rates(found, panels[1])
    panels[-1].set_xlabel(_SYMBOLS.get(found["parameter"], found["parameter"]))
    panels[0].set_xlim(*found["range"])
    return panels


def _stretches(found: dict[str, Any], ax: Any) -> None:
    from matplotlib.lines import Line2D

    at = found["at"]
    used: set[str | None] = set()
    for colour, values in found["stretches"].values():
        for verdict, points in found["stretch_lines"]:
            width, dashes = _LINES[verdict]
            used.add(verdict)
            marker = "." if len(points) == 1 else None
            ax.plot(at[points], values[points], color=colour, lw=width, ls=dashes, marker=marker)
        for name, point in found["events"]:
            marker, filled = _EVENTS.get(name, ("x", True))
            ax.plot(
                at[point], values[point], marker, color=colour, mfc=colour if filled else "white"
            )
    _name_events(found, ax)
    keys = [Line2D([], [], color=c, lw=2, label=name) for name, (c, _) in found["stretches"].items()]
    keys += [
        Line2D([], [], color="#404040", lw=_LINES[verdict][0], ls=_LINES[verdict][1], label=verdict)
        for verdict in _LINES
        if verdict in used and verdict is not None
    ]
    ax.legend(handles=keys, loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    ax.set_ylabel("stretches")
    if found["logarithmic"]:
        ax.set_yscale("log")


def _name_events(found: dict[str, Any], ax: Any) -> None:
    """Along the top edge, once each place."""
    places: dict[float, list[str]] = {}
    for name, point in found["events"]:
        names = places.setdefault(float(found["at"][point]), [])
        if name not in names:
            names.append(name)
    for place, names in places.items():
        ax.axvline(place, color="#9ca3af", lw=0.6, zorder=0)
        ax.annotate(
            ", ".join(names),
            (place, 1.0),
            xycoords=("data", "axes fraction"),
            xytext=(0, 3),
            textcoords="offset points",
            rotation=40,
            fontsize="small",
        )


def _rates(found: dict[str, Any], ax: Any) -> None:
    at = found["at"]
    for k, (_, points) in enumerate(found["spectrum_lines"]):
        for each in found["frequencies"]:
            ax.plot(at[points], each[points], color=found["frequency_colour"], lw=1.0)
        ax.plot(
            at[points],
            found["growth"][points],
            color=found["growth_colour"],
            lw=2.4,
            label="growth rate" if k == 0 else None,
        )
    ax.plot([], [], color=found["frequency_colour"], lw=1.0, label="frequencies")
    ax.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    ax.set_ylabel("rates")


def _map(found: dict[str, Any], result: Result, ax: Any) -> Any:
    import matplotlib.pyplot as plt
    from matplotlib.colors import BoundaryNorm, ListedColormap

    if ax is None:
        figure, ax = plt.subplots(figsize=(8, 6), layout="constrained")
        ax.set_title(result.case.title)
    figure = ax.figure
    ma: Any = np.ma
    values = ma.masked_invalid(found["values"])
    x, y = found["x"], found["y"]
    if found["quantity"] == "class":
        names = found["classes"]
        norm = BoundaryNorm(np.arange(len(names) + 1) - 0.5, len(names))
        image = ax.pcolormesh(
            x["values"], y["values"], values, cmap=ListedColormap(_CLASS_COLOURS), norm=norm,
            shading="nearest",
        )
        bar = figure.colorbar(image, ax=ax, ticks=range(len(names)))
        bar.ax.set_yticklabels(names)
    else:
        image = ax.pcolormesh(x["values"], y["values"], values, shading="nearest")
        figure.colorbar(image, ax=ax, label=_SYMBOLS.get(found["quantity"], found["quantity"]))
    for axis, letter in ((x, "x"), (y, "y")):
        getattr(ax, f"set_{letter}label")(_SYMBOLS.get(axis["parameter"], axis["parameter"]))
        if axis["log"]:
            getattr(ax, f"set_{letter}scale")("log")
    return ax
