"""Wrong input of every kind raises InputError with the program's text; outcomes raise theirs."""

import math

import numpy as np
import pytest
import stationary
from conftest import SOURCES, run_program
from stationary import Case, InputError

GOOD = (SOURCES / "cases" / "disc.toml").read_text()

# Text of a case file, what is replaced in it, the key and the line that are found.
WRONG = {
    "misspelt key": ("nu = 0.5", "nuu = 0.5"),
    "text for a number": ("nu = 0.5", 'nu = "fast"'),
    "not finite": ("nu = 0.5", "nu = inf"),
    "no such branch": ('branch = "i"', 'branch = "iv"'),
    "no such model": ('model = "reciprocal-determinant"', 'model = "reciprocal-determinat"'),
    "coefficient outside": ("c = 1.0", "c = -1.0"),
    "inertia": ("J = [1.0, 1.7, 0.6]", "J = [1.0, 0.0, 0.6]"),
    "too few numbers": ("J = [1.0, 1.7, 0.6]", "J = [1.0, 1.7]"),
    "empty range": ("to = 1.05", "to = 0.0"),
    "no TOML": ("[motion]", "[motion"),
    "missing table": ("[motion]", "[motions]"),
    "formula": (
        '{ model = "reciprocal-determinant", c = 1.0, k = 2.0 }',
        '{ expression = "c*I1 + foo(d)", c = 1.0 }',
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_text_of_the_program(name, tmp_path):
    before, after = WRONG[name]
    assert before in GOOD
    path = tmp_path / "case.toml"
    path.write_text(GOOD.replace(before, after, 1))
    code, _, text = run_program("solve", path)
    assert code == 2
    with pytest.raises(InputError) as error:
        Case.read(path)
    assert f"stationary: {error.value}\n" == text
    assert isinstance(error.value, ValueError)
    assert error.value.file == str(path)
    line = next(k for k, each in enumerate(path.read_text().splitlines(), 1) if after in each)
    if name != "missing table":
        assert error.value.line == line
    assert str(error.value).startswith(f"{path}:{error.value.line}:{error.value.column}: ")


def test_parts_of_the_message(disc):
    disc["motion"]["nuu"] = disc["motion"].pop("nu")
    with pytest.raises(InputError) as error:
        Case(disc)
    assert error.value.key == "motion.nuu"
    assert error.value.remedy == 'did you mean "nu"?'
    assert error.value.line is None
    assert str(error.value).startswith("Case: motion.nuu: found ")


@pytest.mark.parametrize(
    "value", [None, object(), {1, 2}, b"bytes", 1j, lambda: 0, 2**70, [None]], ids=lambda v: str(type(v))
)
def test_values_that_no_case_has(disc, value):
    disc["motion"]["nu"] = value
    with pytest.raises(InputError) as error:
        Case(disc)
    assert error.value.key.startswith("motion.nu")
    with pytest.raises(InputError):
        Case.read(SOURCES / "cases" / "disc.toml").set("motion.nu", value)


def test_keys_that_no_case_has(disc):
    with pytest.raises(InputError):
        Case({**disc, "motion": {1: 2}})
    with pytest.raises(InputError, match="no keys"):
        Case()
    case = Case(disc)
    for key, value in (("motion.nuu", 1.0), ("motion..nu", 1.0), ("", 1.0), ("body.J.3", 1.0)):
        with pytest.raises(InputError):
            case.set(key, value)
    with pytest.raises(InputError) as error:
        case.set("motion.nu", math.nan)
    assert error.value.option == "--set motion.nu=nan"
    nested = []
    for _ in range(2000):
        nested = [nested]
    with pytest.raises(InputError, match="nests"):
        Case({**disc, "title": nested})


def test_text_of_a_set(disc):
    path = SOURCES / "cases" / "disc.toml"
    _, _, text = run_program("solve", path, "--set", 'motion.nu="fast"')
    with pytest.raises(InputError) as error:
        Case.read(path).set("motion.nu", "fast")
    assert f"stationary: {error.value}\n" == text


def test_no_such_file(tmp_path):
    _, _, text = run_program("solve", tmp_path / "none.toml")
    with pytest.raises(InputError) as error:
        Case.read(tmp_path / "none.toml")
    assert f"stationary: {error.value}\n" == text


def test_what_a_command_needs(disc):
    case = Case({key: value for key, value in disc.items() if key != "continuation"})
    for call in (stationary.follow, stationary.atlas, stationary.map):
        with pytest.raises(InputError, match="found no such key"):
            call(case)
    with pytest.raises(InputError, match="threads"):
        stationary.solve(case, threads=0)
    with pytest.raises(InputError, match="checkpoints"):
        stationary.atlas(disc, checkpoints=0)
    with pytest.raises(InputError, match="row"):
        stationary.follow(disc, row="nowhere.csv")


def test_no_case_at_all():
    for what in (3, None, [1.0], b"cases"):
        for call in (stationary.solve, lambda what: stationary.study(what, {"motion.nu": [0.1]})):
            with pytest.raises(InputError, match="a Case, a dict or a path"):
                call(what)


def test_not_found():
    path = SOURCES / "cases" / "too_fast.toml"
    code, _, text = run_program("solve", path)
    assert code == 3
    with pytest.raises(stationary.NotFound) as error:
        stationary.solve(path)
    assert f"stationary: {error.value}\n" == text
    assert len(error.value.result) == 0
    assert not isinstance(error.value, ValueError)


def test_a_warning_is_one(disc):
    disc["solve"] = {"all": True, "start": [0.0, 1.0, 1.0, 1.0]}
    with pytest.warns(RuntimeWarning, match="solve.start is not used"):
        stationary.solve(disc)


def test_a_warning_before_an_error_is_one():
    case = Case.read(SOURCES / "cases" / "too_fast.toml").set("solve", {"all": True, "start": [0.0, 1.0, 1.0, 1.0]})
    with pytest.warns(RuntimeWarning, match="solve.start is not used"):
        with pytest.raises(stationary.NotFound):
            stationary.solve(case)


def test_of_the_library(disc):
    body, potential = Case(disc).body, Case(disc).potential
    with pytest.raises(InputError, match="J1 > 0"):
        stationary.Body(-1.0, 1.0, 1.0)
    with pytest.raises(InputError, match="did you mean"):
        stationary.Potential(plane={"model": "henky", "mu": 1.0, "lambda": 1.0})
    with pytest.raises(InputError, match="branch"):
        stationary.sweep(body, potential, "iv", [0.0])
    with pytest.raises(InputError):
        stationary.sweep(body, potential, "i", [math.nan])
    with pytest.raises(InputError, match="did you mean"):
        stationary.solve_batch(body, potential, "i", [0.1], {"body.K.1": [1.0]})
    with pytest.raises(InputError, match="values"):
        stationary.solve_batch(
            body, potential, "i", [0.1], {"body.J.1": [1.0, 2.0], "body.J.2": [1.0]}
        )
    with pytest.raises(InputError):
        stationary.solve_batch(body, potential, "i", [0.1], {"body.J.1": [1.0, -2.0]})
    with pytest.raises(InputError, match="spectrum"):
        stationary.solve_batch(body, potential, "i", [0.1], spectrum="some")
    with pytest.raises(InputError, match="stretch"):
        stationary.search(body, potential, "i", [0.1], box=(1.0, 0.5))
    with pytest.raises(InputError, match="three numbers"):
        stationary.Body("1", 1.0, 1.0)
    with pytest.raises(InputError, match="expected numbers"):
        stationary.sweep(body, potential, "i", ["fast"])
    with pytest.raises(InputError, match="expected 4 numbers"):
        stationary.sweep(body, potential, "i", [0.1], start=(1.0, 2.0))
    with pytest.raises(InputError, match="expected 2 numbers"):
        stationary.search(body, potential, "i", [0.1], box=1.0)
    with pytest.raises(InputError, match="a Potential"):
        stationary.sweep(body, body, "i", [0.1])
    with pytest.raises(InputError, match="a Body"):
        stationary.sweep(potential, body, "i", [0.1])
    with pytest.raises(InputError, match="branch"):
        stationary.sweep(body, potential, 1, [0.1])
    for threads in (0, 1025, 2.5, "two", 2**70):
        with pytest.raises(InputError, match="threads"):
            stationary.certify(body, potential, "i", records(), threads=threads)
    with pytest.raises(InputError, match="plane"):
        stationary.Potential(plane=3)
    with pytest.raises(InputError, match="no field"):
        stationary.spectrum(body, potential, "i", stationary.sweep(body, potential, "i", [0.1])[["nu"]])


def records(nu=0.1, xi=1.0):
    return np.array([(nu, xi, 1.0, 1.0)], [(name, float) for name in ("nu", "xi", "zeta", "rho")])


# What is no input at all, by the words of the message.
NONSENSE = {
    "row: found": lambda case: stationary.follow(case, row=3),
    "row: found an empty name": lambda case: stationary.follow(case, row=""),
    "Case: found": lambda case: Case.read(3),
    "overrides: found": lambda case: Case.read(SOURCES / "cases" / "disc.toml", [3]),
    "overrides: found 'motion.nu=0.3'; expected a list": lambda case: Case.read(
        SOURCES / "cases" / "disc.toml", "motion.nu=0.3"
    ),
    "Case: found a value of type int; expected text": lambda case: case[1],
    "complete: found 'no'; expected True or False": lambda case: stationary.atlas(
        case, complete="no"
    ),
    "events: found 'no'": lambda case: stationary.sensitivity(case, events="no"),
    "error_bound: found 'no'; expected True or False": lambda case: stationary.sweep(
        case.body, case.potential, "i", [0.1], error_bound="no"
    ),
    "error_bound: found None": lambda case: stationary.solve_batch(
        case.body, case.potential, "i", [0.1], error_bound=None
    ),
    "write: found": lambda case: stationary.solve(case).write(3),
    "Case.set: found": lambda case: case.set(3, 4),
    "Case.set: found a value of type int": lambda case: case.set({1: 2}),
    "a lone surrogate": lambda case: case.set("title", "\ud800"),
    "title: found half": lambda case: Case({**case.to_dict(), "title": "\ud800"}),
    "expected a dict": lambda case: Case([1, 2]),
    "Potential: found": lambda case: stationary.Potential(3),
    "nu: found nan; expected finite numbers": lambda case: stationary.sweep(
        case.body, case.potential, "i", [0.1, math.nan]
    ),
    "nu: found inf": lambda case: stationary.solve_batch(case.body, case.potential, "i", [math.inf]),
    "expected numbers": lambda case: stationary.sweep(case.body, case.potential, "i", [10**400]),
    "datetime64[D]'); expected numbers": lambda case: stationary.sweep(
        case.body, case.potential, "i", np.array(["2026-01-01"], "datetime64[D]")
    ),
    "found an anisotropic one; expected an isotropic one": lambda case: stationary.sweep(
        case.body,
        case.set("potential.fibre", {"k": 0.4, "degrees": 30.0}).potential,
        "i",
        [0.1],
    ),
    "models: found a value of type int; expected text": lambda case: stationary.models()[3],
    "S: found alpha = 0, xi = -2, zeta = 1, rho = 1; expected xi > 0": lambda case: case.potential.value(
        0.0, [1.0, -2.0], 1.0, 1.0
    ),
    "show: found columns beside the energy-momentum diagram": lambda case: stationary.follow(
        case
    ).plot(diagram="energy-momentum", show="xi"),
    "alpha: found 'a'": lambda case: case.potential.value("a", 1.0, 1.0, 1.0),
    "one shape": lambda case: case.potential.value(0.0, np.ones(3), np.ones(4), 1.0),
    "parameters: found": lambda case: stationary.solve_batch(
        case.body, case.potential, "i", [0.1], [1.0]
    ),
    "spectrum: found": lambda case: stationary.solve_batch(
        case.body, case.potential, "i", [0.1], spectrum=3
    ),
    "a structured array": lambda case: stationary.spectrum(case.body, case.potential, "i", [1.0]),
    "xi > 0": lambda case: stationary.spectrum(case.body, case.potential, "i", records(xi=-1.0)),
    "points": lambda case: stationary.certify(case.body, case.potential, "i", records(xi=math.nan)),
    "a finite nu": lambda case: stationary.certify(
        case.body, case.potential, "i", records(nu=math.nan)
    ),
    'no numbers in the field "nu"': lambda case: stationary.spectrum(
        case.body, case.potential, "i",
        np.array([("a", 1.0, 1.0, 1.0)], [("nu", "U1"), ("xi", float), ("zeta", float), ("rho", float)]),
    ),
    "show: found": lambda case: stationary.solve(case).plot(show=3),
    "do: found": lambda case: stationary.study(case, {"motion.nu": [0.1]}, 3),
    "table: found": lambda case: stationary.study(case, {"_x": ["\ud800"]}),
}


@pytest.mark.parametrize("words", NONSENSE)
def test_nonsense_is_wrong_input(words, disc):
    with pytest.raises(InputError) as error:
        NONSENSE[words](Case(disc))
    assert words in str(error.value)
