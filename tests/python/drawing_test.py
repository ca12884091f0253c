"""plot(): the program's diagrams in matplotlib."""

import warnings

import numpy as np
import pytest
import stationary
from conftest import CASES, SOURCES

plt = pytest.importorskip("matplotlib.pyplot")


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


def case(name):
    return stationary.Case.read(SOURCES / "cases" / f"{name}.toml")


def test_bifurcation_diagram(tmp_path):
    result = stationary.follow(case("fold"))
    upper, lower = result.plot()
    assert lower.get_xlabel().startswith("ν")
    labels = [text.get_text() for text in upper.texts]
    marked = set(result["event"].tolist()) - {"", "limit"}
    assert marked >= {each["event"] for each in result.events}
    assert {name for label in labels for name in label.split(", ")} == marked
    keys = [text.get_text() for text in upper.get_legend().get_texts()]
    assert keys[:3] == ["λ", "μ", "ϱ"] and "stable" in keys and "unstable" in keys
    dashes = {line.get_linestyle() for line in upper.lines}
    assert {"-", "--"} <= dashes
    # Every point of a line is one of the table.
    drawn = {float(x) for line in upper.lines if len(line.get_xdata()) > 2 for x in line.get_xdata()}
    assert len(drawn) > 50 and drawn <= set(result["nu1"].tolist())
    rates = {text.get_text() for text in lower.get_legend().get_texts()}
    assert rates >= {"growth rate", "frequency, Krein +"}
    upper.figure.savefig(tmp_path / "fold.svg")
    assert (tmp_path / "fold.svg").stat().st_size > 10_000


def test_draws_into_given_axes():
    result = stationary.follow(case("fold"))
    _, axes = plt.subplots()
    (drawn,) = result.plot(axes)
    assert drawn is axes and len(axes.lines) > 0
    _, pair = plt.subplots(2)
    assert list(result.plot(pair)) == list(pair)
    _, column = plt.subplots(2, 1, squeeze=False)
    assert list(result.plot(column)) == list(column[:, 0])


def test_no_panel_is_left_out():
    chart = stationary.atlas(case("circle"), checkpoints=3)
    panels = len(set(chart["branch"].tolist()))
    assert panels > 1
    for count in (1, panels + 1):
        _, axes = plt.subplots(count)
        with pytest.raises(stationary.InputError, match=f"expected {panels} or {2 * panels}"):
            chart.plot(axes)
    _, axes = plt.subplots(panels)
    assert all(len(each.lines) > 0 for each in chart.plot(axes))


def test_without_a_spectrum_one_panel():
    assert len(stationary.follow(case("fold").set("output.spectrum", False)).plot()) == 1


def test_a_map_s_classes_and_numbers():
    chart = stationary.map(case("map_biot_log").set({"map.x.count": 9, "map.y.count": 5}))
    axes = chart.plot()
    assert axes.get_yscale() == "log" and axes.get_xlabel().startswith("ν")
    image = chart.plot(show="lambda").collections[0]
    np.testing.assert_array_equal(
        image.get_array().filled(np.nan).ravel(), chart["lambda"]
    )
    with pytest.raises(stationary.InputError, match="lambada"):
        chart.plot(show="lambada")


def test_of_an_atlas_and_of_one_solution():
    chart = stationary.atlas(case("apart"), checkpoints=4)
    assert len(chart.plot()) == 2 * len(set(chart["branch"].tolist()))
    assert len(stationary.solve(case("disc")).plot()) == 2


def test_what_is_shown():
    result = stationary.follow(case("fold"))
    upper, _ = result.plot(show=["energy", "growth"])
    assert upper.get_ylabel() == "energy E, growth rate"
    (only,) = result.plot(diagram="energy-momentum")
    assert "π" in only.get_xlabel() and only.get_ylabel() == "energy E"
    drawn = {float(y) for line in only.lines if len(line.get_xdata()) > 2 for y in line.get_ydata()}
    assert len(drawn) > 50 and drawn <= set(result["energy"].tolist())
    chart = stationary.atlas(case("apart"), checkpoints=2)
    (only,) = chart.plot(diagram="energy-momentum")
    keys = [text.get_text() for text in only.get_legend().get_texts()]
    assert len([each for each in keys if "axis" in each]) == len(set(chart["branch"].tolist()))
    assert len(result.plot(sheets=[1], branches=["i"])) == 2
    wrong = [
        {"show": "lambada"}, {"show": ["xi"] * 4}, {"sheets": [7]}, {"branches": ["iv"]},
        {"diagram": "momentum"},
    ]
    for each in wrong:
        with pytest.raises(stationary.InputError):
            result.plot(**each)


FOLLOWED = [path for path in CASES if "[continuation]" in path.read_text()]


@pytest.mark.parametrize("path", FOLLOWED, ids=lambda path: path.stem)
def test_every_legend_is_in_its_figure(path):
    """A name far beyond the edge, such as of an escape, once left the axes no place."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        result = stationary.follow(stationary.Case.read(path).set("continuation.tolerance", 1e-5))
    for diagram in ("energy-momentum", "parameter"):
        axes = result.plot(diagram=diagram)
        figure = axes[0].figure
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            figure.draw_without_rendering()
        for each in axes:
            low, high = each.get_xlim()
            assert all(low <= text.xy[0] <= high for text in each.texts)
            legend = each.get_legend().get_window_extent()
            assert 0.0 <= legend.x0 < legend.x1 <= figure.bbox.x1
            assert 0.0 <= legend.y0 < legend.y1 <= figure.bbox.y1


def test_curves_of_events_over_a_map():
    base = case("circle").set(
        {
            "curve": {"event": "fold-nu", "parameters": ["nu", "potential.plane.mu"],
                      "from": [0.0, 0.5], "to": [2.5, 3.0], "tolerance": 1e-6},
            "map": {"x": {"parameter": "nu", "from": 0.0, "to": 2.5, "count": 7},
                    "y": {"parameter": "potential.plane.mu", "from": 0.5, "to": 3.0, "count": 5}},
        }
    )
    curves = stationary.curve(base)
    axes = curves.plot()
    assert [text.get_text() for text in axes.get_legend().get_texts()][0] == "fold-nu"
    np.testing.assert_array_equal(axes.lines[0].get_xdata(), curves["nu"][curves["curve"] == 1])
    chart = stationary.map(base).plot()
    assert curves.plot(chart) is chart and len(chart.lines) == len(axes.lines)
    with pytest.raises(stationary.InputError, match="curve"):
        curves.plot(show="xi")
