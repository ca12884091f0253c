"""Formulas as SymPy expressions."""

import pytest
import stationary
from stationary.sympy_text import plain

sympy = pytest.importorskip("sympy")
d, rho, I1, mu, c, k, x = sympy.symbols("d rho I1 mu c k x", positive=True)


def test_the_text_of_expressions():
    assert plain(mu * (I1 - 2 - 2 * sympy.log(d)) / 2) == "mu*(I1 - 2*log(d) - 2)/2"
    assert plain(x**2 + sympy.sqrt(x) - 1 / x) in ("sqrt(x) + x^2 - 1/x", "x^2 + sqrt(x) - 1/x")
    assert plain(sympy.Abs(sympy.Symbol("y"))) == "abs(y)"
    assert plain(sympy.Max(x, c, k)).count("max(") == 2
    assert plain(sympy.E**x) == "exp(x)"
    assert plain(I1 + rho**2 < 4) == "I1 + rho^2 < 4"
    assert plain(sympy.Rational(1, 4)) == 0.25
    assert plain(sympy.true) is True


def of(expression):
    return {
        "body": {"J": [1.0, 1.7, 0.6]},
        "potential": {
            "plane": {"expression": expression, "c": 1.0, "k": 2.0},
            "thickness": {"model": "reciprocal-quadratic", "a": 1.0, "b": 3.0},
        },
        "motion": {"branch": "i", "nu": 0.5},
    }


def test_is_the_potential_that_its_text_is(disc):
    with_sympy = stationary.solve(of(c / d + k * I1 / 2))
    with_text = stationary.solve(of("c/d + k*I1/2"))
    assert with_sympy.table.tobytes() == with_text.table.tobytes()


def test_parts_conditions_and_numbers():
    J = sympy.Symbol("J")
    case = of(c / J + k * I1 / 2)
    case["potential"]["plane"]["let"] = {"J": d}
    case["potential"]["plane"]["domain"] = [I1 < 40 * k]
    case["potential"]["plane"]["c"] = sympy.Integer(1)
    case["potential"]["plane"]["k"] = sympy.Rational(2)
    found = stationary.solve(case)
    model = found.metadata["case"]["potential"]["plane"]
    assert (model["let"], model["domain"]) == ({"J": "d"}, ["I1 < 40*k"])
    assert found.table["xi"] == pytest.approx(stationary.solve(of("c/d + k*I1/2")).table["xi"])


def test_what_formulas_do_not_have_is_wrong_input():
    for expression in (sympy.besselj(0, d), sympy.I * d, sympy.Symbol("nobody") * d):
        with pytest.raises(stationary.InputError, match="expression"):
            stationary.Case(of(expression))


def test_a_potential_of_the_library():
    potential = stationary.Potential(
        plane={"expression": c / d + k * I1 / 2, "c": 1.0, "k": 2.0},
        thickness={"model": "reciprocal-quadratic", "a": 1.0, "b": 3.0},
    )
    q = {"alpha": 0.0, "xi": 1.2, "zeta": 0.9, "rho": 1.0}
    expected = 1.0 / 1.08 + (1.2**2 + 0.9**2) + (1.0 + 1.5)
    assert potential.value(**q) == pytest.approx(expected)
