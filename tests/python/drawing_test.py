"""plot(): the program's diagrams in matplotlib."""

import numpy as np
import pytest
import stationary
from conftest import SOURCES

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
    with pytest.raises(ValueError, match="map"):
        stationary.solve(case("disc")).plot(show="xi")
