"""Formulas as SymPy expressions."""

import math
import random

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


def test_the_text_of_unevaluated_expressions():
    with sympy.evaluate(False):
        total = I1 / 2 + (-1 - sympy.log(d))
        product = sympy.Mul(-1 - sympy.log(d), 2, I1)
        assert plain(total) == "I1/2 + (-log(d) - 1)"
    assert plain(total) == "I1/2 + (-log(d) - 1)"
    assert plain(I1 / 2 + sympy.UnevaluatedExpr(-1 - sympy.log(d))) == "I1/2 + (-log(d) - 1)"
    assert plain(product) == "2*I1*(-log(d) - 1)"
    assert plain(-k / sympy.UnevaluatedExpr(c * d)) == "-k/(c*d)"
    assert plain(sympy.UnevaluatedExpr(sympy.Integer(2)) + 1) == 3.0


LEAVES = [
    d, I1, mu, sympy.pi, sympy.E, sympy.GoldenRatio, sympy.EulerGamma,
    *map(sympy.sympify, (-1, 1, 2, -0.5, 1e-5)), sympy.Rational(-1, 3), sympy.Rational(3, 2),
]  # fmt: skip
AT = {d: 1.3, I1: 2.1, mu: 0.7}


def unevaluated(rng, depth):
    """A random expression of which SymPy has simplified nothing."""
    if depth == 0 or rng.random() < 0.15:
        return rng.choice(LEAVES)
    parts = [unevaluated(rng, depth - 1) for _ in range(rng.randint(2, 3))]
    kind = rng.randrange(8)
    if kind < 3:
        return sympy.Add(*parts, evaluate=False)
    if kind < 5:
        return sympy.Mul(*parts, evaluate=False)
    if kind == 5:
        half = sympy.Rational(1, 2)
        power = rng.choice([-1, 2, -2, half, -half, -mu, parts[1]])
        return sympy.Pow(parts[0], power, evaluate=False)
    if kind == 6:
        return sympy.UnevaluatedExpr(parts[0])
    return rng.choice([sympy.exp, sympy.cos])(parts[0], evaluate=False)


def value(expression):
    """In doubles, by its tree; complex where a power is."""
    if expression in AT:
        return AT[expression]
    parts = [value(each) for each in expression.args]
    by_kind = {
        sympy.Add: lambda *each: sum(each),
        sympy.Mul: lambda *each: math.prod(each),
        sympy.Pow: pow,
        sympy.UnevaluatedExpr: lambda each: each,
        sympy.exp: math.exp,
        sympy.cos: math.cos,
    }
    return by_kind[expression.func](*parts) if parts else float(expression)


def test_the_text_means_what_the_expression_does():
    names = {str(symbol): number for symbol, number in AT.items()}
    names |= {"pi": math.pi, "e": math.e, "exp": math.exp, "cos": math.cos, "atan": math.atan}
    names["sqrt"] = lambda x: x**0.5
    rng = random.Random(7)
    compared = 0
    while compared < 400:
        expression = unevaluated(rng, 4)
        try:
            expected = value(expression)
        except (ArithmeticError, TypeError, ValueError):  # of complex numbers, and too large ones
            continue
        if not expression.free_symbols or abs(expected) > 1e9:
            continue
        text = plain(expression)
        read = eval(text.replace("^", "**"), names)
        assert read == pytest.approx(expected, rel=1e-9, abs=1e-6), text
        compared += 1


def test_the_language_reads_the_text_as_python_does():
    rng = random.Random(11)
    q = {"alpha": 0.2, "xi": 1.1, "zeta": 0.9, "rho": 1.2}
    at = {d: q["xi"] * q["zeta"] - q["alpha"] ** 2, mu: 0.7}
    at[I1] = q["xi"] ** 2 + q["zeta"] ** 2 + 2 * q["alpha"] ** 2
    for _ in range(20):
        products = [sympy.Mul(*rng.choices(LEAVES, k=3), evaluate=False) for _ in range(2)]
        part = sympy.Add(*products, evaluate=False)
        last = sympy.Mul(-d, part, -1 - mu, evaluate=False)
        expression = sympy.Add(I1, part, last, evaluate=False)
        potential = stationary.Potential(coupled={"expression": expression, "mu": 0.7})
        expected = float(expression.subs(at))
        assert potential.value(**q) == pytest.approx(expected, rel=1e-12, abs=1e-12), expression


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


def test_numbers_that_are_not_real_are_wrong_input():
    for number in (sympy.I, sympy.sqrt(-3), sympy.zoo):
        for key, given in (("expression", number), ("expression", I1 + number * d), ("c", number)):
            case = of("c/d + k*I1/2")
            case["potential"]["plane"][key] = given
            with pytest.raises(stationary.InputError, match="found SymPy's .*; expected") as error:
                stationary.Case(case)
            assert error.value.key == f"potential.plane.{key}"
    for infinite in (sympy.oo, -sympy.oo, sympy.nan):
        with pytest.raises(stationary.InputError, match="found"):
            stationary.Case(of(infinite))
        with sympy.evaluate(False), pytest.raises(stationary.InputError, match="found SymPy's"):
            stationary.Case(of(d + infinite))


def test_a_parameter_called_like_a_constant_is_not_it():
    """SymPy writes the symbol I and the imaginary unit alike."""
    parameter = sympy.Symbol("I", positive=True)
    case = of(c / d + parameter * I1)
    case["potential"]["plane"] |= {"I": 1.0}
    del case["potential"]["plane"]["k"]
    assert stationary.Case(case)["potential.plane.expression"] == "I*I1 + c/d"
    case["potential"]["plane"]["expression"] = c / d + sympy.I * I1
    with pytest.raises(stationary.InputError, match="found SymPy's I;"):
        stationary.Case(case)


def test_parameters_called_e_and_pi_are_not_the_constants():
    for constant, name in ((sympy.E, "e"), (sympy.pi, "pi")):
        potential = stationary.Potential(
            coupled={
                "expression": I1 + rho**2 - 2 * sympy.log(d * rho)
                + constant * (d * rho - 1) ** 2 + sympy.Symbol(name) * rho**2,
                name: 0.5,
            }
        )  # fmt: skip
        alone = stationary.Potential(
            coupled={"expression": I1 - 2 * sympy.log(d * rho) + rho**2 + constant * (d * rho - 1) ** 2 + k * rho**2,
                     "k": 0.5}
        )  # fmt: skip
        q = (0.0, 1.2, 1.1, 0.9)
        assert potential.value(*q) == pytest.approx(alone.value(*q), rel=1e-14)


def test_a_potential_of_the_library():
    potential = stationary.Potential(
        plane={"expression": c / d + k * I1 / 2, "c": 1.0, "k": 2.0},
        thickness={"model": "reciprocal-quadratic", "a": 1.0, "b": 3.0},
    )
    q = {"alpha": 0.0, "xi": 1.2, "zeta": 0.9, "rho": 1.0}
    expected = 1.0 / 1.08 + (1.2**2 + 0.9**2) + (1.0 + 1.5)
    assert potential.value(**q) == pytest.approx(expected)
