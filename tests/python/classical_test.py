"""The figures of docs/pictures/classical.py: the shipped table is of today, and its borders are events of families."""

import csv
import importlib.util
import math
import os

import pytest

import stationary

SOURCES = os.environ["STATIONARY_SOURCES"]


def script():
    spec = importlib.util.spec_from_file_location("classical", os.path.join(SOURCES, "docs/pictures/classical.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def shipped():
    with open(os.path.join(SOURCES, "results/riemann.csv"), encoding="utf-8") as file:
        return [(float(row["b_over_a"]), float(row["c_over_a"]), row["below"], row["above"]) for row in csv.DictReader(file)]


@pytest.mark.parametrize("b", [0.2, 0.6])
def test_the_shipped_table_is_of_today(b):
    found = script().column(b)
    kept = [row[1:] for row in shipped() if row[0] == b]
    assert [each[1:] for each in found] == [each[1:] for each in kept]
    for (at, _, _), (meant, _, _) in zip(found, kept):
        assert at == pytest.approx(meant, rel=1e-8)


@pytest.mark.parametrize("b", [0.5, 0.8])
def test_borders_of_class_are_tilts_of_the_family_of_one_s3(b):
    classical = script()
    borders = [row for row in shipped() if row[0] == b and "none" not in row[2:]]
    assert len(borders) == 2
    for _, c, _, _ in borders:
        motion = classical.figure(b, c)["motion"]
        lambda_, mu, rho = classical.stretches(b, c)
        squares, product = lambda_**2 + mu**2, 2.0 * lambda_ * mu
        s3 = squares * motion["omega"] + product * motion["theta_dot"]
        p_theta = squares * motion["theta_dot"] + product * motion["omega"]
        family = stationary.follow(
            {
                **classical.figure(b, c),
                "motion": {"branch": "two-polar", "s3": s3, "p_theta": p_theta},
                "continuation": {"parameter": "motion.p_theta", "from": p_theta - 0.02 * s3, "to": p_theta + 0.02 * s3},
            }
        )
        tilts = family.table[family.table["event"] == "tilt"]
        nearest = min(
            max(abs(row["mu"] / row["lambda"] / b - 1.0), abs(row["rho"] / row["lambda"] / c - 1.0)) for row in tilts
        )
        assert nearest < 1e-7


def test_classical_points_are_the_published_ones():
    rows = script().spin_and_eccentricity(os.path.join(SOURCES, "results/maclaurin.csv"))
    points = {event: (e, spin) for e, spin, event in rows}
    assert points["ellipse"] == pytest.approx((0.8126700106117429, 0.3742296747861956), rel=1e-12)
    assert points["fold-nu"] == pytest.approx((0.9299556854562330, 0.4493314121239139), rel=1e-7)
    assert points["hamiltonian-hopf"] == pytest.approx((0.9528867020342539, 0.4402198952964824), rel=1e-10)


def test_integral_of_the_closed_form():
    """R_D at equal arguments, and of a pair: R_D(0, 2, 1) is in every table."""
    classical = script()
    assert classical.carlson_d(2.0, 2.0, 2.0) == pytest.approx(2.0**-1.5, rel=1e-14)
    assert classical.carlson_d(0.0, 2.0, 1.0) == pytest.approx(1.7972103521033883, rel=1e-13)
    assert math.isclose(classical.carlson_d(2.0, 3.0, 4.0), 0.16510527294261053, rel_tol=1e-13)
