"""Bodies with gravity or a held volume, as any other case."""

import math

import pytest
import stationary
from conftest import SOURCES


@pytest.fixture(scope="module")
def fluid():
    return stationary.Case(
        {
            "body": {"J": [1.0, 1.0, 1.0], "volume": 1.0},
            "gravity": {"pi_G_rho": 1.0},
            "motion": {"branch": "iii", "nu": 0.3},
        }
    )


def test_a_fluid_is_solved_with_its_pressure(fluid):
    row = stationary.solve(fluid).table[0]
    # nu^2 of Maclaurin's spheroid with this eccentricity, in closed form.
    flat = row["rho"] / row["xi"]
    e = math.sqrt(1.0 - flat * flat)
    square = 2.0 * flat * (3.0 - 2.0 * e * e) * math.asin(e) / e**3 - 6.0 * flat * flat / (e * e)
    assert square == pytest.approx(0.09, abs=1e-12)
    assert row["pressure"] > 0.0
    assert math.isnan(row["re5"])


def test_its_numbers_may_be_followed(fluid):
    case = fluid.set("continuation", {"parameter": "gravity.g", "from": 3.0, "to": 5.0})
    table = stationary.follow(case).table
    assert table["gravity.g"].min() == 3.0
    assert table["gravity.g"].max() == 5.0
    # Nothing but nu^2 over g counts: with more gravity the spheroid is rounder.
    by_g = sorted(zip(table["gravity.g"], table["xi"] / table["rho"]))
    assert all(a[1] > b[1] for a, b in zip(by_g, by_g[1:]) if a[0] != b[0])


def test_its_potential_alone_is_not_the_body(fluid):
    with pytest.raises(stationary.InputError, match="gravity"):
        _ = fluid.potential


def test_wrong_input_has_the_programs_words(fluid):
    with pytest.raises(stationary.InputError, match="g or pi_G_rho"):
        fluid.set("gravity.g", 4.0)


def test_shipped_cases_are_those_of_the_program():
    assert len(stationary.follow(SOURCES / "cases" / "maclaurin.toml").events) >= 4


def test_an_axis_in_no_plane_is_found():
    case = stationary.Case.read(SOURCES / "cases" / "no_plane.toml")
    row = stationary.solve(case).table[0]
    assert row["branch"] == "tilted"
    assert min(row["nu1"], row["nu2"], row["nu3"], row["alpha"]) > 0.1
    # Biot's: W_t = 0.
    assert row["xi"] + row["zeta"] == pytest.approx(1.8, abs=1e-12)
    assert (row["xi"] * row["zeta"] - row["alpha"] ** 2) * row["rho"] == pytest.approx(1.0, abs=1e-12)


def test_fibres_stand_beside_gravity(fluid):
    plane = {"model": "biot", "mu": 1.0, "lambda": 0.6}
    case = stationary.Case(
        body={"J": [1.0, 1.7, 0.6], "volume": 1.0},
        gravity={"g": 0.5},
        potential={"plane": plane, "fibre": {"k": 0.4, "degrees": 30.0}},
        motion={"branch": "iii", "nu": 0.5},
    )
    row = stationary.solve(case).table[0]
    assert row["alpha"] != 0.0
    assert not math.isnan(row["pressure"])
    with pytest.raises(stationary.InputError, match="gravity"):
        _ = case.potential
