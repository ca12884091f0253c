"""pandas and xarray."""

import numpy as np
import pytest
import stationary
from conftest import SOURCES

pandas = pytest.importorskip("pandas")
xarray = pytest.importorskip("xarray")


@pytest.mark.parametrize("name", ["fold", "two_polar", "oblique", "circle"])
def test_frame_is_as_pandas_reads_the_file(name, tmp_path):
    result = stationary.follow(SOURCES / "cases" / f"{name}.toml")
    path = tmp_path / "table.csv"
    result.write(path)
    read = pandas.read_csv(path, float_precision="round_trip")
    frame = result.to_pandas()
    pandas.testing.assert_frame_equal(frame, read, check_dtype=False, check_exact=True)
    for name in frame:
        guessed, own = read[name].dtype, frame[name].dtype
        assert own == (object if result.table.dtype[name].kind == "U" else result.table.dtype[name])
        if guessed != own:  # as docs/python.md says
            assert (own, guessed) == (np.float64, np.int64) or read[name].isna().all(), name


@pytest.fixture(scope="module")
def chart():
    case = stationary.Case.read(SOURCES / "cases" / "map_biot_log.toml")
    return stationary.map(case.set({"map.x.count": 9, "map.y.count": 5}))


def test_dataset_has_the_grid(chart):
    found = chart.to_xarray()
    assert found.sizes == {"body.J.1": 5, "nu": 9}
    np.testing.assert_array_equal(found["nu"], np.linspace(0.0, 1.5, 9))
    np.testing.assert_allclose(found["body.J.1"], np.geomspace(0.3, 3.0, 5), rtol=1e-15)
    for k, row in enumerate(chart.table):
        cell = found.isel({"body.J.1": k // 9, "nu": k % 9})
        assert cell["nu"] == row["nu"] and cell["body.J.1"] == row["body.J.1"]
        assert cell["class"] == row["class"] and cell["status"] == row["status"]
        np.testing.assert_array_equal(cell["xi"], row["xi"])


def test_dataset_has_units_and_the_other_numbers(chart):
    found = chart.to_xarray()
    assert found["nu"].attrs["units"] == found["growth"].attrs["units"] == "1/T"
    assert found["body.J.1"].attrs["units"] == "M L^2"
    assert found["energy"].attrs["units"] == "M L^2/T^2"
    assert float(found.coords["body.J.0"]) == 1.0
    assert float(found.coords["potential.plane.lambda"]) == 0.6
    assert found.attrs["title"] == chart.case.title


def test_dataset_of_one_parameter(disc):
    disc["map"] = {"x": {"parameter": "nu", "from": 0.0, "to": 0.9, "count": 4}}
    found = stationary.map(disc).to_xarray()
    assert found["xi"].dims == ("nu",)


def test_dataset_of_ratios(disc):
    disc["map"] = {
        "x": {"parameter": "nu/body.J.0", "from": 0.1, "to": 0.4, "count": 2},
        "y": {"parameter": "body.J.1/body.J.0", "from": 1.5, "to": 1.8, "count": 2},
    }
    found = stationary.map(disc).to_xarray()
    assert "nu" not in found.coords and "body.J.1" not in found.coords
    assert float(found.coords["body.J.0"]) == 1.0
    assert found["body.J.1/body.J.0"].attrs["units"] == "1"
    assert "units" not in found["nu/body.J.0"].attrs


def test_dataset_has_volume_and_gravity():
    case = stationary.Case.read(SOURCES / "cases" / "elastic_sphere.toml")
    axis = {"parameter": "nu", "from": 0.1, "to": 0.3, "count": 2}
    found = stationary.map(case.set({"map.x": axis})).to_xarray()
    assert float(found.coords["body.volume"]) == 1.0
    assert found.coords["gravity.g"] > 0.0


def test_only_maps_are_datasets():
    with pytest.raises(ValueError, match="map"):
        stationary.solve(SOURCES / "cases" / "disc.toml").to_xarray()


def test_nothing_is_imported_before_it_is_asked_for():
    import subprocess
    import sys

    heavy = "pandas, xarray, matplotlib, sympy"
    code = (
        "import sys, stationary; "
        f"print([name for name in '{heavy}'.split(', ') if name in sys.modules])"
    )
    assert subprocess.check_output([sys.executable, "-c", code], text=True).strip() == "[]"
