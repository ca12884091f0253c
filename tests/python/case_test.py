"""Cases: from files, dicts and keywords; never changed."""

import copy
import pickle

import numpy as np
import pytest
import stationary
from conftest import SOURCES, run_program
from stationary import Case

DISC = SOURCES / "cases" / "disc.toml"


def test_a_file_a_dict_and_keywords_are_one_case(disc):
    from_file = stationary.solve(Case.read(DISC))
    for case in (Case(disc), Case(**disc), Case({"body": disc["body"]}, **rest(disc))):
        found = stationary.solve(case)
        assert found.table.tobytes() == from_file.table.tobytes()
        assert found.metadata["case"] == from_file.metadata["case"]


def rest(keys):
    return {key: value for key, value in keys.items() if key != "body"}


def test_commands_take_paths_and_dicts(disc):
    assert len(stationary.solve(disc)) == len(stationary.solve(str(DISC))) == 1
    assert len(stationary.solve(DISC)) == 1


def test_numpy_values(disc):
    disc["body"]["J"] = np.array([1.0, 1.7, 0.6])
    disc["motion"]["nu"] = np.float32(0.5)
    disc["output"] = {"certificate": np.bool_(True), "columns": ("xi", "certified")}
    disc["continuation"]["max_points"] = np.int64(7)
    case = Case(disc)
    assert case["body.J"] == [1.0, 1.7, 0.6]
    assert case["continuation.max_points"] == 7
    assert stationary.solve(case).table["certified"].tolist() == ["yes"]


def test_the_widest_numbers_of_numpy_are_their_doubles(disc):
    third = np.longdouble(1) / 3
    case = Case(disc)
    assert case.set("motion.nu", third)["motion.nu"] == 1 / 3
    assert case.set("motion.nu", np.array(third))["motion.nu"] == 1 / 3
    disc["body"]["J"] = np.array([1, third, 3], np.longdouble)
    disc["potential"]["plane"]["c"] = third
    case = Case(disc)
    assert case["body.J"] == [1.0, 1 / 3, 3.0] and case["potential.plane.c"] == 1 / 3
    with pytest.raises(stationary.InputError, match="found a value of type c"):
        case.set("motion.nu", np.clongdouble(1))


def test_set_returns_a_new_case(disc):
    case = Case(disc)
    other = case.set("motion.nu", 0.3)
    assert (case["motion.nu"], other["motion.nu"]) == (0.5, 0.3)
    assert case.set({"motion.nu": 0.2, "body.J.1": 1.5}).to_dict()["body"]["J"] == [1.0, 1.5, 0.6]


def test_set_takes_every_kind_of_value(disc):
    case = Case(disc)
    assert case.set("title", 'quotes " and \\ and µ\n')["title"] == 'quotes " and \\ and µ\n'
    assert case.set("solve.all", True)["solve.all"] is True
    assert case.set("potential.plane", {"model": "hencky", "mu": 1.1, "lambda": 0.8})[
        "potential.plane"
    ] == {"model": "hencky", "mu": 1.1, "lambda": 0.8}
    assert case.set("motion.nu", 1e-99)["motion.nu"] == 1e-99
    assert case.set("motion.nu", np.float64(0.1) + 0.2)["motion.nu"] == 0.1 + 0.2


def test_never_changes(disc):
    case = Case(disc)
    with pytest.raises(AttributeError):
        case.title = "another"
    with pytest.raises(AttributeError):
        del case._inner
    case.to_dict()["motion"]["nu"] = 0.1
    disc["motion"]["nu"] = 0.2
    assert case["motion.nu"] == 0.5


def test_equality_hash_and_copies(disc):
    case = Case(disc)
    assert case == Case(disc) and hash(case) == hash(Case(disc))
    assert case != case.set("motion.nu", 0.3)
    assert case != 3
    changed = Case.read(DISC).set("motion.nu", 0.3)
    for each in (pickle.loads(pickle.dumps(changed)), copy.deepcopy(changed)):
        assert each == changed
        assert stationary.solve(each).metadata["overrides"] == {
            "motion.nu": "--set motion.nu=0.3"
        }


def test_equal_cases_hash_alike(disc):
    disc["solve"] = {"start": [0.0, 1.0, 1.0, 1.0]}
    disc["body"]["J"] = [1.0, 2.0, 3.0]
    other = copy.deepcopy(disc)
    other["body"]["J"] = [1, 2, 3]
    other["solve"]["start"][0] = -0.0
    other = dict(reversed(other.items()))
    assert Case(disc) == Case(other) and len({Case(disc), Case(other)}) == 1


def test_reading_with_overrides():
    case = Case.read(DISC, ["motion.nu=0.25"])
    assert case["motion.nu"] == 0.25
    with pytest.raises(KeyError):
        case["motion.axis"]
    assert Case.read(DISC, None) == Case.read(DISC)


def test_what_is_in_a_case(disc):
    case = Case(disc)
    for key in ("motion", "motion.nu", "body.J.1"):
        assert key in case
    for key in ("motion.axis", "body.J.3", "body.J.-1", "body.J. 1", "motion.nu.0", "", 1, None):
        assert key not in case
    with pytest.raises(TypeError, match="not iterable"):
        list(case)


def test_shows_what_check_prints():
    case = Case.read(DISC)
    assert repr(case) == case.check() == run_program("check", DISC)[1].rstrip("\n")
    assert case._repr_html_().startswith("<pre>")
    assert case.title == "Thin disc, reciprocal-determinant potential"


def test_its_body_and_potential(disc):
    case = Case(disc)
    assert case.body == stationary.Body(1.0, 1.7, 0.6)
    assert case.potential.coefficients == {
        "plane": {"c": 1.0, "k": 2.0},
        "thickness": {"a": 1.0, "b": 3.0},
    }
