"""Drawings of results with matplotlib: what the program draws with gnuplot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import InputError

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
    "oblique": ("s", False),
    "fold-parameter": ("o", True),
    "ellipse": ("D", True),
    "ellipse-23": ("D", True),
    "ellipse-13": ("D", True),
    "shear": ("D", False),
    "krein-pass": ("v", False),
    "hamiltonian-hopf": ("v", True),
    "escape": ("^", False),
    "real-collision": ("^", True),
    "zero-momentum": ("P", False),
    "collapse": ("p", True),
    "domain": ("p", False),
}
_MOST_COLUMNS = 3
_DASHES: tuple[Any, ...] = ("-", (0, (6, 3)), (0, (1, 2)), (0, (7, 2, 1.5, 2)), (0, (3, 2)))
_SPECIAL = {"cusp": "^", "degenerate-pitchfork": "o", "double": "s", "turn": "D"}
_CLASS_COLOURS = ("#24507a", "#7fb2d6", "#c2410c", "#efb366", "#111111")


def draw(
    result: Result, ax: Any, show: list[str], diagram: str, sheets: list[str], branches: list[str]
) -> Any:
    command = result.metadata["command"]
    if diagram not in ("parameter", "energy-momentum"):
        raise InputError(
            f'diagram: found the string "{diagram}"; expected "parameter" or "energy-momentum"'
        )
    energy_momentum = diagram == "energy-momentum"
    if command == "curve" or (command == "map" and "y" in result.metadata["case"]["map"]):
        if len(show) > (command == "map") or energy_momentum or sheets or branches:
            raise InputError(
                f"plot: found a table of {command} in two parameters; expected "
                + ("one column to show and " if command == "map" else "")
                + "no other diagram, sheet or branch"
            )
        if command == "curve":
            return _event_curves(result._computed.curve_diagram(), result, ax)
        return _map(result._computed.map_diagram(show[0] if show else None), result, ax)
    if show and energy_momentum:
        raise InputError("show: found columns beside the energy-momentum diagram; expected one of these")
    if len(show) > _MOST_COLUMNS:
        raise InputError(f"show: found {len(show)} columns; expected at most {_MOST_COLUMNS}")
    return _diagram(result._computed.diagram(show, sheets, branches, energy_momentum), result, ax)


def _diagram(found: dict[str, Any], result: Result, ax: Any) -> Any:
    import matplotlib.pyplot as plt

    panels, rates = found["panels"], found["has_rates"]
    if ax is None:
        heights = ([3, 2] if rates else [3]) * len(panels)
        figure, made = plt.subplots(
            len(heights),
            squeeze=False,
            figsize=(8, 2 + 0.8 * sum(heights)),
            gridspec_kw={"height_ratios": heights},
            layout="constrained",
        )
        axes = made[:, 0]
        figure.suptitle(result.case.title)
    else:
        axes = np.atleast_1d(np.asarray(ax, dtype=object)).ravel()
        allowed = [len(panels)] + ([2 * len(panels)] if rates else [])
        if len(axes) not in allowed:
            expected = " or ".join(str(count) for count in allowed)
            raise InputError(f"ax: found {len(axes)} axes; expected {expected}, for {len(panels)} panels")
    step = 2 if rates and len(axes) == 2 * len(panels) else 1
    for k, panel in enumerate(panels):
        _curves(panel, found["series"], axes[step * k])
        axes[step * k].set_ylabel(", ".join(found["ordinates"]))
        if step == 2:
            _rates(panel, found["rate_styles"], axes[step * k + 1])
        axes[step * k + step - 1].set_xlabel(panel["abscissa"])
    return axes


def _set_axis(ax: Any, letter: str, axis: tuple[float, float, bool]) -> None:
    low, high, logarithmic = axis
    if logarithmic:
        getattr(ax, f"set_{letter}scale")("log")
    getattr(ax, f"set_{letter}lim")(low, high)


def _curves(panel: dict[str, Any], series: list[tuple[str, str]], ax: Any) -> None:
    from matplotlib.lines import Line2D

    used = set()
    for number, verdict, x, y in panel["curves"]:
        width, dashes = _LINES[verdict]
        used.add(verdict)
        dot = "." if len(x) == 1 else None
        ax.plot(x, y, color=series[number][1], lw=width, ls=dashes, marker=dot)
    for name, x, values in panel["events"]:
        marker, filled = _EVENTS.get(name, ("x", True))
        for number, y in values:
            colour = series[number][1]
            ax.plot(x, y, marker, color=colour, mfc=colour if filled else "white")
    _name_events(panel["events"], panel["x"], ax)
    keys = [Line2D([], [], color=colour, lw=2, label=name) for name, colour in series]
    keys += [
        Line2D([], [], color="#404040", lw=width, ls=dashes, label=verdict)
        for verdict, (width, dashes) in _LINES.items()
        if verdict in used and verdict is not None
    ]
    ax.legend(handles=keys, loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    ax.set_title(panel["title"], loc="left")
    _set_axis(ax, "x", panel["x"])
    _set_axis(ax, "y", panel["y"])


def _name_events(
    events: list[tuple[str, float, list[tuple[int, float]]]],
    axis: tuple[float, float, bool],
    ax: Any,
) -> None:
    """Along the top edge, each name once at a place."""
    low, high, _ = axis
    places: dict[float, list[str]] = {}
    for name, x, _ in events:
        # A name beyond the edge would be drawn all the same, and the axes shrunk to nothing for it.
        if not low <= x <= high:
            continue
        names = places.setdefault(x, [])
        if name not in names:
            names.append(name)
    for place, names in places.items():
        ax.axvline(place, color="#9ca3af", lw=0.6, ls=":", zorder=0)
        ax.annotate(
            ", ".join(names),
            (place, 1.0),
            xycoords=("data", "axes fraction"),
            xytext=(0, 3),
            textcoords="offset points",
            rotation=40,
            fontsize="small",
        )


def _rates(panel: dict[str, Any], styles: list[tuple[str, str, float]], ax: Any) -> None:
    named = set()
    for kind, x, y in panel["rates"]:
        title, colour, width = styles[kind]
        ax.plot(x, y, color=colour, lw=width, label=None if kind in named else title)
        named.add(kind)
    ax.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    ax.set_ylabel("rates")
    _set_axis(ax, "x", panel["x"])
    _set_axis(ax, "y", panel["rate"])


def _map(found: dict[str, Any], result: Result, ax: Any) -> Any:
    import matplotlib.pyplot as plt
    from matplotlib.colors import BoundaryNorm, ListedColormap

    if ax is None:
        _, ax = plt.subplots(figsize=(8, 6), layout="constrained")
        ax.set_title(result.case.title)
    ma: Any = np.ma
    values = ma.masked_invalid(found["values"])
    x, y = found["x"], found["y"]
    how: dict[str, Any] = {"shading": "nearest"}
    if found["quantity"] == "class":
        names = found["classes"]
        how["norm"] = BoundaryNorm(np.arange(len(names) + 1) - 0.5, len(names))
        how["cmap"] = ListedColormap(_CLASS_COLOURS)
    image = ax.pcolormesh(x["values"], y["values"], values, **how)
    bar = ax.figure.colorbar(image, ax=ax)
    if found["quantity"] == "class":
        bar.set_ticks(range(len(found["classes"])), labels=found["classes"])
    else:
        bar.set_label(found["name"])
    _name_axes(found, ax)
    return ax


def _name_axes(found: dict[str, Any], ax: Any) -> None:
    for letter in "xy":
        getattr(ax, f"set_{letter}label")(found[letter]["name"])
        if found[letter]["log"]:
            getattr(ax, f"set_{letter}scale")("log")


def _event_curves(found: dict[str, Any], result: Result, ax: Any) -> Any:
    """Dark on a light edge, so that a line is seen on any colour; an event a dash."""
    import matplotlib.pyplot as plt
    from matplotlib.patheffects import withStroke

    if ax is None:
        _, ax = plt.subplots(figsize=(8, 6), layout="constrained")
        ax.set_title(result.case.title)
        _name_axes(found, ax)
    edge = [withStroke(linewidth=3.6, foreground="white")]
    events: list[str] = []
    for event, x, y in found["lines"]:
        label = None if event in events else event
        events += [event] if label else []
        dashes = _DASHES[events.index(event) % len(_DASHES)]
        ax.plot(x, y, color="#111827", lw=1.6, ls=dashes, label=label, path_effects=edge)
    named: set[str] = set()
    for name, x, y in found["special"]:
        label = None if name in named else name
        named.add(name)
        ax.plot(x, y, _SPECIAL[name], color="#111827", label=label)
    ax.legend(loc="upper left", bbox_to_anchor=(0.0, -0.12), ncols=4, frameon=False)
    return ax
