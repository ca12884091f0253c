"""What the module writes is what the program writes, byte for byte, on every shipped case."""

import json
import os
import warnings

import pytest
import stationary
from conftest import CASES, HDF5, SOURCES, SUFFIXES, lasting, run_program, start_program


@pytest.fixture(autouse=True)
def beside_the_cases(monkeypatch):
    """So that both are given the same path."""
    monkeypatch.chdir(SOURCES)


def computed(call, case, **options):
    """The result, or the one that an error has, if any; and the error."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)
            return call(case, **options), None
    except (stationary.NotFound, stationary.NumericalError) as error:
        return error.result, error
    except stationary.InputError as error:
        return None, error


def compare(command, call, path, tmp_path, words=(), case=None, suffix=".csv", **options):
    """words: the program's options; case, options: the module's of the same."""
    theirs, ours = tmp_path / f"program{suffix}", tmp_path / f"module{suffix}"
    arguments = (command, path, *words, "-o", theirs, "--quiet", "--threads", 1)
    with start_program(*arguments) as running:  # beside the module
        case = case or stationary.Case.read(path)
        result, error = computed(call, case, threads=1, **options)
        _, text = running.communicate()
    if error is not None:
        assert text.endswith(f"stationary: {error}\n")
    if result is None:
        assert error is not None and not theirs.exists(), text
        return
    result.write(ours)
    assert ours.read_bytes() == theirs.read_bytes(), (command, path, running.returncode)
    assert lasting(ours) == lasting(theirs)


def with_keys(path, **keys):
    """The case with keys set (dots are two underscores), and the program's words for it."""
    values = {key.replace("__", "."): value for key, value in keys.items()}
    words = [word for key, value in values.items() for word in ("--set", f"{key}={value}")]
    return stationary.Case.read(path).set(values), words


def relative(path):
    return os.path.relpath(path, SOURCES)


def of(condition):
    return [pytest.param(relative(path), id=path.stem) for path in CASES if condition(path)]


def has(key):
    return lambda path: f"[{key}]" in path.read_text()


def test_there_are_cases():
    assert len(CASES) >= 28


@pytest.mark.parametrize("path", of(lambda path: True))
def test_solve(path, tmp_path):
    for suffix in SUFFIXES:
        compare("solve", stationary.solve, path, tmp_path, suffix=suffix)


@pytest.mark.parametrize("path", of(has("continuation")))
def test_follow(path, tmp_path):
    compare("continue", stationary.follow, path, tmp_path)


@pytest.mark.parametrize("path", of(has("map")))
def test_map(path, tmp_path):
    compare("map", stationary.map, path, tmp_path)
    case, words = with_keys(path, map__x__count=7, map__y__count=5)
    compare("map", stationary.map, path, tmp_path, words, case, SUFFIXES[-1])


# An atlas is of a range of nu.
@pytest.mark.parametrize("path", of(has("continuation")))
def test_atlas(path, tmp_path):
    words = ("--checkpoints", 2)
    compare("atlas", stationary.atlas, path, tmp_path, words, checkpoints=2)


@pytest.mark.parametrize("path", of(lambda path: True))
def test_study(path, tmp_path):
    table = tmp_path / "rows.csv"
    table.write_text("_name,body.J.0,motion.nu\none,1.25,\n\"two, of \"\"µ\"\"\",0.9,0.1\nwrong,-1,\n")
    task = "continue" if path == "cases/fold.toml" else "solve"
    words = ("--over", table, "--do", task)
    study = lambda case, **options: stationary.study(case, table, task, **options)
    compare("study", study, path, tmp_path, words)


def test_curve(tmp_path):
    path = "cases/circle.toml"
    keys = {
        "curve.event": "fold-nu", "curve.parameters": ["nu", "potential.plane.mu"],
        "curve.from": [0.0, 0.5], "curve.to": [2.5, 3.0], "curve.tolerance": 1e-6,
    }
    words = [
        word for key, value in keys.items()
        for word in ("--set", f"{key}={json.dumps(value, separators=(',', ':'))}")
    ]
    case = stationary.Case.read(path).set(keys)
    for suffix in SUFFIXES:
        compare("curve", stationary.curve, path, tmp_path, words, case, suffix)


@pytest.mark.skipif(not HDF5, reason="built without HDF5")
def test_as_hdf5(tmp_path):
    for suffix in (".h5", ".hdf5"):
        compare("continue", stationary.follow, "cases/fold.toml", tmp_path, suffix=suffix)


def test_with_keys_set(tmp_path):
    case = stationary.Case.read("cases/disc.toml").set("motion.nu", 0.3)
    case = case.set("body.J", [1.0, 1.5, 0.6]).set("output.columns", ["xi", "rho"])
    theirs, ours = tmp_path / "a.csv", tmp_path / "b.csv"
    options = ("motion.nu=0.3", "body.J=[1.0,1.5,0.6]", 'output.columns=["xi","rho"]')
    sets = [word for option in options for word in ("--set", option)]
    assert run_program("solve", "cases/disc.toml", *sets, "-o", theirs, "-q")[0] == 0
    stationary.solve(case).write(ours)
    assert ours.read_bytes() == theirs.read_bytes()
    assert lasting(ours) == lasting(theirs)


def test_from_a_row(tmp_path):
    table = tmp_path / "fold.csv"
    stationary.follow("cases/fold.toml").write(table)
    theirs, ours = tmp_path / "a.csv", tmp_path / "b.csv"
    assert (
        run_program("continue", "cases/fold.toml", "--from", f"{table}:tilt", "-o", theirs, "-q")[0]
        == 0
    )
    stationary.follow("cases/fold.toml", row=f"{table}:tilt").write(ours)
    assert ours.read_bytes() == theirs.read_bytes()
    assert lasting(ours) == lasting(theirs)


def test_does_not_replace_the_table_of_its_row(tmp_path):
    table = tmp_path / "fold.csv"
    stationary.follow("cases/fold.toml").write(table)
    before = table.read_bytes()
    row = f"{table}:tilt"
    named = stationary.Case.read("cases/fold.toml").set({"continuation.start_row": row})
    for found in (stationary.follow("cases/fold.toml", row=row), stationary.follow(named)):
        with pytest.raises(stationary.InputError, match="the table that it was computed from"):
            found.write(table)
    assert table.read_bytes() == before


def test_threads_change_no_byte(tmp_path):
    case = stationary.Case.read("cases/fibre_map.toml")
    case = case.set({"map.x.count": 12, "map.y.count": 10})
    for threads in (1, 4):
        stationary.map(case, threads=threads).write(tmp_path / f"{threads}.csv")
    assert (tmp_path / "1.csv").read_bytes() == (tmp_path / "4.csv").read_bytes()


def test_refuses_to_replace_the_case(tmp_path):
    path = tmp_path / "case.csv"
    path.write_text((SOURCES / "cases/disc.toml").read_text())
    result = stationary.solve(path)
    with pytest.raises(stationary.InputError, match="the case file"):
        result.write(path)


def test_a_full_disk():
    with pytest.raises(OSError, match="No space left"):
        stationary.solve("cases/disc.toml").write("/dev/full")


def test_refuses_other_suffixes(tmp_path):
    with pytest.raises(stationary.InputError, match="suffix") as error:
        stationary.solve("cases/disc.toml").write(tmp_path / "x.xlsx")
    assert error.value.option == f"-o {tmp_path / 'x.xlsx'}"
